// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_skeleton.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "sightline/event/critical_line.hpp"
#include "sightline/skeleton/build.hpp"
#include "sightline/skeleton/geometry.hpp"
#include "support/scenes3.hpp"
#include "viz/vector_math.hpp"

namespace sightline::viz {
namespace {

using detail::cross;
using detail::dot;
using detail::operator-;
using ::sightline::testing::scene3;
using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::SizeIs;

double length(const Position& v) { return std::sqrt(dot(v, v)); }

/// How far p is from the line through a and b.
double distance(const Position& p, const Position& a, const Position& b) {
    return length(cross(p - a, b - a)) / length(b - a);
}

Position position(const Point3& p) { return {p.x, p.y, p.z}; }

/// Volume of the tetrahedron of two pieces, over their lengths: zero when they meet.
double skewness(const LinePiece& piece, const Position& a, const Position& b) {
    const Position d = piece.to - piece.from;
    return dot(cross(d, b - a), a - piece.from) / (length(d) * length(b - a));
}

SurdLine3 line(const RationalPoint3& p, const RationalPoint3& q) {
    return to_surd(line_through(p, q));
}

const Box wide{{-10, -10, -10}, {10, 10, 10}};

TEST(ApproxPiece, WithoutEndsIsCutOffAtTheBox) {
    const Scene3 scene = scene3("box 0 0 0, 1 1 1");
    const auto piece = approx_piece(line({0, 0, 1}, {1, 0, 1}), {}, scene, wide);
    ASSERT_TRUE(piece);
    EXPECT_EQ(piece->from, (Position{-10, 0, 1}));
    EXPECT_EQ(piece->to, (Position{10, 0, 1}));
    EXPECT_FALSE(approx_piece(line({0, 0, 11}, {1, 0, 11}), {}, scene, wide));
}

TEST(ApproxPiece, RunsFromFaceToFace) {
    const Scene3 scene = scene3("box 0 0 0, 1 1 1; box 4 0 0, 5 1 1");
    const auto face_at = [&](double x) {
        for (std::uint32_t f = 0; f < scene.faces().size(); ++f) {
            const auto& plane = scene[FaceId{f}].plane;
            if (std::ranges::all_of(plane, [&](VertexId v) { return scene[v].x == x; })) {
                return SegmentEnd{{FaceId{f}, false}};
            }
        }
        throw std::invalid_argument("no such face");
    };
    const SurdLine3 through = line({0, 0, 0}, {8, 1, 1});
    const SegmentLabel both{{}, {face_at(1), face_at(4)}};
    const auto piece = approx_piece(through, both, scene, wide);
    ASSERT_TRUE(piece);
    EXPECT_NEAR(std::min(piece->from.x, piece->to.x), 1, 1e-12);
    EXPECT_NEAR(std::max(piece->from.x, piece->to.x), 4, 1e-12);
    // With one end, the features tell on which side of it the segment lies.
    for (std::uint32_t v = 0; v < scene.vertices().size(); ++v) {
        const Support support{{VertexId{v}}, {}, {}};
        const auto one = approx_piece(through, {support, {SegmentEnd{}, face_at(4)}}, scene, wide);
        ASSERT_TRUE(one);
        if (scene[VertexId{v}].x == 0) {
            EXPECT_EQ(std::min(one->from.x, one->to.x), -10);
        }
        if (scene[VertexId{v}].x == 5) {
            EXPECT_GT(std::max(one->from.x, one->to.x), 9.99);
        }
    }
}

class SkeletonOfThreeBodies : public ::testing::Test {
protected:
    Scene3 scene = scene3(
        "hull 0 0 0, 4 1 0, 0 4 1, 1 0 4; hull 20 3 5, 25 2 6, 22 7 4, 21 3 11;"
        "hull 10 10 20, 13 9 21, 9 14 20, 11 11 26; box 8 2 2, 11 3 9");
    VisibilitySkeleton skeleton = visibility_skeleton(scene);
    Box box = box_around(scene, 0.3);
};

TEST_F(SkeletonOfThreeBodies, LinesOfArcsMeetTheirGenerators) {
    std::size_t reguli = 0;
    for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
        const SkeletonArc& arc = skeleton[ArcId{a}];
        const RuledSurface surface = approx_surface(skeleton, ArcId{a}, scene, 7, box);
        ASSERT_THAT(surface.lines, ::testing::Not(IsEmpty())) << arc.label;
        if (arc.type == ArcType::eee && !surface.centre) ++reguli;
        for (const LinePiece& piece : surface.lines) {
            if (length(piece.to - piece.from) < 0.1) continue;
            for (const VertexId v : arc.label.support.vertices) {
                EXPECT_NEAR(distance(position(scene[v]), piece.from, piece.to), 0, 1e-8);
            }
            for (const EdgeId e : arc.label.support.edges) {
                EXPECT_NEAR(skewness(piece, position(scene[scene[e].source]),
                                     position(scene[scene[e].target])),
                            0, 1e-8);
            }
            if (surface.centre) {
                EXPECT_NEAR(distance(*surface.centre, piece.from, piece.to), 0, 1e-8)
                    << name_of(arc.type) << ' ' << arc.label << " between "
                    << skeleton[arc.nodes[0]].label << " and " << skeleton[arc.nodes[1]].label;
            }
        }
    }
    EXPECT_GT(reguli, 0u);
}

TEST_F(SkeletonOfThreeBodies, LinesStayOutOfTheBodies) {
    // No interior point of a drawn piece lies inside a tetrahedron or the box: in front of one face each time.
    for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
        const RuledSurface surface = approx_surface(skeleton, ArcId{a}, scene, 5, box);
        for (const LinePiece& piece : surface.lines) {
            for (const double t : {0.1, 0.37, 0.62, 0.9}) {
                const Position p{piece.from.x * (1 - t) + piece.to.x * t,
                                 piece.from.y * (1 - t) + piece.to.y * t,
                                 piece.from.z * (1 - t) + piece.to.z * t};
                std::vector<double> highest(scene.bodies().size(), -1e9);
                for (const Face3& face : scene.faces()) {
                    const auto& [u, v, w] = face.plane;
                    const Position o = position(scene[u]);
                    const Position n =
                        detail::unit(cross(position(scene[v]) - o, position(scene[w]) - o));
                    double& height = highest[face.body.index()];
                    height = std::max(height, dot(n, p - o));
                }
                for (const double height : highest) {
                    EXPECT_GT(height, -1e-8) << skeleton[ArcId{a}].label;
                }
            }
        }
    }
}

