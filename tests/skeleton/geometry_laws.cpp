// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sightline/event/critical_line.hpp"
#include "sightline/reference/free_segment3.hpp"
#include "sightline/skeleton/build.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

/// Scenes in which every node and arc is looked at.
const testing::Corpus3& scenes() {
    static const testing::Corpus3 scenes = [] {
        testing::Corpus3 all{
            {"two_tetrahedra", "family tetrahedra 2"},
            {"three_tetrahedra", "family tetrahedra 3"},
            {"two_boxes", "family boxes 2"},
            {"two_turned_boxes", "family boxes-turned 2"},
            {"two_polytopes", "family polytopes 2 12"},
            {"three_thin_triangles", "family triangles 3"},
            {"four_thin_triangles", "family triangles 4"},
        };
        for (const char* name : {"tetrahedron",
                                 "cube",
                                 "notched_cube",
                                 "ring",
                                 "triangle",
                                 "two_parallel_triangles",
                                 "two_triangles_in_a_plane",
                                 "box_on_table",
                                 "touching_edge",
                                 "touching_partial_edge",
                                 "touching_vertex_on_edge",
                                 "touching_edge_crossing",
                                 "touching_edge_on_face",
                                 "two_boxes_in_a_plane",
                                 "three_boxes_in_a_row",
                                 "vertex_in_a_face_plane",
                                 "edge_in_a_face_plane",
                                 "faces_in_a_plane",
                                 "edges_on_a_line",
                                 "room_with_box",
                                 "room_with_box_on_floor"}) {
            all[name] = testing::degenerate_scenes3().at(name);
        }
        return all;
    }();
    return scenes;
}

class GeometryOfEveryScene : public ::testing::TestWithParam<std::string> {
protected:
    GeometryOfEveryScene()
        : scene_(testing::scene3(scenes().at(GetParam()))),
          skeleton_(visibility_skeleton(scene_)),
          geometry_(scene_) {}

    SurdVector3 place(VertexId v) const { return to_surd(vector_to(to_rational(scene_[v]))); }
    bool has_label(const SurdLine3& line, const SegmentLabel& label) const {
        return std::ranges::any_of(reference::maximal_segments(scene_, line),
                                   [&](SegmentLabel found) {
                                       std::ranges::sort(found.ends);
                                       return found == label;
                                   });
    }

    Scene3 scene_;
    VisibilitySkeleton skeleton_;
    SkeletonGeometry geometry_;
};

TEST_P(GeometryOfEveryScene, LinesMeetAllSupportFeatures) {
    for (const SkeletonNode& node : skeleton_.nodes()) {
        const auto line = geometry_.line(node);
        ASSERT_TRUE(line) << node.label;
        EXPECT_TRUE(line->is_line());
        EXPECT_EQ(*line, scaled(*line));
        const Support& support = node.label.support;
        for (const VertexId v : support.vertices) EXPECT_TRUE(is_on(*line, place(v))) << node.label;
        for (const EdgeId e : support.edges) {
            EXPECT_TRUE(meets_inside(*line, e, scene_)) << node.label;
        }
        for (const EdgeId e : support.along) {
            EXPECT_TRUE(is_on(*line, place(scene_[e].source))) << node.label;
            EXPECT_TRUE(is_on(*line, place(scene_[e].target))) << node.label;
        }
    }
}

TEST_P(GeometryOfEveryScene, AMaximalFreeSegmentOfTheLineHasTheLabel) {
    const std::size_t step = 1 + skeleton_.nodes().size() / 40;  // by brute force
    for (std::size_t n = 0; n < skeleton_.nodes().size(); n += step) {
        const SkeletonNode& node = skeleton_.nodes()[n];
        const auto line = geometry_.line(node);
        ASSERT_TRUE(line);
        EXPECT_TRUE(has_label(*line, node.label)) << node.label << " on " << *line;
    }
}

TEST_P(GeometryOfEveryScene, AllChoicesOfGeneratorsGiveTheLine) {
    for (const SkeletonNode& node : skeleton_.nodes()) {
        const SurdLine3 line = plucker(scene_, node);
        const Support& s = node.label.support;
        const auto agrees = [&](const CriticalLine& generators) {
            const auto lines = lines_of(generators, scene_);
            // Lines that the generators leave but one of the other edges does not meet are not in question.
            if (lines.empty()) return;
            EXPECT_TRUE(std::ranges::find(lines, line) != lines.end()) << generators;
        };
        for (std::size_t i = 0; i < s.vertices.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) agrees(VV{s.vertices[j], s.vertices[i]});
            for (std::size_t j = 0; j < s.edges.size(); ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    agrees(VEE{s.vertices[i], {s.edges[k], s.edges[j]}});
                }
            }
        }
        if (!s.vertices.empty() || s.edges.size() > 6) continue;
        for (std::size_t i = 0; i < s.edges.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    for (std::size_t l = 0; l < k; ++l) {
                        agrees(EEEE{{s.edges[l], s.edges[k], s.edges[j], s.edges[i]}});
                    }
                }
            }
        }
    }
}

