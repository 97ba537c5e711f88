// SPDX-License-Identifier: GPL-3.0-or-later
// Which arithmetic decides what in space, and that all that decide agree with GMP.
#include <gtest/gtest.h>

#include "geom/polynomial_sign.hpp"
#include "geom/polynomials3.hpp"
#include "points3.hpp"
#include "sightline/geom/predicates3.hpp"

namespace sightline {
namespace {

CertifiedSign filtered(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return detail::polynomial_sign(Arithmetic::filtered, [&]<typename Number>() -> Number {
        return detail::orientation3_polynomial<Number>(a, b, c, d);
    });
}

TEST(Orientation3Tier, PointsInGeneralPositionNeedOnlyDoubles) {
    EXPECT_EQ(filtered({0.1, 0.2, 0.3}, {12.3, 0.7, 1}, {3.4, 11.1, 2}, {1, 1, 9}),
              (CertifiedSign{Sign::positive, Tier::filter}));
}

TEST(Orientation3Tier, CoplanarPointsWithShortCoordinatesNeedIntervals) {
    EXPECT_EQ(filtered({1, 2, 3}, {2, 4, 1}, {5, 1, 3}, {-1, 7, -1}),
              (CertifiedSign{Sign::zero, Tier::interval}));
}

TEST(Orientation3Tier, NearlyCoplanarPointsNeedExactNumbers) {
    const Point3 a{0.1, 0.2, 0.3}, b{12.7, 12.1, 12.9}, c{24.3, 1.1, 7.7};
    const Point3 d{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
    EXPECT_EQ(filtered(a, b, c, d).decided_by, Tier::exact);
}

TEST(Orientation3Tier, OverflowAndUnderflowFallThroughTheFilter) {
    const double huge = 1e200, tiny = 0x1p-1074;
    EXPECT_EQ(filtered({0, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}),
              (CertifiedSign{Sign::positive, Tier::interval}))
        << "more than the largest double is positive, too";
    EXPECT_EQ(filtered({0, 0, 0}, {huge, huge, 0}, {huge, 2 * huge, 0}, {huge, huge, 1}),
              (CertifiedSign{Sign::positive, Tier::exact}));
    EXPECT_EQ(filtered({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}),
              (CertifiedSign{Sign::positive, Tier::exact}));
}

TEST(Orientation3Tier, EveryTierThatDecidesAgreesWithGmp) {
    int decided[4] = {};
    const auto check = [&](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
        const auto polynomial = [&]<typename Number>() -> Number {
            return detail::orientation3_polynomial<Number>(a, b, c, d);
        };
        const Sign expected =
            orientation(to_rational(a), to_rational(b), to_rational(c), to_rational(d));
        if (const auto sign = detail::interval_sign_of(polynomial)) {
            ASSERT_EQ(*sign, expected);
        }
        const CertifiedSign got = filtered(a, b, c, d);
        ASSERT_EQ(got.sign, expected) << a << b << c << d;
        ++decided[static_cast<int>(got.decided_by)];
    };
    testing::for_hard_quadruples(1, 60, check);
    EXPECT_GT(decided[0], 100);
    EXPECT_GT(decided[2], 1000);
    EXPECT_EQ(decided[3], 0);
}

TEST(Policy3Tier, CallsAreCountedUnderTheTierThatDecides) {
    Tally tally;
    const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    EXPECT_EQ(Predicates3(Arithmetic::filtered, &tally).orientation(o, x, y, z), Sign::positive);
    EXPECT_EQ(Predicates3(Arithmetic::exact, &tally).orientation(o, x, y, z), Sign::positive);
    EXPECT_EQ(Predicates3(Arithmetic::interval, &tally).side_of_line(o, x, y, z), Sign::positive);
    EXPECT_EQ(Predicates3(Arithmetic::double_, &tally).line_plane(o, z, o, x, y),
              LinePlane::forward);
    EXPECT_EQ(tally[Predicate::orientation3], (TierCounts{.calls = 2, .filter = 1, .exact = 1}));
    EXPECT_EQ(tally[Predicate::side_of_line3], (TierCounts{.calls = 1, .interval = 1}));
    EXPECT_EQ(tally[Predicate::line_plane3], (TierCounts{.calls = 1, .filter = 1}));
}

TEST(Policy3Tier, DoublesAreWrongWhereTheFilterAsksForMore) {
    int wrong = 0;
    const Predicates3 doubles(Arithmetic::double_), exact(Arithmetic::exact);
    const auto check = [&](const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
        wrong += doubles.orientation(a, b, c, d) != orientation(a, b, c, d);
        ASSERT_EQ(exact.orientation(a, b, c, d), orientation(a, b, c, d));
    };
    testing::for_hard_quadruples(2, 20, check);
    EXPECT_GT(wrong, 100);
}

}  // namespace
}  // namespace sightline