TEST_F(SkeletonOfThreeBodies, EveryTypeHasItsLayersAndEveryThingIsCounted) {
    const DrawList list = draw(scene, skeleton);
    std::size_t arcs = 0;
    std::size_t nodes = 0;
    for (const Layer& layer : list.layers) {
        if (layer.name.starts_with("arcs ")) {
            arcs += layer.count;
            EXPECT_GT(layer.style.fill_opacity, 0);
            EXPECT_LT(layer.style.fill_opacity, 1);
            for (const Polygon& p : layer.polygons) {
                EXPECT_EQ("arcs " + std::string(name_of(skeleton[ArcId{p.id}].type)), layer.name);
            }
        }
        if (layer.name.starts_with("nodes ")) {
            nodes += layer.count;
            EXPECT_EQ(layer.polylines.size(), layer.count);
        }
    }
    EXPECT_EQ(arcs, skeleton.arcs().size());
    EXPECT_EQ(nodes, skeleton.nodes().size());
    EXPECT_THAT(list.notes, IsEmpty());
}

TEST_F(SkeletonOfThreeBodies, FiltersDrawOnlyWhatIsNamed) {
    std::uint32_t eee = 0;
    while (skeleton[ArcId{eee}].type != ArcType::eee) ++eee;
    SkeletonDrawOptions options;
    options.arcs = std::vector{ArcId{eee}};
    const DrawList one = draw(scene, skeleton, options);
    EXPECT_EQ(one.find("arcs EEE")->count, 1u);
    EXPECT_EQ(one.find("arcs EV"), nullptr);
    std::vector<std::uint32_t> nodes;
    for (const Layer& layer : one.layers) {
        if (!layer.name.starts_with("nodes ")) continue;
        for (const Polyline& l : layer.polylines) nodes.push_back(l.id);
    }
    EXPECT_THAT(nodes, SizeIs(2));
    for (const NodeId n : skeleton[ArcId{eee}].nodes) EXPECT_THAT(nodes, Contains(n.value));

    options.nodes = std::vector<NodeId>{};
    const DrawList alone = draw(scene, skeleton, options);
    for (const Layer& layer : alone.layers) EXPECT_FALSE(layer.name.starts_with("nodes "));
}

TEST_F(SkeletonOfThreeBodies, SurfaceBeginsAndEndsWithTheNodesLines) {
    for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
        const RuledSurface surface = approx_surface(skeleton, ArcId{a}, scene, 3, box);
        ASSERT_FALSE(surface.lines.empty());
        const auto& nodes = skeleton[ArcId{a}].nodes;
        const std::array pieces{surface.lines.front(), surface.lines.back()};
        for (std::size_t i = 0; i < 2; ++i) {
            if (lines_of(skeleton[nodes[i]].label.support, scene).empty()) continue;
            const auto whole = approx_piece(plucker(scene, skeleton[nodes[i]]), {}, scene, box);
            ASSERT_TRUE(whole);
            EXPECT_NEAR(distance(pieces[i].from, whole->from, whole->to), 0, 1e-7)
                << skeleton[nodes[i]].label << " of " << skeleton[ArcId{a}].label;
            EXPECT_NEAR(distance(pieces[i].to, whole->from, whole->to), 0, 1e-7);
        }
    }
}

TEST(AddSurface, PencilIsTwoTrianglesALineAndAStripOtherwise) {
    const RuledSurface cross_at_origin{{{{-1, -1, 0}, {1, 1, 0}}, {{-1, 1, 0}, {1, -1, 0}}},
                                       Position{0, 0, 0}};
    Layer layer;
    add_surface(layer, cross_at_origin, 7);
    ASSERT_THAT(layer.polygons, SizeIs(2));
    for (const Polygon& p : layer.polygons) {
        EXPECT_EQ(p.id, 7u);
        EXPECT_THAT(p.outer, Contains(Position{0, 0, 0}));
    }
    Layer strip;
    add_surface(strip, {{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}}, {}}, 0);
    EXPECT_THAT(strip.polygons, SizeIs(2));
    Layer outline;
    add_outline(outline, {{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}}, {}}, 3);
    ASSERT_THAT(outline.polylines, SizeIs(1));
    EXPECT_EQ(outline.polylines[0].points.front(), outline.polylines[0].points.back());
    EXPECT_THAT(outline.polylines[0].points, SizeIs(5));
}

}  // namespace
}  // namespace sightline::viz
