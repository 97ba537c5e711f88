// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/rational.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <unordered_set>
#include <vector>

namespace sightline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double tiniest = 0x1p-1074;

Rational fraction(long n, long d) { return Rational(n) / Rational(d); }

// 2^exponent, exactly.
Rational power_of_two(int exponent) {
    Rational result(1);
    for (int i = 0; i < std::abs(exponent); ++i) result *= 2;
    return exponent < 0 ? 1 / result : result;
}

TEST(Rational, IsInLowestTermsWithAPositiveDenominator) {
    EXPECT_EQ(fraction(6, -4).to_string(), "-3/2");
    EXPECT_EQ(fraction(-6, -4).numerator(), "3");
    EXPECT_EQ(fraction(-6, -4).denominator(), "2");
    EXPECT_EQ(fraction(8, 4).to_string(), "2");
    EXPECT_EQ(Rational().to_string(), "0");
    EXPECT_EQ(numerator_of(fraction(6, -4)), Rational(-3));
    EXPECT_EQ(denominator_of(fraction(6, -4)), Rational(2));
}

TEST(Rational, HoldsEveryIntegerType) {
    EXPECT_EQ(Rational(std::numeric_limits<long>::min()).to_string(), "-9223372036854775808");
    EXPECT_EQ(Rational(std::numeric_limits<unsigned long>::max()).to_string(),
              "18446744073709551615");
    EXPECT_EQ(Rational(std::int8_t{-5}), Rational(-5));
    EXPECT_EQ(Rational(std::size_t{7}), Rational(7));
}

TEST(Rational, HoldsDoublesExactly) {
    EXPECT_EQ(Rational(0.1).to_string(), "3602879701896397/36028797018963968");
    EXPECT_EQ(Rational(tiniest), power_of_two(-1074));
    EXPECT_EQ(Rational(-0.0), Rational(0));
    EXPECT_EQ(Rational(0x1p1000), power_of_two(1000));
}

TEST(Rational, RefusesWhatIsNotANumber) {
    EXPECT_THROW((void)Rational(infinity), std::domain_error);
    EXPECT_THROW((void)Rational(std::nan("")), std::domain_error);
    EXPECT_THROW((void)(Rational(1) / Rational(0)), std::domain_error);
    EXPECT_THROW((void)(Rational(0) / Rational(0)), std::domain_error);
}

TEST(Rational, ADivisionByZeroLeavesItsOperandAsItWas) {
    Rational x(3);
    EXPECT_THROW(x /= Rational(0), std::domain_error);
    EXPECT_EQ(x, Rational(3));
}

TEST(Rational, ReadsIntegersFractionsAndDecimalsExactly) {
    EXPECT_EQ(Rational::parse("3"), Rational(3));
    EXPECT_EQ(Rational::parse("-7/2"), fraction(-7, 2));
    EXPECT_EQ(Rational::parse("+14/4"), fraction(7, 2));
    EXPECT_EQ(Rational::parse("1.25"), fraction(5, 4));
    EXPECT_EQ(Rational::parse("-.5"), fraction(-1, 2));
    EXPECT_EQ(Rational::parse("5."), Rational(5));
    EXPECT_EQ(Rational::parse("1e-3"), fraction(1, 1000));
    EXPECT_EQ(Rational::parse("-2.5E+2"), Rational(-250));
    EXPECT_EQ(Rational::parse("0.1"), fraction(1, 10));
    EXPECT_NE(Rational::parse("0.1"), Rational(0.1));
    EXPECT_EQ(Rational::parse("000"), Rational(0));
    EXPECT_EQ(Rational::parse("010"), Rational(10)) << "no octal";
    EXPECT_EQ(Rational::parse("0e9"), Rational(0));
    EXPECT_EQ(Rational::parse("-0"), Rational(0));
    EXPECT_EQ(Rational::parse("123456789012345678901234567890")->numerator(),
              "123456789012345678901234567890");
}

