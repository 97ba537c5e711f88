// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate inputs, and the rule that each of them follows.
#include <gtest/gtest.h>

#include <vector>

#include "points.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

TEST(OrientationDegenerate, MinusZeroIsZero) {
    EXPECT_EQ(orientation(Point2{0.0, 0.0}, Point2{-0.0, 1}, Point2{0.0, -5}), Sign::zero);
    EXPECT_EQ(orientation(Point2{-0.0, -0.0}, Point2{0.0, 0.0}, Point2{3, 7}), Sign::zero);
}

TEST(OrientationDegenerate, TheLargestDoublesAreInRange) {
    const double big = std::numeric_limits<double>::max();
    EXPECT_EQ(orientation(Point2{-big, -big}, Point2{big, big}, Point2{0, 0}), Sign::zero);
    EXPECT_EQ(orientation(Point2{-big, -big}, Point2{big, big}, Point2{0, 0x1p-1074}),
              Sign::positive);
    EXPECT_EQ(orientation(Point2{-big, -big}, Point2{big, -big}, Point2{-big, big}),
              Sign::positive);
}

TEST(OrderOfDirectionsDegenerate, TheOppositeOfTheReferenceOpensTheSecondHalf) {
    const Point2 center{0, 0}, reference{1, 0};
    EXPECT_EQ(order_of_directions(center, reference, {-1, 0x1p-1074}, {-1, 0}), Sign::negative);
    EXPECT_EQ(order_of_directions(center, reference, {-1, 0}, {-1, -0x1p-1074}), Sign::negative);
    EXPECT_EQ(order_of_directions(center, reference, {-1, 0}, {-7, 0}), Sign::zero);
}

TEST(OrderOfDirectionsDegenerate, PointsOneBehindTheOtherAreEqual) {
    const Point2 center{0.1, 0.3}, reference{0.1, 5};
    EXPECT_EQ(order_of_directions(center, reference, {0.1, 0.4}, {0.1, 1e300}), Sign::zero);
    EXPECT_EQ(order_of_directions(center, reference, {0.1, 0.2}, {0.1, -1e300}), Sign::zero);
}

TEST(ConeDegenerate, AConeFromADirectionToItselfIsAFullTurn) {
    const Point2 apex{0, 0};
    EXPECT_EQ(cone_position(apex, {1, 1}, {3, 3}, {2, 2}), ConePosition::on_first);
    EXPECT_EQ(cone_position(apex, {1, 1}, {3, 3}, {-2, -2}), ConePosition::inside);
    EXPECT_EQ(cone_position(apex, {1, 1}, {3, 3}, {1, 0}), ConePosition::inside);
}

TEST(ConeDegenerate, AHalfTurnIsAConeLikeAnyOther) {
    const Point2 apex{0, 0};
    EXPECT_EQ(cone_position(apex, {1, 0}, {-1, 0}, {0, 1}), ConePosition::inside);
    EXPECT_EQ(cone_position(apex, {1, 0}, {-1, 0}, {0, -1}), ConePosition::outside);
    EXPECT_EQ(cone_position(apex, {1, 0}, {-1, 0}, {-9, 0}), ConePosition::on_second);
}

TEST(CrossingDegenerate, APointIsBothEndsOfItself) {
    const Segment2 point{{1, 1}, {1, 1}};
    EXPECT_EQ(crossing(point, {{0, 0}, {2, 2}}), SegmentCrossing::first_ends_inside_second);
    EXPECT_EQ(crossing({{0, 0}, {2, 2}}, point), SegmentCrossing::second_ends_inside_first);
    EXPECT_EQ(crossing(point, {{1, 1}, {2, 2}}), SegmentCrossing::end_to_end);
    EXPECT_EQ(crossing(point, point), SegmentCrossing::end_to_end);
    EXPECT_EQ(crossing(point, {{2, 2}, {3, 3}}), SegmentCrossing::none);
    EXPECT_EQ(crossing(point, {{0, 0}, {2, 3}}), SegmentCrossing::none);
}

TEST(CrossingDegenerate, SegmentsOnOneVerticalLineCompareByHeight) {
    EXPECT_EQ(crossing({{1, 0}, {1, 4}}, {{1, 3}, {1, 9}}), SegmentCrossing::overlap);
    EXPECT_EQ(crossing({{1, 0}, {1, 4}}, {{1, 4}, {1, 9}}), SegmentCrossing::end_to_end);
    EXPECT_EQ(crossing({{1, 0}, {1, 4}}, {{1, 5}, {1, 9}}), SegmentCrossing::none);
    EXPECT_EQ(crossing({{1, 0}, {1, 9}}, {{1, 5}, {1, 3}}), SegmentCrossing::overlap);
}

// Moves one end by an ulp over the other segment's line.
TEST(CrossingDegenerate, OneUlpDecidesBetweenTouchingAndCrossing) {
    const Segment2 s{{12, 12}, {24, 24}};
    const auto ending_at = [](double x) { return Segment2{{13, 20}, {x, 15}}; };
    EXPECT_EQ(crossing(s, ending_at(15)), SegmentCrossing::second_ends_inside_first);
    EXPECT_EQ(crossing(s, ending_at(testing::nudged(15, 1))), SegmentCrossing::proper);
    EXPECT_EQ(crossing(s, ending_at(testing::nudged(15, -1))), SegmentCrossing::none);
}

// All pairs of segments of the 3×3 grid against intersection by definition: sampled points are
// enough, since the meeting points of these segments have coordinates in (1/60) Z.
TEST(CrossingDegenerate, AllSegmentsOfTheSmallGridMeetAsTheirPointsDo) {
    std::vector<Point2> grid;
    for (int i = 0; i < 9; ++i) grid.push_back({60.0 * (i % 3), 60.0 * (i / 3)});
    const auto points_of = [](const Segment2& s) {
        std::vector<Point2> points;
        const int n = s.source == s.target ? 0 : 60;
        for (int k = 0; k <= n; ++k) {
            points.push_back({s.source.x + (s.target.x - s.source.x) / 60 * k,
                              s.source.y + (s.target.y - s.source.y) / 60 * k});
        }
        return points;
    };
    for (int i = 0; i < 81; ++i) {
        for (int j = 0; j < 81; ++j) {
            const Segment2 s{grid[i / 9], grid[i % 9]};
            const Segment2 t{grid[j / 9], grid[j % 9]};
            std::size_t common = 0;
            for (const Point2& p : points_of(s)) common += is_on(t, p) ? 1 : 0;
            const SegmentCrossing got = crossing(s, t);
            ASSERT_EQ(got == SegmentCrossing::none, common == 0) << i << ' ' << j;
            ASSERT_EQ(got == SegmentCrossing::overlap, common > 1) << i << ' ' << j;
        }
    }
}

}  // namespace
}  // namespace sightline
