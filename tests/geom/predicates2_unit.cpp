// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/predicates2.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace sightline {
namespace {

TEST(Orientation, IsPositiveOnTheLeft) {
    const Point2 a{0, 0}, b{2, 1};
    EXPECT_EQ(orientation(a, b, Point2{0, 1}), Sign::positive);
    EXPECT_EQ(orientation(a, b, Point2{1, 0}), Sign::negative);
    EXPECT_EQ(orientation(a, b, Point2{4, 2}), Sign::zero);
}

TEST(Orientation, OfARationalPointSeesLessThanAnUlp) {
    const Point2 a{0, 0}, b{3, 1};
    const Rational third = Rational(1) / Rational(3);
    const Rational little = Rational(1) / *Rational::parse("1e200");
    EXPECT_EQ(orientation(a, b, RationalPoint2{1, third}), Sign::zero);
    EXPECT_EQ(orientation(a, b, RationalPoint2{1, third + little}), Sign::positive);
    EXPECT_EQ(orientation(a, b, RationalPoint2{1, third - little}), Sign::negative);
}

TEST(Orientation, OfARationalPointBeyondTheRangeOfDoubles) {
    const Point2 a{0, 0}, b{1, 1};
    const Rational huge = *Rational::parse("1e400");
    EXPECT_EQ(orientation(a, b, RationalPoint2{huge, huge}), Sign::zero);
    EXPECT_EQ(orientation(a, b, RationalPoint2{huge, huge + 1}), Sign::positive);
    EXPECT_EQ(orientation(a, b, RationalPoint2{-huge, huge}), Sign::positive);
}

TEST(OrderAlong, ComparesFeetOnTheLine) {
    const Point2 a{0, 0}, b{2, 2};
    EXPECT_EQ(order_along(a, b, {0, 1}, {3, 0}), Sign::negative);
    EXPECT_EQ(order_along(a, b, {3, 0}, {0, 1}), Sign::positive);
    EXPECT_EQ(order_along(a, b, {0, 1}, {1, 0}), Sign::zero);
}

TEST(OrderOfDirections, TurnsOnceRoundTheCenter) {
    const Point2 center{1, 1}, reference{2, 2};
    const Point2 turn[] = {{2, 2}, {1, 5}, {0, 1}, {0, 0}, {1, 0}, {9, 1}, {9, 2}};
    for (int i = 0; i < 7; ++i) {
        for (int j = 0; j < 7; ++j) {
            EXPECT_EQ(order_of_directions(center, reference, turn[i], turn[j]), sign_of(i - j))
                << turn[i] << turn[j];
        }
    }
}

TEST(OrderOfDirections, RoundARationalPoint) {
    const RationalPoint2 center{Rational(1) / Rational(3), Rational(1) / Rational(3)};
    const Point2 reference{3, 3};
    EXPECT_EQ(order_of_directions(center, reference, {1, 1}, {2, 2}), Sign::zero);
    EXPECT_EQ(order_of_directions(center, reference, {1, 1}, {0, 0}), Sign::negative);
    EXPECT_EQ(order_of_directions(center, reference, {0, 0}, {-1, -1}), Sign::zero);
    EXPECT_EQ(order_of_directions(center, reference, {0, 1}, {1, 0}), Sign::negative);
}

TEST(ConePosition, OfConvexAndReflexCones) {
    const Point2 apex{0, 0}, right{1, 0}, up{0, 1};
    EXPECT_EQ(cone_position(apex, right, up, {3, 3}), ConePosition::inside);
    EXPECT_EQ(cone_position(apex, right, up, {5, 0}), ConePosition::on_first);
    EXPECT_EQ(cone_position(apex, right, up, {0, 5}), ConePosition::on_second);
    EXPECT_EQ(cone_position(apex, right, up, {-1, 0}), ConePosition::outside);
    EXPECT_EQ(cone_position(apex, up, right, {-1, 0}), ConePosition::inside);
    EXPECT_EQ(cone_position(apex, up, right, {3, 3}), ConePosition::outside);
    EXPECT_TRUE(is_in_cone(apex, up, right, {-1, -1}));
    EXPECT_FALSE(is_in_cone(apex, up, right, {0, 1}));
}

TEST(ConePosition, RoundARationalApex) {
    const RationalPoint2 apex{Rational(1) / Rational(3), 0};
    EXPECT_EQ(cone_position(apex, {1, 0}, {1, 1}, {5, 0}), ConePosition::on_first);
    EXPECT_EQ(cone_position(apex, {1, 0}, {1, 1}, {3, 4}), ConePosition::on_second);
    EXPECT_EQ(cone_position(apex, {1, 0}, {1, 1}, {3, 3}), ConePosition::inside);
    EXPECT_EQ(cone_position(apex, {1, 0}, {1, 1}, {0, 0}), ConePosition::outside);
}

TEST(Crossing, NamesEveryWayToMeet) {
    const Segment2 s{{0, 0}, {4, 0}};
    EXPECT_EQ(crossing(s, {{2, -1}, {2, 1}}), SegmentCrossing::proper);
    EXPECT_EQ(crossing(s, {{2, 0}, {2, 1}}), SegmentCrossing::second_ends_inside_first);
    EXPECT_EQ(crossing({{2, 0}, {2, 1}}, s), SegmentCrossing::first_ends_inside_second);
    EXPECT_EQ(crossing(s, {{4, 0}, {5, 5}}), SegmentCrossing::end_to_end);
    EXPECT_EQ(crossing(s, {{4, 0}, {5, 0}}), SegmentCrossing::end_to_end);
    EXPECT_EQ(crossing(s, {{3, 0}, {5, 0}}), SegmentCrossing::overlap);
    EXPECT_EQ(crossing(s, {{5, 0}, {6, 0}}), SegmentCrossing::none);
    EXPECT_EQ(crossing(s, {{0, 1}, {4, 1}}), SegmentCrossing::none);
    EXPECT_EQ(crossing(s, {{2, 1}, {3, 5}}), SegmentCrossing::none);
}

TEST(IsOn, IncludesTheEnds) {
    const Segment2 s{{0, 0}, {3, 6}};
    EXPECT_TRUE(is_on(s, {0, 0}));
    EXPECT_TRUE(is_on(s, {1, 2}));
    EXPECT_FALSE(is_on(s, {4, 8}));
    EXPECT_FALSE(is_on(s, {1, 2.0000000000000004}));
}

TEST(Predicates2, PrintsItsAnswers) {
    std::ostringstream out;
    out << ConePosition::on_first << ' ' << SegmentCrossing::proper << ' ' << Sign::negative << ' '
        << CertifiedSign{Sign::zero, Tier::exact} << ' ' << Point2{0.1, -1e300} << ' '
        << RationalPoint2{Rational(1) / Rational(3), 2} << ' '
        << reversed(Segment2{{0, 0}, {1, 2}});
    EXPECT_EQ(out.str(),
              "on_first proper negative zero by exact (0.1, -1e+300) (1/3, 2) (1, 2)--(0, 0)");
}

}  // namespace
}  // namespace sightline
