// SPDX-License-Identifier: GPL-3.0-or-later
// Critical lines, visual events, and which of these leave which of those; counted by hand.
#include "sightline/event/catalogue.hpp"

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "sightline/scene/families3.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::scene3;
using ::testing::SizeIs;

VertexId vertex_at(const Scene3& scene, const Point3& p) {
    for (std::uint32_t i = 0; i < scene.vertices().size(); ++i) {
        if (scene[VertexId{i}] == p) return VertexId{i};
    }
    throw std::invalid_argument("no vertex there");
}

EdgeId edge_at(const Scene3& scene, const Point3& p, const Point3& q) {
    for (std::uint32_t i = 0; i < scene.edges().size(); ++i) {
        const Edge3& e = scene[EdgeId{i}];
        const std::array ends{scene[e.source], scene[e.target]};
        if (ends == std::array{p, q} || ends == std::array{q, p}) return EdgeId{i};
    }
    throw std::invalid_argument("no edge there");
}

/// The face with all three points among its vertices.
FaceId face_at(const Scene3& scene, const std::array<Point3, 3>& points) {
    for (std::uint32_t i = 0; i < scene.faces().size(); ++i) {
        const auto& ring = scene[FaceId{i}].rings[0];
        const auto has = [&](const Point3& p) {
            return std::ranges::any_of(ring, [&](VertexId v) { return scene[v] == p; });
        };
        if (std::ranges::all_of(points, has)) return FaceId{i};
    }
    throw std::invalid_argument("no face there");
}

SurdLine3 line(const RationalPoint3& p, const RationalPoint3& q) {
    return scaled(to_surd(line_through(p, q)));
}

std::map<EventKind, int> kinds(const std::vector<EventFamily>& families) {
    std::map<EventKind, int> count;
    for (const EventFamily& f : families) ++count[f.kind];
    return count;
}

template <typename T>
std::string text(const T& value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

TEST(CriticalLines, AreNamedByTheirGenerators) {
    EXPECT_EQ(text(CriticalLine{VV{{1}, {2}}}), "VV v1 v2");
    EXPECT_EQ(text(CriticalLine{FvE{{3}, {1}, {2}}}), "FvE f3 v1 e2");
    EXPECT_EQ(text(CriticalLine{VEE{{1}, {EdgeId{2}, EdgeId{3}}}}), "VEE v1 e2 e3");
    EXPECT_EQ(text(CriticalLine{FF{{FaceId{1}, FaceId{4}}}}), "FF f1 f4");
    EXPECT_EQ(text(CriticalLine{FEE{{1}, {EdgeId{2}, EdgeId{3}}}}), "FEE f1 e2 e3");
    EXPECT_EQ(text(CriticalLine{EEEE{{EdgeId{1}, EdgeId{2}, EdgeId{3}, EdgeId{4}}}}),
              "EEEE e1 e2 e3 e4");
    EXPECT_EQ(text(VisualEvent{EV{{1}, {2}}}), "EV e1 v2");
    EXPECT_EQ(text(VisualEvent{EEE{{EdgeId{1}, EdgeId{2}, EdgeId{3}}}}), "EEE e1 e2 e3");
    EXPECT_EQ(text(VisualEvent{Fv{{1}, {2}}}), "Fv f1 v2");
    EXPECT_EQ(text(VisualEvent{FE{{1}, {2}}}), "FE f1 e2");
}

class TwoBoxes : public ::testing::Test {
protected:
    // A small box under a slab, nothing of the two aligned but directions.
    Scene3 scene = scene3("box 0 0 0, 2 2 2; box 1 -3 4, 3 7 5");
};

TEST_F(TwoBoxes, LinesOfEachKind) {
    const VertexId a = vertex_at(scene, {0, 0, 2});
    const VertexId b = vertex_at(scene, {1, -3, 4});
    EXPECT_THAT(lines_of(VV{a, b}, scene), ElementsAre(line({0, 0, 2}, {1, -3, 4})));
    EXPECT_THAT(lines_of(VV{a, a}, scene), IsEmpty());

    const EdgeId along_y = edge_at(scene, {1, -3, 4}, {1, 7, 4});
    const EdgeId along_x = edge_at(scene, {1, -3, 5}, {3, -3, 5});
    const EdgeId upright = edge_at(scene, {2, 2, 0}, {2, 2, 2});
    // Through (0, 0, 2), x = 1 at z = 4 and y = -3 at z = 5: (t, -2t, 2 + 2t).
    EXPECT_THAT(lines_of(VEE{a, {along_y, along_x}}, scene),
                ElementsAre(line({0, 0, 2}, {1, -2, 4})));
    EXPECT_THAT(lines_of(VEE{a, {along_y, edge_at(scene, {0, 0, 0}, {0, 2, 0})}}, scene),
                ElementsAre(line({0, 0, 2}, {0, 1, 2})))
        << "parallel to both";

    const FaceId top = face_at(scene, {{{0, 0, 2}, {2, 0, 2}, {2, 2, 2}}});
    const FaceId left = face_at(scene, {{{1, -3, 4}, {1, 7, 4}, {1, 7, 5}}});
    EXPECT_THAT(lines_of(FF{{top, left}}, scene), ElementsAre(line({1, 0, 2}, {1, 1, 2})));
    const FaceId bottom = face_at(scene, {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}});
    EXPECT_THAT(lines_of(FF{{top, bottom}}, scene), IsEmpty()) << "parallel planes";
    const EdgeId far_upright = edge_at(scene, {3, 7, 4}, {3, 7, 5});
    EXPECT_THAT(lines_of(FvE{top, a, far_upright}, scene), ElementsAre(line({0, 0, 2}, {3, 7, 2})));
    EXPECT_THAT(lines_of(FvE{top, b, far_upright}, scene), IsEmpty()) << "b is not in the plane";
    EXPECT_THAT(lines_of(FvE{top, a, along_x}, scene), IsEmpty()) << "parallel to the plane";
    EXPECT_THAT(lines_of(FEE{top, {upright, far_upright}}, scene),
                ElementsAre(line({2, 2, 2}, {3, 7, 2})));
    EXPECT_THAT(lines_of(EEEE{{upright, far_upright, along_x, along_y}}, scene), SizeIs(1))
        << "the two uprights lie in a plane, the other two meet it in points";
}

