// SPDX-License-Identifier: GPL-3.0-or-later
// Two references for the free segments of a line, which share no code: one cuts the line by its crossings
// and counts them, the other looks at the surroundings of a point of each piece.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "sightline/reference/free_segment3.hpp"
#include "sightline/reference/visibility_skeleton.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

std::vector<SegmentLabel> by_counting(const Scene3& scene, const SurdLine3& line) {
    std::vector<SegmentLabel> result;
    for (const auto& s : reference::maximal_free_segments(scene, line)) result.push_back(s.label);
    std::ranges::sort(result);
    return result;
}

std::vector<SegmentLabel> by_surroundings(const Scene3& scene, const SurdLine3& line) {
    auto result = reference::maximal_segments(scene, line);
    for (SegmentLabel& label : result) std::ranges::sort(label.ends);
    std::ranges::sort(result);
    return result;
}

void expect_same_on_lines_between_vertices(const Scene3& scene) {
    for (const Point3& p : scene.vertices()) {
        for (const Point3& q : scene.vertices()) {
            if (p <= q) continue;
            const SurdLine3 line = to_surd(line_through(to_rational(p), to_rational(q)));
            EXPECT_EQ(by_counting(scene, line), by_surroundings(scene, line)) << p << ' ' << q;
        }
    }
}

class MaximalFreeSegments : public ::testing::TestWithParam<const char*> {};

TEST_P(MaximalFreeSegments, AgreeOnLinesBetweenVertices) {
    expect_same_on_lines_between_vertices(testing::degenerate_scene3(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Corpus, MaximalFreeSegments,
                         ::testing::Values("notched_cube", "ring", "two_parallel_triangles",
                                           "touching_face", "touching_edge_crossing",
                                           "touching_partial_face", "touching_vertex_on_face",
                                           "checkerboard_2x2x1", "room_with_box_on_floor"),
                         [](const auto& test) { return std::string(test.param); });

RationalPoint3 lattice_point() {
    const auto half = [] { return Rational(*rc::gen::inRange(-2, 14), 2); };
    const Rational x = half();
    const Rational y = half();
    return {x, y, half()};
}

RC_GTEST_PROP(MaximalFreeSegmentsLaw, AgreeOnLatticeLines, (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    for (int i = 0; i < 10; ++i) {
        const RationalPoint3 p = lattice_point();
        const RationalPoint3 q = lattice_point();
        if (p == q) continue;
        const SurdLine3 line = to_surd(line_through(p, q));
        RC_ASSERT(by_counting(scene, line) == by_surroundings(scene, line));
    }
}

// Through a lattice point, in a plane that contains the direction (1, √2, 0) or so.
RC_GTEST_PROP(MaximalFreeSegmentsLaw, AgreeOnIrrationalLines, (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const Surd root = Surd::square_root(2);
    for (int i = 0; i < 5; ++i) {
        const RationalPoint3 p = lattice_point();
        const SurdVector3 from{p.x, p.y, p.z};
        const RationalPoint3 a = lattice_point();
        const RationalPoint3 b = lattice_point();
        const SurdVector3 d{a.x + root * Surd(b.x), a.y + root * Surd(b.y), a.z + root * Surd(b.z)};
        if (d.is_zero()) continue;
        const SurdLine3 line{d, cross(from, d)};
        RC_ASSERT(by_counting(scene, line) == by_surroundings(scene, line));
    }
}

/// Walls of zero thickness in all positions: sheets of two squares that meet on a line, beside a box.
TEST(MaximalFreeSegmentsDegenerate, SheetsThatMeetEachOtherAndABox) {
    for (const char* text :
         {"sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0; sheet 0 2 0, 4 2 0, 4 2 4, 0 2 4",  // T
          "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0; sheet 0 0 0, 4 0 0, 4 0 4, 0 0 4",  // V
          "box 0 0 -2, 4 4 0; sheet 1 2 0, 3 2 0, 3 2 4, 1 2 4",                 // on a body
          "box 0 0 -2, 4 4 0; sheet 0 0 0, 4 0 0, 4 0 4, 0 0 4",                 // on its edge
          "box 0 0 -2, 4 4 0; sheet 2 2 0, 4 2 3, 0 2 3",                        // on a point
          "box 0 0 -2, 4 4 0; sheet 4 0 0, 8 0 0, 8 4 0, 4 4 0"}) {              // beside it
        auto input = testing::scene_input3(text);
        const auto scene = Scene3::make(input);
        ASSERT_TRUE(scene.has_value()) << scene.error().message;
        SCOPED_TRACE(text);
        expect_same_on_lines_between_vertices(*scene);
        for (int x = -1; x < 6; ++x) {
            for (int y = -1; y < 6; ++y) {
                const RationalPoint3 p{x, y, -1};
                for (const RationalPoint3& q : {RationalPoint3{2, 2, 1}, RationalPoint3{2, 2, 0},
                                                RationalPoint3{2, 0, 2}, RationalPoint3{4, 2, 3}}) {
                    const SurdLine3 line = to_surd(line_through(p, q));
                    EXPECT_EQ(by_counting(*scene, line), by_surroundings(*scene, line)) << p << q;
                }
            }
        }
    }
}

}  // namespace
}  // namespace sightline
