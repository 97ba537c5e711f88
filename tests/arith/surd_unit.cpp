// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/surd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Rational fraction(long n, long d) { return Rational(n) / Rational(d); }

TEST(Surd, FoldsRationalRootsIn) {
    EXPECT_EQ(Surd(1, 2, 9), Surd(7));
    EXPECT_TRUE(Surd(1, 2, fraction(9, 4)).is_rational());
    EXPECT_EQ(Surd(1, 2, fraction(9, 4)).rational_part(), Rational(4));
    EXPECT_EQ(Surd(1, 0, 5), Surd(1));
    EXPECT_EQ(Surd(1, 5, 0), Surd(1));
    EXPECT_EQ(Surd(1, 5, 0).radicand(), Rational(0));
}

TEST(Surd, HasOneFormWithACoefficientOfOne) {
    const Surd x(fraction(1, 2), -3, 5);
    EXPECT_EQ(x.rational_part(), fraction(1, 2));
    EXPECT_EQ(x.root_sign(), Sign::negative);
    EXPECT_EQ(x.radicand(), Rational(45));
    EXPECT_EQ(x, Surd(fraction(1, 2), -1, 45));
    EXPECT_NE(x, x.conjugate());
    EXPECT_EQ(x.conjugate(), Surd(fraction(1, 2), 1, 45));
    EXPECT_NE(Surd(0, 1, 2), Surd(0, 1, 3));
}

TEST(Surd, RefusesRootsOfNegativeNumbersAndDivisionByZero) {
    EXPECT_THROW((void)Surd(0, 1, -1), std::domain_error);
    EXPECT_THROW((void)Surd(0, 0, -1), std::domain_error);
    EXPECT_THROW((void)(Surd(0, 1, 2) / Surd(0)), std::domain_error);
    EXPECT_THROW((void)sign_of_sum(0, 1, -2, 1, 3), std::domain_error);
    EXPECT_THROW((void)sign_of_sum(0, 1, 2, 1, -3), std::domain_error);
}

TEST(Surd, ComputesWithinOneFieldOnly) {
    const Surd x(1, 1, 2);
    EXPECT_EQ(x + Surd(0, 1, 8), Surd(1, 3, 2)) << "√8 = 2√2";
    EXPECT_EQ(x * Surd(0, 1, 8), Surd(4, 2, 2));
    EXPECT_EQ(x - x, Surd(0));
    EXPECT_TRUE((x - Surd(0, 1, 2)).is_rational());
    EXPECT_EQ(x * x.conjugate(), Surd(-1));
    EXPECT_EQ(Surd(1) / x, Surd(-1, 1, 2));
    EXPECT_EQ(Surd(2) * x + Rational(3), Surd(5, 2, 2));
    EXPECT_THROW((void)(x + Surd(0, 1, 3)), std::domain_error);
    EXPECT_THROW((void)(x * Surd(0, 1, 3)), std::domain_error);
}

TEST(Surd, AnyNumberMayJoinAFieldOnceItIsRational) {
    Surd x(1, 1, 2);
    x -= Surd(0, 1, 2);
    EXPECT_EQ(x + Surd(0, 1, 3), Surd(1, 1, 3));
}

TEST(Surd, SignsNeedNoRoundedRoots) {
    EXPECT_EQ(Surd(-1, 1, 2).sign(), Sign::positive);
    EXPECT_EQ(Surd(-2, 1, 2).sign(), Sign::negative);
    EXPECT_EQ(Surd(2, -1, 2).sign(), Sign::positive);
    EXPECT_EQ(Surd(-1, -1, 2).sign(), Sign::negative);
    // 1607521/1136689 is a convergent of √2: it errs by 3e-13.
    const Rational p = Rational(1607521), q = Rational(1136689);
    EXPECT_EQ(Surd(p, -q, 2).sign(), Sign::negative);
    EXPECT_EQ(Surd(-p, q, 2).sign(), Sign::positive);
}

TEST(Surd, ComparesNumbersOfTwoFields) {
    EXPECT_LT(Surd(0, 1, 2), Surd(0, 1, 3));
    EXPECT_GT(Surd(1, 1, 2), Surd(0, 1, 5)) << "2.414 and 2.236";
    EXPECT_LT(Surd(1, 1, 2), Surd(0, 1, 6)) << "2.414 and 2.449";
    EXPECT_EQ(sign_of_sum(0, 1, 2, -1, 2), Sign::zero);
    EXPECT_EQ(sign_of_sum(0, 2, 2, -1, 8), Sign::zero);
    EXPECT_EQ(sign_of_sum(-2, 1, 4, 0, 7), Sign::zero) << "radicands may be squares";
    EXPECT_EQ(sign_of_sum(-5, 1, 4, 1, 9), Sign::zero);
}