TEST_F(TwoBoxes, SwathsOfEachKind) {
    const VertexId a = vertex_at(scene, {0, 0, 2});
    const EdgeId along_y = edge_at(scene, {1, -3, 4}, {1, 7, 4});
    const FaceId top = face_at(scene, {{{0, 0, 2}, {2, 0, 2}, {2, 2, 2}}});
    const EdgeId upright = edge_at(scene, {3, 7, 4}, {3, 7, 5});
    const Plane3 level{{0, 0, 1}, 2};
    EXPECT_THAT(swaths_of(EV{along_y, a}, scene),
                ElementsAre(Swath::pencil({{0, 0, 2}, 1}, carrier(along_y, scene))));
    EXPECT_THAT(swaths_of(EV{edge_at(scene, {0, 0, 0}, {0, 0, 2}), a}, scene), IsEmpty());
    EXPECT_THAT(swaths_of(Fv{top, a}, scene), ElementsAre(Swath::pencil({{0, 0, 2}, 1}, level)));
    EXPECT_THAT(swaths_of(Fv{top, vertex_at(scene, {0, 0, 0})}, scene), IsEmpty());
    EXPECT_THAT(swaths_of(FE{top, upright}, scene),
                ElementsAre(Swath::pencil({{3, 7, 2}, 1}, level)));
    EXPECT_THAT(swaths_of(FE{top, along_y}, scene), IsEmpty());
    const EdgeId along_x = edge_at(scene, {0, 0, 2}, {2, 0, 2});
    const auto skew = swaths_of(EEE{{along_y, upright, along_x}}, scene);
    ASSERT_THAT(skew, SizeIs(1));
    EXPECT_EQ(skew[0].kind(), SwathKind::regulus);
}

TEST_F(TwoBoxes, EdgeIsMetInsideOrNot) {
    const EdgeId e = edge_at(scene, {0, 0, 2}, {2, 0, 2});
    EXPECT_TRUE(meets_inside(line({1, 0, 2}, {5, 6, 7}), e, scene));
    EXPECT_FALSE(meets_inside(line({2, 0, 2}, {5, 6, 7}), e, scene)) << "at its end";
    EXPECT_FALSE(meets_inside(line({3, 0, 2}, {5, 6, 7}), e, scene)) << "beyond its end";
    EXPECT_FALSE(meets_inside(line({1, 1, 2}, {5, 6, 7}), e, scene)) << "misses it";
    EXPECT_FALSE(meets_inside(line({0, 1, 2}, {2, 1, 2}), e, scene)) << "parallel";
    EXPECT_FALSE(meets_inside(line({0, 0, 2}, {2, 0, 2}), e, scene)) << "along it";
}

