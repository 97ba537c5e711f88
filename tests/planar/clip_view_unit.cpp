// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/clip_view.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

using testing::scene_input;

std::vector<ViewPoint> ring_of(const std::vector<Point2>& points) {
    std::vector<ViewPoint> ring;
    for (const Point2& p : points) ring.push_back({to_rational(p), false});
    return ring;
}

ViewPoint direction(const Rational& x, const Rational& y) { return {{x, y}, true}; }

RationalPoint2 at(const Rational& x, const Rational& y) { return {x, y}; }

const RationalBox2 unit_box{{-1, -1}, {1, 1}};

TEST(ClippedRing, KeepsWhatLiesInside) {
    const auto ring = ring_of({{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}});
    EXPECT_EQ(clipped_ring(at(0, 0), ring, unit_box), ring);
}

TEST(ClippedRing, IsTheBoxWhereNothingBoundsTheView) {
    const std::vector<ViewPoint> everything = {direction(1, 0), direction(0, 1), direction(-1, 0),
                                               direction(0, -1)};
    EXPECT_EQ(clipped_ring(at(0, 0), everything, unit_box),
              ring_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
    EXPECT_EQ(clipped_ring(at(1, 1), everything, unit_box),
              ring_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
}

TEST(ClippedRing, CutsAConeOfNearlyAHalfTurnBehindTheBox) {
    // Everything above two nearly opposite rays; the box's lower corners lie outside of the cone.
    const Rational slope(1, 1000);
    const std::vector<ViewPoint> cone = {
        {at(0, 0), false}, direction(1, slope), direction(-1, slope)};
    const std::vector<ViewPoint> expected = {{at(-1, slope), false},
                                             {at(0, 0), false},
                                             {at(1, slope), false},
                                             {at(1, 1), false},
                                             {at(-1, 1), false}};
    EXPECT_EQ(clipped_ring(at(0, 0), cone, unit_box), expected);
}

TEST(ClippedRing, CutsExactly) {
    const auto ring = ring_of({{-3, -3}, {3, -3}, {0, 3}});
    const std::vector<ViewPoint> expected = {
        {at(-1, -1), false}, {at(1, -1), false}, {at(1, 1), false}, {at(-1, 1), false}};
    EXPECT_EQ(clipped_ring(at(0, 0), ring, unit_box), expected);
    const auto slanted = ring_of({{-3, -3}, {3, -1}, {0, 3}});
    const auto cut = clipped_ring(at(0, 0), slanted, unit_box);
    EXPECT_EQ(cut,
              (std::vector<ViewPoint>{
                  {at(-1, -1), false}, {at(1, -1), false}, {at(1, 1), false}, {at(-1, 1), false}}));
    const RationalBox2 wide{{-5, -2}, {5, 5}};
    EXPECT_EQ(clipped_ring(at(0, 0), slanted, wide),
              (std::vector<ViewPoint>{{at(Rational(-5, 2), -2), false},
                                      {at(0, -2), false},
                                      {at(3, -1), false},
                                      {at(0, 3), false}}));
}

TEST(ClippedRing, DropsWhatMeetsTheBoxInItsBorderOnly) {
    // From a point on the lower side: one part above, one below that begins along the side.
    const auto ring = ring_of({{0, -1}, {0.5, -3}, {0.5, -1}, {0, -1}, {0.5, 0}, {-0.5, 0}});
    EXPECT_EQ(clipped_ring(at(0, -1), ring, unit_box), ring_of({{-0.5, 0}, {0, -1}, {0.5, 0}}));
    EXPECT_TRUE(clipped_ring(at(0, -1), ring_of({{0, -1}, {-1, -3}, {1, -3}}), unit_box).empty());
}

TEST(ClippedRing, RefusesABoxWithoutTheViewpoint) {
    EXPECT_THROW(clipped_ring(at(2, 0), ring_of({{0, 0}, {1, 0}, {0, 1}}), unit_box),
                 ContractViolation);
}

TEST(ClippedRing, IsTheViewInAWorldOfThatShape) {
    const Scene2 open =
        *Scene2::make(scene_input("polygon 1 1, 2 1, 2 3; polygon -3 0, -2 -1, -2 1"));
    const Scene2 closed = *Scene2::make(scene_input(
        "world; polygon -4 -4, 5 -4, 5 6, -4 6; hole 1 1, 2 1, 2 3; hole -3 0, -2 -1, -2 1"));
    const RationalBox2 box{{-4, -4}, {5, 6}};
    for (const RationalPoint2& q : {at(0, 0), at(Rational(-1, 3), 5), at(3, 2), at(-2, 1)}) {
        const auto seen = visibility_polygon(open, q);
        const auto expected = visibility_polygon(closed, q);
        ASSERT_TRUE(seen && expected);
        EXPECT_EQ(clipped_ring(q, exact_ring(open, *seen), box), exact_ring(closed, *expected));
    }
}

TEST(ClippedNeedle, EndsAtTheBox) {
    const std::pair<ViewPoint, ViewPoint> needle = {{at(Rational(1, 2), Rational(1, 4)), false},
                                                    direction(1, Rational(1, 2))};
    const auto cut = clipped_needle(at(0, 0), needle, unit_box);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->second, (ViewPoint{at(1, Rational(1, 2)), false}));
    EXPECT_FALSE(clipped_needle(at(0, 0), {{at(2, 1), false}, needle.second}, unit_box));
    EXPECT_FALSE(
        clipped_needle(at(0, 0), {{at(1, Rational(1, 2)), false}, needle.second}, unit_box));
}

}  // namespace
}  // namespace sightline
