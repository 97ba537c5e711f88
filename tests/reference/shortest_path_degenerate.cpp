// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths found by hand.
#include <gtest/gtest.h>

#include "sightline/arith/square_roots.hpp"
#include "sightline/reference/shortest_path.hpp"
#include "support/corpus.hpp"
#include "support/paths.hpp"

namespace sightline {
namespace {

using testing::degenerate_scene;
using testing::exact_point2;
using testing::scene2;

std::string path(const Scene2& scene, const std::string& from, const std::string& to) {
    const auto result = reference::shortest_path(scene, exact_point2(from), exact_point2(to));
    return result ? testing::to_string(*result) : name_of(result.error().code);
}

TEST(ReferencePath, goes_straight_where_it_can) {
    EXPECT_EQ(path(degenerate_scene("triangle"), "-1,0", "3,0"), "-1,0 3,0 ()");  // along an edge
    EXPECT_EQ(path(degenerate_scene("triangle"), "5,5", "5,5"), "5,5 ()");
    EXPECT_EQ(path(degenerate_scene("pinhole"), "-3,0", "3,0"), "-3,0 3,0 ()");
}

// Above and below the box are equally long; the least ids win. The length is 2 + 2√2.
TEST(ReferencePath, of_two_as_long_has_the_least_ids) {
    const Scene2 scene = scene2("0 0, 2 0, 2 2, 0 2");
    EXPECT_EQ(path(scene, "-1,1", "3,1"), "-1,1 0,0 2,0 3,1 (v0 v1)");
    const auto result = reference::shortest_path(scene, exact_point2("-1,1"), exact_point2("3,1"));
    const std::vector<Rational> expected{Rational(4), Rational(8)};
    EXPECT_EQ(compare_sums_of_square_roots(testing::squared_lengths(*result), expected).sign,
              Sign::zero);
    EXPECT_LE(result->length.lower, 4.8284271247461903);
    EXPECT_GE(result->length.upper, 4.8284271247461900);
}

// The point at 0,0 lies on the way; the path goes straight on there, and it is no vertex of it.
TEST(ReferencePath, does_not_stop_at_points_on_the_way) {
    EXPECT_EQ(path(scene2("point 0 0; 5 5, 6 5, 6 6"), "-1,0", "1,0"), "-1,0 1,0 ()");
}

// The tip of the V cannot be passed; round either end it is √5 + 1.
TEST(ReferencePath, does_not_cross_walls_at_their_corners) {
    EXPECT_EQ(path(degenerate_scene("wall_v"), "0,-1", "0,1"), "0,-1 -1,1 0,1 (v0)");
    EXPECT_EQ(path(degenerate_scene("wall_t"), "-1/2,1/2", "1/2,-1/2"),
              "-1/2,1/2 -1,0 1/2,-1/2 (v0)");
}

// Along the wall 0-1 the crossing wall is passed only where the path begins, or ends, in the wall; else
// the way leads round the end of the crossing wall.
TEST(ReferencePath, passes_a_crossing_in_a_wall_only_from_end_to_end) {
    const Scene2 scene = scene2("wall 0 0, 4 0; wall 2 -9, 2 9");
    EXPECT_EQ(path(scene, "0,0", "4,0"), "0,0 4,0 ()");
    EXPECT_EQ(path(scene, "0,0", "5,1"), "0,0 2,9 5,1 (v3)");
    EXPECT_EQ(path(scene, "-1,1", "4,0"), "-1,1 2,9 4,0 (v3)");
    EXPECT_EQ(path(scene, "-1,1", "5,1"), "-1,1 2,9 5,1 (v3)");
}

TEST(ReferencePath, does_not_leave_a_ring_of_walls) {
    EXPECT_EQ(path(degenerate_scene("wall_ring"), "2,1", "6,1"), "unreachable");
    EXPECT_EQ(path(degenerate_scene("wall_between_bodies"), "2,0", "2,1"),
              "2,0 0,0 0,1 2,1 (v0 v3)");
}

// Bent at the pinhole round the lower spike; the first leg, prolonged, would enter the upper body.
TEST(ReferencePath, turns_in_a_pinhole) {
    const Scene2 scene = scene2("0 0, 3 2, -3 2 | 0 0, -0.5 -3, 0.5 -3");
    EXPECT_EQ(path(scene, "-1,-1", "1,-1/2"), "-1,-1 0,0 1,-1/2 (v0)");
}

TEST(ReferencePath, has_no_end_inside) {
    EXPECT_EQ(path(degenerate_scene("triangle"), "1,1", "5,5"), "inside_body");
    EXPECT_EQ(path(degenerate_scene("world_alone"), "1,1", "5,5"), "outside_of_world");
}

}  // namespace
}  // namespace sightline