TEST(Rational, ReadsNothingElse) {
    for (const char* text :
         {"",    "-",    "+",     ".",     "e5",    "1e",    "1e+", "1/",   "/2",
          "1/0", "1/-2", "1.5/2", "1/2.5", "1 ",    " 1",    "1,5", "0x10", "1e5/2",
          "--1", "nan",  "inf",   "1_000", "1e1.5", "1/2/3", "1..2"}) {
        EXPECT_EQ(Rational::parse(text), std::nullopt) << '"' << text << '"';
    }
    EXPECT_EQ(Rational::parse(std::string_view("1\0002", 3)), std::nullopt);
}

TEST(Rational, AShortTextCannotAskForALargeNumber) {
    EXPECT_EQ(Rational::parse("1e999999999"), std::nullopt);
    EXPECT_EQ(Rational::parse("1e-999999999"), std::nullopt);
    EXPECT_EQ(Rational::parse("1e99999999999999999999999999"), std::nullopt);
    EXPECT_EQ(Rational::parse("1e1101"), std::nullopt);
    EXPECT_EQ(Rational::parse("1e1100")->numerator().size(), 1101u);
}

TEST(Rational, MovedFromIsZeroAndUsable) {
    Rational x = fraction(1, 3);
    const Rational y = std::move(x);
    EXPECT_EQ(y, fraction(1, 3));
    EXPECT_EQ(x, Rational(0));  // NOLINT(bugprone-use-after-move): that is the promise
    x += 5;
    EXPECT_EQ(x, Rational(5));
    Rational z(7);
    z = std::move(x);
    EXPECT_EQ(z, Rational(5));
}

TEST(Rational, AssignsToItself) {
    Rational x = fraction(1, 3);
    const Rational& alias = x;
    x = alias;
    EXPECT_EQ(x, fraction(1, 3));
    x += x;
    EXPECT_EQ(x, fraction(2, 3));
    x -= x;
    EXPECT_EQ(x, Rational());
}

TEST(Rational, OrdersAndTakesSigns) {
    EXPECT_LT(fraction(1, 3), fraction(1, 2));
    EXPECT_LT(fraction(-1, 2), fraction(-1, 3));
    EXPECT_EQ(fraction(-1, 3).sign(), Sign::negative);
    EXPECT_EQ(Rational().sign(), Sign::zero);
    EXPECT_EQ(sign_of(fraction(1, 3)), Sign::positive);
    EXPECT_EQ(abs(fraction(-1, 3)), fraction(1, 3));
    EXPECT_EQ(-Rational(), Rational());
    EXPECT_TRUE(Rational(4).is_integer());
    EXPECT_FALSE(fraction(4, 3).is_integer());
}

TEST(Rational, HashesByValue) {
    EXPECT_EQ(fraction(2, 4).hash(), fraction(1, 2).hash());
    EXPECT_EQ((Rational(3) - Rational(3)).hash(), Rational().hash());
    std::unordered_set<Rational> all;
    std::unordered_set<std::size_t> hashes;
    for (int n = -20; n <= 20; ++n) {
        for (int d = 1; d <= 20; ++d) {
            all.insert(fraction(n, d));
            hashes.insert(fraction(n, d).hash());
        }
    }
    EXPECT_EQ(all.size(), hashes.size());
    EXPECT_TRUE(all.contains(fraction(10, -14)));
}

TEST(Rational, HasRationalSquareRootsOfSquaresOnly) {
    EXPECT_EQ(rational_square_root(fraction(8, 18)), fraction(2, 3));
    EXPECT_EQ(rational_square_root(Rational(0)), Rational(0));
    EXPECT_EQ(rational_square_root(Rational(2)), std::nullopt);
    EXPECT_EQ(rational_square_root(fraction(4, 3)), std::nullopt);
    EXPECT_EQ(rational_square_root(Rational(-4)), std::nullopt);
}