TEST_P(GeometryOfEveryScene, EndsLieInThePlanesOfTheirFaces) {
    for (const SkeletonNode& node : skeleton_.nodes()) {
        const auto segment = geometry_.segment(node);
        ASSERT_TRUE(segment) << node.label;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& end = segment->ends[i];
            EXPECT_EQ(end.is_infinite, node.label.ends[i].empty()) << node.label;
            if (end.is_infinite) {
                EXPECT_TRUE(cross(end.at, segment->line.d).is_zero());
                continue;
            }
            EXPECT_TRUE(is_on(segment->line, end.at));
            for (const FaceSide f : node.label.ends[i]) {
                const Plane3 plane = plane_of(f.face, scene_);
                EXPECT_EQ(dot(to_surd(plane.normal), end.at), Surd(plane.offset)) << node.label;
            }
        }
        // Everything that the segment touches lies between its ends.
        for (const VertexId v : node.label.support.vertices) {
            for (std::size_t i = 0; i < 2; ++i) {
                const SurdVector3 from = segment->ends[1 - i].at;
                if (segment->ends[1 - i].is_infinite) continue;
                const SurdVector3 towards =
                    segment->ends[i].is_infinite ? segment->ends[i].at : segment->ends[i].at - from;
                EXPECT_NE(dot(place(v) - from, towards).sign(), Sign::negative) << node.label;
            }
        }
    }
}

TEST_P(GeometryOfEveryScene, LinesOfAnArcHaveItsLabel) {
    const std::size_t step = 1 + skeleton_.arcs().size() / 40;
    for (std::uint32_t a = 0; a < skeleton_.arcs().size(); ++a) {
        const auto lines = geometry_.lines(skeleton_, ArcId{a}, 2);
        EXPECT_EQ(lines.size(), 2u) << skeleton_[ArcId{a}].label;
        if (a % step == 0) {  // by brute force
            EXPECT_TRUE(has_label(to_surd(lines.at(a / step % 2)), skeleton_[ArcId{a}].label))
                << skeleton_[ArcId{a}].label;
        }
        EXPECT_EQ(geometry_.approx_segments(skeleton_, ArcId{a}, 2).size(), 4u);
    }
}

TEST_P(GeometryOfEveryScene, GeneratorsFixTheFamilyOfAnArc) {
    for (std::uint32_t a = 0; a < skeleton_.arcs().size(); ++a) {
        const Support& support = skeleton_[ArcId{a}].label.support;
        const auto g = geometry_.generators(skeleton_, ArcId{a});
        ASSERT_TRUE(g) << skeleton_[ArcId{a}].label;
        if (2 * g->vertices.size() + g->edges.size() != 3) {
            // The plane of a contact behind an end does the rest.
            const auto& ends = skeleton_[ArcId{a}].label.ends;
            EXPECT_TRUE(ends[0].size() > 2 || ends[1].size() > 2) << skeleton_[ArcId{a}].label;
            continue;
        }
        EXPECT_TRUE(std::ranges::includes(support.vertices, g->vertices));
        EXPECT_TRUE(std::ranges::includes(support.edges, g->edges));
        std::vector<RationalPoint3> points;
        std::vector<RationalLine3> lines;
        for (const VertexId v : g->vertices) points.push_back(to_rational(scene_[v]));
        for (const EdgeId e : g->edges) lines.push_back(carrier(e, scene_));
        const auto families = families_meeting(points, lines);
        const SurdLine3 inner = to_surd(geometry_.lines(skeleton_, ArcId{a}, 1).at(0));
        const bool in_swath = std::ranges::any_of(
            families.swaths, [&](const Swath& swath) { return swath.contains(inner); });
        // Edges that cross leave a pencil besides the lines of their plane.
        const bool crosses = !g->edges.empty() && families.has_larger;
        EXPECT_TRUE(in_swath || crosses) << skeleton_[ArcId{a}].label;
    }
}

std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const auto& [name, text] : scenes()) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Small, GeometryOfEveryScene, ::testing::ValuesIn(names()),
                         [](const auto& one) { return one.param; });

TEST(Geometry, SegmentsOfALineAreToldApartByTheirEnds) {
    // Through the top corners of two boxes of one height: between them, and beyond.
    const Scene3 scene = testing::scene3("box 0 0 0, 1 1 1; box 3 0 0, 4 1 1");
    const auto skeleton = visibility_skeleton(scene);
    std::size_t infinite = 0;
    for (const SkeletonNode& node : skeleton.nodes()) {
        const auto s = approx_end_points(segment(scene, node));
        for (std::size_t i = 0; i < 2; ++i) {
            if (s.is_infinite[i]) {
                ++infinite;
                continue;
            }
            EXPECT_TRUE(std::abs(s.ends[i].x) <= 4 && std::abs(s.ends[i].y) <= 1 &&
                        std::abs(s.ends[i].z) <= 1)
                << "ends lie on the boxes";
        }
    }
    EXPECT_GT(infinite, 0u);
}

}  // namespace
}  // namespace sightline