TEST(FamiliesAtANode, EdgeOfATetrahedronIsLeftInTheTwoFacesAndAcrossThem) {
    const Scene3 scene = scene3("hull 0 0 0, 4 0 0, 0 4 0, 0 0 4");
    const VertexId a = vertex_at(scene, {0, 0, 0}), b = vertex_at(scene, {4, 0, 0});
    const Support support{{a, b}, {}, {}};
    const auto families = families_at(line({0, 0, 0}, {4, 0, 0}), support, scene);
    // Through a: the two other edges at b, each in a face. The same through b.
    EXPECT_THAT(families, SizeIs(4));
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::fv, 4}}));
    for (const EventFamily& f : families) {
        EXPECT_THAT(f.vertices, SizeIs(1));
        EXPECT_THAT(f.faces, SizeIs(1));
        EXPECT_THAT(f.edges, SizeIs(1));
        EXPECT_EQ(f.swath.kind(), SwathKind::pencil);
    }
}

TEST(FamiliesAtANode, VertexAndVertexHaveTheirDegreesTogether) {
    // Two tetrahedra in general position: three edges at each vertex.
    const Scene3 scene =
        scene3("hull 0 0 0, 4 1 0, 0 4 1, 1 0 4; hull 20 3 5, 25 2 6, 22 7 4, 21 3 11");
    const VertexId a = vertex_at(scene, {4, 1, 0}), b = vertex_at(scene, {20, 3, 5});
    const auto families = families_at(line({4, 1, 0}, {20, 3, 5}), {{a, b}, {}, {}}, scene);
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::ev, 6}}));
    const auto at_a = std::ranges::count_if(families, [&](const EventFamily& f) {
        return f.vertices == std::vector{a} &&
               scene[f.edges.at(0)].body == scene[scene.edges_at(b)[0]].body;
    });
    EXPECT_EQ(at_a, 3);
}

TEST(FamiliesAtANode, VertexAndTwoEdgesHaveTwoPencilsAndOneRegulusForEachEdgeOfTheVertex) {
    const Scene3 scene = scene3(
        "hull 0 0 0, 4 1 0, 0 4 1, 1 0 4; hull 20 3 5, 25 2 6, 22 7 4, 21 3 11;"
        "hull 10 10 20, 13 9 21, 9 14 20, 11 11 26");
    const VertexId v = vertex_at(scene, {0, 0, 0});
    const EdgeId e = edge_at(scene, {20, 3, 5}, {21, 3, 11});
    const EdgeId f = edge_at(scene, {10, 10, 20}, {9, 14, 20});
    const auto lines = lines_of(VEE{v, {e, f}}, scene);
    ASSERT_THAT(lines, SizeIs(1));
    const auto families = families_at(lines[0], {{v}, {e, f}, {}}, scene);
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::ev, 2}, {EventKind::eee, 3}}));
}

TEST(FamiliesAtANode, FourEdgesHaveFourReguli) {
    const Scene3 scene = scene3(
        "sheet 0 0 0, 5 1 1, 3 9 0; sheet 7 0 1, 9 6 -2, 8 1 7;"
        "sheet 14 0 -4, 13 5 5, 15 9 8; sheet 20 -3 1, 22 8 2, 25 3 9");
    // Four edges in general position; on failure of having lines, other edges would have to be taken.
    std::vector<EdgeId> one_each;
    for (std::uint32_t i = 0; i < 4; ++i) one_each.push_back(EdgeId{3 * i});
    bool found = false;
    for (std::uint32_t pick = 0; pick < 81; ++pick) {
        std::array<EdgeId, 4> edges;
        for (std::uint32_t i = 0, rest = pick; i < 4; ++i, rest /= 3) {
            edges[i] = EdgeId{3 * i + rest % 3};
        }
        for (const SurdLine3& l : lines_of(EEEE{edges}, scene)) {
            found = true;
            const Support support{{}, {edges.begin(), edges.end()}, {}};
            const auto families = families_at(l, support, scene);
            ASSERT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::eee, 4}}));
            for (const EventFamily& f : families) {
                EXPECT_THAT(f.edges, SizeIs(3));
                EXPECT_TRUE(f.swath.is_regulus());
            }
        }
    }
    EXPECT_TRUE(found);
}