TEST(ApproxDouble, TiesGoToEven) {
    const Rational ulp = power_of_two(-52);
    EXPECT_EQ((1 + ulp / 2).approx_double(), 1.0);
    EXPECT_EQ((1 + ulp * 3 / 2).approx_double(), 1 + 2 * 0x1p-52);
    EXPECT_EQ((1 + ulp / 2 + power_of_two(-300)).approx_double(), 1 + 0x1p-52);
    EXPECT_EQ((-1 - ulp / 2 - power_of_two(-300)).approx_double(), -1 - 0x1p-52);
    EXPECT_EQ((1 + ulp / 2 - power_of_two(-300)).approx_double(), 1.0);
    EXPECT_EQ((2 - ulp / 4).approx_double(), 2.0) << "the mantissa overflows";
}

TEST(ApproxDouble, RoundsDenormalsOnce) {
    const Rational unit = power_of_two(-1074);
    EXPECT_EQ((unit / 2).approx_double(), 0.0);
    EXPECT_EQ((unit * 3 / 4).approx_double(), tiniest);
    EXPECT_EQ((unit / 2 + power_of_two(-1200)).approx_double(), tiniest);
    EXPECT_EQ((unit * 3 / 2).approx_double(), 2 * tiniest);
    EXPECT_EQ((unit * 5 / 2).approx_double(), 2 * tiniest);
    EXPECT_EQ(power_of_two(-1200).approx_double(), 0.0);
    EXPECT_EQ((power_of_two(-1022) - unit / 4).approx_double(), 0x1p-1022);
}

TEST(ApproxDouble, OverflowsWhereIeeeDoes) {
    const Rational last_ulp = power_of_two(971);
    EXPECT_EQ((Rational(largest) + last_ulp / 2 - 1).approx_double(), largest);
    EXPECT_EQ((Rational(largest) + last_ulp / 2).approx_double(), infinity);
    EXPECT_EQ((-power_of_two(5000)).approx_double(), -infinity);
}

// strtod rounds correctly; it is the outside opinion.
TEST(ApproxDouble, AgreesWithTheDecimalReaderOfTheCLibrary) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 3000; ++i) {
        std::string text = i % 2 == 0 ? "-" : "";
        const auto digits = 1 + random() % 25;
        for (std::size_t k = 0; k < digits; ++k) text += static_cast<char>('0' + random() % 10);
        text += "e" + std::to_string(static_cast<int>(random() % 680) - 350);
        ASSERT_EQ(Rational::parse(text)->approx_double(), std::strtod(text.c_str(), nullptr))
            << text;
    }
}

RC_GTEST_PROP(RationalLaw, DoublesComeBack, (std::int64_t mantissa)) {
    const int exponent = *rc::gen::inRange(-1130, 960);
    const double x = std::ldexp(static_cast<double>(mantissa), exponent);
    RC_ASSERT(Rational(x).approx_double() == x);
}

RC_GTEST_PROP(RationalLaw, TextComesBack, (long n, long d)) {
    RC_PRE(d != 0);
    RC_ASSERT(Rational::parse(fraction(n, d).to_string()) == fraction(n, d));
}

RC_GTEST_PROP(RationalLaw, IsAField, (int a, int b, int c)) {
    const Rational x = fraction(a, 7), y = fraction(b, 9), z = Rational(c);
    RC_ASSERT(x * (y + z) == x * y + x * z);
    RC_ASSERT(x + (y + z) == (x + y) + z);
    RC_ASSERT(x - y == -(y - x));
    if (b != 0) RC_ASSERT(x / y * y == x);
    RC_ASSERT((x < y) == ((x - y).sign() == Sign::negative));
}

TEST(Rational, PrintsLikeItsText) {
    std::ostringstream out;
    out << fraction(-1, 3) << ' ' << Rational(4);
    EXPECT_EQ(out.str(), "-1/3 4");
}

}  // namespace
}  // namespace sightline
