// SPDX-License-Identifier: GPL-3.0-or-later
// Which arithmetic decides what, and that all that decide agree with GMP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geom/kernel2.hpp"
#include "points.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

using detail::orientation_polynomial;

Sign by_gmp(const Point2& a, const Point2& b, const Point2& c) {
    return orientation(to_rational(a), to_rational(b), to_rational(c));
}

TEST(OrientationTier, PointsInGeneralPositionNeedOnlyDoubles) {
    const CertifiedSign got = detail::orientation({0.1, 0.2}, {12.3, 0.7}, {3.4, 11.1});
    EXPECT_EQ(got, (CertifiedSign{Sign::positive, Tier::filter}));
}

TEST(OrientationTier, PointsOnAnAxisParallelLineNeedOnlyDoubles) {
    const CertifiedSign got = detail::orientation({0.1, 0.3}, {0.7, 0.3}, {1e300, 0.3});
    EXPECT_EQ(got, (CertifiedSign{Sign::zero, Tier::filter}));
}

TEST(OrientationTier, CollinearPointsWithShortCoordinatesNeedIntervals) {
    const CertifiedSign got = detail::orientation({1, 2}, {2, 4}, {5, 10});
    EXPECT_EQ(got, (CertifiedSign{Sign::zero, Tier::interval}));
}

TEST(OrientationTier, NearlyCollinearPointsNeedExactNumbers) {
    const Point2 a{0.5, 0.5}, b{12, 12}, c{24, std::nextafter(24.0, 25.0)};
    EXPECT_EQ(detail::orientation(a, b, c), (CertifiedSign{Sign::positive, Tier::exact}));
}

TEST(OrientationTier, OverflowingProductsFallThroughToExactNumbers) {
    const Point2 a{-1e300, -1e300}, b{1e300, 1e300}, c{0, 1e290};
    EXPECT_EQ(detail::orientation(a, b, c), (CertifiedSign{Sign::positive, Tier::exact}));
    EXPECT_EQ(detail::orientation(a, b, {0, 0}), (CertifiedSign{Sign::zero, Tier::exact}));
}

TEST(OrientationTier, UnderflowingProductsFallThroughToExactNumbers) {
    const double tiny = 0x1p-1074;
    EXPECT_EQ(detail::orientation({0, 0}, {tiny, 0}, {0, tiny}),
              (CertifiedSign{Sign::positive, Tier::exact}));
    EXPECT_EQ(detail::orientation({0, 0}, {tiny, 2 * tiny}, {3 * tiny, 6 * tiny}),
              (CertifiedSign{Sign::zero, Tier::exact}));
    EXPECT_EQ(detail::orientation({0, 0}, {2 * tiny, 3 * tiny}, {3 * tiny, 4 * tiny}),
              (CertifiedSign{Sign::negative, Tier::exact}));
}

// 9 differences of coordinates that are not doubles, so that all sixteen terms of the expansion
// matter, and a sum that is zero.
TEST(OrientationTier, InexactDifferencesAreSummedExactly) {
    const double x = 0x1.8p0 + 0x1p-49, w = x * 0x1p-10;
    const Point2 a{x, 3 * x}, b{w, 3 * w}, c{1024 * x, 3 * 1024 * x};
    ASSERT_EQ(by_gmp(a, b, c), Sign::zero);
    EXPECT_EQ(detail::orientation(a, b, c), (CertifiedSign{Sign::zero, Tier::exact}));
    const Point2 above{c.x, std::nextafter(c.y, 1e9)};
    EXPECT_EQ(detail::orientation(b, a, above).sign, by_gmp(b, a, above));
}

TEST(OrientationTier, EveryTierThatDecidesAgreesWithGmp) {
    int decided[4] = {};
    testing::for_hard_triples(1, 600, [&](const Point2& a, const Point2& b, const Point2& c) {
        const Sign expected = by_gmp(a, b, c);
        const auto polynomial = orientation_polynomial<double>(a, b, c);
        if (const auto sign = detail::filtered_sign(polynomial)) {
            ASSERT_EQ(*sign, expected);
        }
        if (const auto sign = detail::interval_sign(polynomial)) {
            ASSERT_EQ(*sign, expected);
        }
        ASSERT_EQ(detail::exact_sign(polynomial), expected) << a << b << c;
        const CertifiedSign got = detail::orientation(a, b, c);
        ASSERT_EQ(got.sign, expected) << a << b << c;
        ++decided[static_cast<int>(got.decided_by)];
    });
    EXPECT_GT(decided[0], 1000);
    EXPECT_GT(decided[1], 100);
    EXPECT_GT(decided[2], 1000);
    EXPECT_EQ(decided[3], 0);
}

TEST(OrientationTier, TheOneUlpNeighbourhoodOfADiagonalIsRight) {
    for (int i = -12; i <= 12; ++i) {
        for (int j = -12; j <= 12; ++j) {
            const Point2 p{testing::nudged(0.5, i), testing::nudged(0.5, j)};
            const Point2 a{12, 12}, b{24, 24};
            ASSERT_EQ(orientation(a, b, p), sign_of(j - i)) << p;
        }
    }
}