// √(n) + √(n + 2) against 2√(n + 1): they differ by about n^(-3/2) / 4, beyond doubles for n = 2^60.
TEST(Surd, ComparesWhatDoublesCannotTellApart) {
    const Rational n = Rational(1L << 60) + 3;
    const Surd left(0, 1, n * (n + 2));  // (√n + √(n+2))² = 2n + 2 + 2√(n(n+2)) < 4(n + 1)
    EXPECT_LT(Surd(2 * n + 2) + Surd(2) * left, Surd(4 * n + 4));
    EXPECT_LT(Surd(1, 1, n), Surd(1, 1, n + fraction(1, 1L << 62)));
    EXPECT_EQ(Surd(1, 1, n).approx_double(), Surd(1, 1, n + fraction(1, 1L << 62)).approx_double());
}

TEST(Surd, WritesAndReadsItself) {
    for (const auto& [x, text] : {std::pair{Surd(fraction(1, 2), -3, 5), "1/2-sqrt(45)"},
                                  {Surd(-1, 1, fraction(2, 3)), "-1+sqrt(2/3)"},
                                  {Surd(0, 1, 2), "sqrt(2)"},
                                  {Surd(0, -1, 2), "-sqrt(2)"},
                                  {Surd(fraction(-7, 2)), "-7/2"},
                                  {Surd(), "0"}}) {
        EXPECT_EQ(x.to_string(), text);
        EXPECT_EQ(Surd::parse(text), x);
        std::ostringstream out;
        out << x;
        EXPECT_EQ(out.str(), text);
    }
    for (const char* text : {"", "sqrt()", "sqrt(2", "1sqrt(2)", "sqrt(-2)", "1++sqrt(2)",
                             "1+sqrt(2)+1", "2*sqrt(2)", "sqrt(2)sqrt(2)"}) {
        EXPECT_EQ(Surd::parse(text), std::nullopt) << text;
    }
}

TEST(SurdEnclosure, IsTheSmallest) {
    EXPECT_EQ(enclosure(Surd(3)), (Interval{3, 3}));
    const Interval root = enclosure(Surd(0, 1, 2));
    EXPECT_EQ(std::nextafter(root.lower, 2.0), root.upper);
    EXPECT_LT(Surd(Rational(root.lower)), Surd(0, 1, 2));
    EXPECT_GT(Surd(Rational(root.upper)), Surd(0, 1, 2));
}

// a and b√c agree to hundreds of bits, so that the first precision cannot show the sign.
TEST(SurdEnclosure, SurvivesCancellation) {
    Surd power(1);
    for (int i = 0; i < 400; ++i) power *= Surd(-1, 1, 2);  // (√2 - 1)^400 = 8e-154
    EXPECT_EQ(power.sign(), Sign::positive);
    const Interval box = enclosure(power);
    EXPECT_EQ(std::nextafter(box.lower, 1.0), box.upper);
    EXPECT_NEAR(power.approx_double() / std::pow(std::sqrt(2.0) - 1, 400), 1, 1e-12);
    for (int i = 0; i < 500; ++i) power *= Surd(-1, 1, 2);  // 3e-345: below the denormals
    EXPECT_EQ(enclosure(power), (Interval{0, 0x1p-1074}));
    EXPECT_EQ(power.approx_double(), 0);
}

TEST(SurdEnclosure, EndsBeyondTheDoublesAreInfinite) {
    const Rational large = Rational(std::numeric_limits<double>::max());
    const Surd x(large, 1, 2);
    EXPECT_EQ(enclosure(x), (Interval{std::numeric_limits<double>::max(), infinity}));
    EXPECT_EQ(x.approx_double(), std::numeric_limits<double>::max());
    EXPECT_EQ((-x).approx_double(), -std::numeric_limits<double>::max());
    EXPECT_EQ((x * Surd(2)).approx_double(), infinity);
    EXPECT_EQ((x * Surd(-2)).approx_double(), -infinity);
}

}  // namespace
}  // namespace sightline
