// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/shortest_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sightline/scene/families.hpp"
#include "support/paths.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

using testing::scene2;

RationalPoint2 at(int x, int y) { return {Rational(x), Rational(y)}; }

TEST(ShortestPath, IsTheSegmentWhereNothingIsInTheWay) {
    const auto path = shortest_path(scene2("0 0, 1 0, 0 1"), at(3, 0), at(6, 4));
    ASSERT_TRUE(path);
    EXPECT_EQ(testing::to_string(*path), "3,0 6,4 ()");
    EXPECT_EQ(path->length, (Interval{5, 5})) << "an exact root is a point";
}

TEST(ShortestPath, TurnsAtTheCornersOfASquare) {
    const auto path = shortest_path(scene2("0 0, 4 0, 4 4, 0 4"), at(-1, 2), at(5, 2));
    ASSERT_TRUE(path);
    EXPECT_EQ(testing::to_string(*path), "-1,2 0,0 4,0 5,2 (v0 v1)")
        << "of two as long, the lesser ids";
    EXPECT_TRUE(path->length.contains(4 + 2 * std::sqrt(5.0)));
    EXPECT_LT(path->length.upper - path->length.lower, 1e-14);
}

TEST(ShortestPath, SaysThatAClosedRoomIsUnreachable) {
    const auto path = shortest_path(scene2("wall 0 0, 4 0, 4 4, 0 4, 0 0"), at(2, 2), at(9, 2));
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, Errc::unreachable);
}

TEST(ShortestPath, NamesTheBodyThatAnEndLiesIn) {
    const auto path = shortest_path(scene2("0 0, 4 0, 4 4, 0 4"), at(9, 9), at(2, 2));
    ASSERT_FALSE(path);
    EXPECT_EQ(path.error().code, Errc::inside_body);
}

TEST(ShortestPath, IsTheSameWithTwoThreads) {
    const std::vector<std::string> size{"2000"};
    const Scene2 scene = *Scene2::make(*families::generate2("dense", size, 5));
    Tally one;
    Tally two;
    const auto path =
        shortest_path(scene, at(0, 0), at(1000000, 1000000), {.threads = 1, .tally = &one});
    const auto other =
        shortest_path(scene, at(0, 0), at(1000000, 1000000), {.threads = 2, .tally = &two});
    ASSERT_TRUE(path && other);
    EXPECT_GT(path->vertices.size(), 3u);
    EXPECT_EQ(path->points, other->points);
    EXPECT_EQ(path->vertices, other->vertices);
    EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace sightline