TEST(DotTier, EveryTierThatDecidesAgreesWithGmp) {
    testing::for_hard_triples(2, 300, [&](const Point2& a, const Point2& b, const Point2& c) {
        const Point2 left{-b.y, b.x};  // a right angle at the origin, nearly
        const auto polynomial = detail::dot_polynomial<double>({0, 0}, b, left, c);
        const Sign expected =
            -order_along(to_rational(Point2{0, 0}), to_rational(b), to_rational(left), to_rational(c));
        if (const auto sign = detail::filtered_sign(polynomial)) {
            ASSERT_EQ(*sign, expected);
        }
        ASSERT_EQ(detail::exact_sign(polynomial), expected);
        ASSERT_EQ(order_along(a, b, a, c),
                  order_along(to_rational(a), to_rational(b), to_rational(a), to_rational(c)));
    });
}

TEST(ErrorBoundedTier, DecidesOnlyWhatIsRight) {
    int decided = 0;
    testing::for_hard_triples(3, 300, [&](const Point2& a, const Point2& b, const Point2& c) {
        const auto sign = detail::homogeneous_orientation<detail::ErrorBounded>(a, b, c).sign();
        if (!sign) return;
        ++decided;
        ASSERT_EQ(*sign, by_gmp(a, b, c)) << a << b << c;
    });
    EXPECT_GT(decided, 1000);
}

TEST(PolicyTier, DoublesAreWrongWhereTheFilterAsksForMore) {
    const Point2 a{0.5, 0.5}, b{12, 12}, c{24, std::nextafter(24.0, 25.0)};
    int wrong = 0;
    for (int i = -12; i <= 12; ++i) {
        const Point2 p{testing::nudged(0.5, i), 0.5};
        wrong += Predicates2(Arithmetic::double_).orientation(p, b, c) != orientation(p, b, c);
    }
    EXPECT_GT(wrong, 0);
    EXPECT_EQ(Predicates2(Arithmetic::exact).orientation(a, b, c), Sign::positive);
}

TEST(PolicyTier, IntervalsTakeAnUndecidedSignAsZeroAndCountIt) {
    Tally tally;
    const Predicates2 predicates(Arithmetic::interval, &tally);
    const Point2 a{0.5, 0.5}, b{12, 12}, c{24, std::nextafter(24.0, 25.0)};
    EXPECT_EQ(predicates.orientation(a, b, c), Sign::zero);
    EXPECT_EQ(predicates.orientation(a, b, Point2{3, 7}), Sign::positive);
    EXPECT_EQ(tally[Predicate::orientation2],
              (TierCounts{.calls = 2, .interval = 1, .undecided = 1}));
}

TEST(PolicyTier, CallsAreCountedUnderTheTierThatDecides) {
    Tally tally;
    const Predicates2 filtered(Arithmetic::filtered, &tally);
    const Predicates2 exact(Arithmetic::exact, &tally);
    const Predicates2 doubles(Arithmetic::double_, &tally);
    EXPECT_EQ(filtered.orientation(Point2{0, 0}, Point2{1, 0}, Point2{0, 1}), Sign::positive);
    EXPECT_EQ(filtered.orientation(Point2{1, 2}, Point2{2, 4}, Point2{5, 10}), Sign::zero);
    EXPECT_EQ(exact.orientation(Point2{0, 0}, Point2{1, 0}, Point2{0, 1}), Sign::positive);
    EXPECT_EQ(doubles.orientation(Point2{0, 0}, Point2{1, 0}, Point2{0, 1}), Sign::positive);
    EXPECT_EQ(filtered.order_along({0, 0}, {1, 0}, {2, 5}, {3, 1}), Sign::negative);
    EXPECT_EQ(tally[Predicate::orientation2],
              (TierCounts{.calls = 4, .filter = 2, .interval = 1, .exact = 1}));
    EXPECT_EQ(tally[Predicate::order_along_line2], (TierCounts{.calls = 1, .filter = 1}));
    EXPECT_EQ(tally[Predicate::order_of_directions2], TierCounts{});
}

TEST(PolicyTier, FilteredAndExactGiveTheAnswerOfTheFreeFunctions) {
    const Predicates2 filtered(Arithmetic::filtered);
    const Predicates2 exact(Arithmetic::exact);
    testing::for_hard_triples(4, 60, [&](const Point2& a, const Point2& b, const Point2& c) {
        ASSERT_EQ(filtered.orientation(a, b, c), orientation(a, b, c));
        ASSERT_EQ(exact.orientation(a, b, c), orientation(a, b, c));
        ASSERT_EQ(exact.order_along(a, b, b, c), order_along(a, b, b, c));
        ASSERT_EQ(exact.crossing({a, b}, {b, c}), crossing({a, b}, {b, c}));
        if (a == b || a == c) return;
        ASSERT_EQ(exact.order_of_directions(a, b, b, c), order_of_directions(a, b, b, c));
        ASSERT_EQ(exact.cone_position(a, b, c, b), cone_position(a, b, c, b));
    });
}

}  // namespace
}  // namespace sightline
