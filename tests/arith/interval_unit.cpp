// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "arith/interval_cgal.hpp"

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Interval, KnowsWhatItHolds) {
    const Interval x{1, 2};
    EXPECT_TRUE(x.contains(1) && x.contains(2) && x.contains(1.5));
    EXPECT_FALSE(x.contains(0.999) || x.contains(2.001));
    EXPECT_TRUE(x.contains(Rational(4) / Rational(3)));
    EXPECT_FALSE(x.contains(Rational(7) / Rational(3)));
    EXPECT_TRUE((Interval{-infinity, infinity}).contains(Rational(7)));
    EXPECT_FALSE((Interval{infinity, infinity}).contains(Rational(7)));
    EXPECT_TRUE(x.contains(Interval{1, 1.5}));
    EXPECT_FALSE(x.contains(Interval{0, 1.5}));
    EXPECT_TRUE(x.overlaps({2, 3}));
    EXPECT_FALSE(x.overlaps({3, 4}));
}

TEST(Interval, HasASignWhenAllItsNumbersHaveIt) {
    EXPECT_EQ((Interval{1, 2}).sign(), Sign::positive);
    EXPECT_EQ((Interval{-2, -1}).sign(), Sign::negative);
    EXPECT_EQ((Interval{0, 0}).sign(), Sign::zero);
    EXPECT_EQ((Interval{0, 1}).sign(), std::nullopt);
    EXPECT_EQ((Interval{-1, 1}).sign(), std::nullopt);
}

TEST(Interval, HasAMiddleWithinItself) {
    EXPECT_EQ((Interval{1, 2}).approx_middle(), 1.5);
    EXPECT_EQ((Interval{0x1p-1074, 0x1p-1074}).approx_middle(), 0x1p-1074);
    EXPECT_EQ((Interval{-1.7e308, 1.7e308}).approx_middle(), 0);
    EXPECT_EQ((Interval{1, infinity}).approx_middle(), 1);
}

TEST(Enclosure, IsADoubleOrTwoNeighbours) {
    EXPECT_EQ(enclosure(Rational(0.1)), (Interval{0.1, 0.1}));
    const Rational tenth = Rational(1) / Rational(10);
    const Interval x = enclosure(tenth);
    EXPECT_TRUE(x.contains(tenth));
    EXPECT_EQ(x.upper, std::nextafter(x.lower, 1));
    EXPECT_EQ(enclosure(Rational(0x1p-1074) / 3), (Interval{0, 0x1p-1074}));
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(enclosure(Rational(largest) * 2), (Interval{largest, infinity}));
    EXPECT_EQ(enclosure(Rational(largest) * -2), (Interval{-infinity, -largest}));
}

TEST(Interval, PrintsItsEndsInFull) {
    std::ostringstream out;
    out << Interval{0.1, 2} << 0.1;
    EXPECT_EQ(out.str(), "[0.10000000000000001, 2]0.1");
}

// The middle tier underneath: every operation encloses the exact result, and the rounding mode is
// restored.
[[gnu::noinline]] Interval polynomial(double a, double b, double c) {
    const detail::RoundingUp scope;
    const detail::IntervalNumber y(b);
    const detail::IntervalNumber x = (a - y) * c + y * y;
    return {x.inf(), x.sup()};
}

TEST(IntervalTier, EnclosesTheExactValueAndRestoresRounding) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const double a = unit(random), b = std::ldexp(unit(random), i % 60 - 30), c = unit(random);
        const Rational exact =
            (Rational(a) - Rational(b)) * Rational(c) + Rational(b) * Rational(b);
        const Interval got = polynomial(a, b, c);
        ASSERT_TRUE(got.contains(exact));
        ASSERT_LT(got.upper - got.lower, 1e-14 * (1 + b * b + std::abs(b)));
    }
    const volatile double tenth = 0.1;
    EXPECT_EQ(tenth * 3, 0.30000000000000004) << "rounding to nearest again";
}

}  // namespace
}  // namespace sightline