TEST(FamiliesAtANode, LineInAFaceHasOneOrTwoPencilsInIt) {
    // A plate and two posts that stand out of its plane on both sides, none of them aligned.
    const Scene3 scene = scene3(
        "sheet 0 0 0, 8 1 0, 1 9 0; sheet 20 3 -5, 21 4 6, 29 1 1; sheet -13 2 -4, -12 3 7, -20 8 "
        "1");
    const FaceId plate{0};
    const EdgeId post = edge_at(scene, {20, 3, -5}, {21, 4, 6});
    const EdgeId other = edge_at(scene, {-13, 2, -4}, {-12, 3, 7});
    const auto lines = lines_of(FEE{plate, {post, other}}, scene);
    ASSERT_THAT(lines, SizeIs(1));
    const EdgeId near_side = edge_at(scene, {0, 0, 0}, {1, 9, 0});
    const EdgeId far_side = edge_at(scene, {8, 1, 0}, {1, 9, 0});
    ASSERT_TRUE(meets_inside(lines[0], near_side, scene) &&
                meets_inside(lines[0], far_side, scene));
    Support support{{}, {near_side, far_side, post, other}, {}};
    std::ranges::sort(support.edges);
    EXPECT_EQ(kinds(families_at(lines[0], support, scene)),
              (std::map<EventKind, int>{{EventKind::fe, 2}, {EventKind::eee, 2}}));
    EXPECT_EQ(lines_of(support, scene), lines);

    // FvE: the line through a corner of the plate.
    const VertexId corner = vertex_at(scene, {1, 9, 0});
    const EdgeId opposite = edge_at(scene, {0, 0, 0}, {8, 1, 0});
    const auto through = lines_of(FvE{plate, corner, post}, scene);
    ASSERT_THAT(through, SizeIs(1));
    const Support at_corner{{corner}, {opposite, post}, {}};
    const auto families = families_at(through[0], at_corner, scene);
    EXPECT_EQ(kinds(families)[EventKind::fv], 1);
    EXPECT_EQ(kinds(families)[EventKind::ev], 1);
    EXPECT_EQ(kinds(families)[EventKind::fe], 1) << "whichever edge of the plate takes over";
}

TEST(FamiliesAtANode, LineOfTwoPlanesHasTwoPencilsInEach) {
    const Scene3 scene = scene3("sheet 0 0 0, 8 1 0, 1 9 0; sheet 23 4 -5, 23 6 5, 33 7 5");
    const auto lines = lines_of(FF{{FaceId{0}, FaceId{1}}}, scene);
    ASSERT_THAT(lines, SizeIs(1));
    Support support;
    for (std::uint32_t i = 0; i < scene.edges().size(); ++i) {
        if (meets_inside(lines[0], EdgeId{i}, scene)) support.edges.push_back(EdgeId{i});
    }
    ASSERT_THAT(support.edges, SizeIs(4)) << "it crosses both plates";
    const auto families = families_at(lines[0], support, scene);
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::fe, 4}}));
}

TEST(FamiliesDegenerate, DiagonalOfACubeIsLeftInItsFaceAndOutOfIt) {
    const Scene3 scene = scene3("box 0 0 0, 1 1 1");
    const VertexId a = vertex_at(scene, {0, 0, 1}), b = vertex_at(scene, {1, 1, 1});
    const auto families = families_at(line({0, 0, 1}, {1, 1, 1}), {{a, b}, {}, {}}, scene);
    // Round a: in the top, which both level edges at b stand for, and with the upright edge at b.
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::fv, 2}, {EventKind::ev, 2}}));
    for (const EventFamily& f : families) {
        EXPECT_THAT(f.edges, SizeIs(f.kind == EventKind::fv ? 2 : 1));
    }
}

TEST(FamiliesDegenerate, LineThroughManyCornersHasAPencilForEachEdgeDirectionAtThem) {
    // Four cubes in a row: a line along the front upper edges passes eight corners.
    const Scene3 scene =
        scene3("box 0 0 0, 1 1 1; box 2 0 0, 3 1 1; box 4 0 0, 5 1 1; box 6 0 0, 7 1 1");
    Support support;
    for (int x = 0; x < 8; ++x) {
        support.vertices.push_back(vertex_at(scene, {static_cast<double>(x), 0, 1}));
    }
    std::ranges::sort(support.vertices);
    const auto families = families_at(line({0, 0, 1}, {7, 0, 1}), support, scene);
    // Round each corner: in the top plane and in the front plane. Parallel to the line, nothing moves: that
    // would leave the edges' ends. Lines that keep three of the uprights or of the level edges stay in a plane
    // with two degrees of freedom.
    EXPECT_EQ(kinds(families), (std::map<EventKind, int>{{EventKind::fv, 16}}));
    for (const EventFamily& f : families) {
        EXPECT_THAT(f.vertices, SizeIs(1));
        EXPECT_THAT(f.edges, SizeIs(7)) << "one at each other corner";
        EXPECT_THAT(f.faces, SizeIs(4)) << "of the four cubes, all in one plane";
    }
}

}  // namespace
}  // namespace sightline
