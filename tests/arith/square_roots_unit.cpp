// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/square_roots.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace sightline {
namespace {

using Numbers = std::vector<Rational>;

CertifiedSign compare(const Numbers& a, const Numbers& b) {
    return compare_sums_of_square_roots(a, b);
}

TEST(SumOfSquareRoots, EnclosesTheSum) {
    const Interval root = sum_of_square_roots(Numbers{2});
    EXPECT_LT(Rational(root.lower) * Rational(root.lower), Rational(2));
    EXPECT_GT(Rational(root.upper) * Rational(root.upper), Rational(2));
    EXPECT_EQ(root.upper, std::nextafter(root.lower, 2));
    EXPECT_EQ(sum_of_square_roots(Numbers{9, 16, Rational(1) / Rational(4)}), (Interval{7.5, 7.5}));
    EXPECT_EQ(sum_of_square_roots(Numbers{}), (Interval{0, 0}));
    EXPECT_EQ(sum_of_square_roots(Numbers{0}), (Interval{0, 0}));
}

TEST(SumOfSquareRoots, FewerBitsGiveAWiderInterval) {
    const Interval wide = sum_of_square_roots(Numbers{2, 3}, 8);
    const Interval narrow = sum_of_square_roots(Numbers{2, 3}, 200);
    EXPECT_TRUE(wide.contains(narrow));
    EXPECT_GT(wide.upper - wide.lower, 1e-3);
    EXPECT_EQ(narrow.upper, std::nextafter(narrow.lower, 4));
}

TEST(SumOfSquareRoots, ReachesBeyondTheRangeOfDoubles) {
    const Interval x = sum_of_square_roots(Numbers{*Rational::parse("1e700")});
    EXPECT_EQ(x.lower, std::numeric_limits<double>::max());
    EXPECT_EQ(x.upper, std::numeric_limits<double>::infinity());
    EXPECT_EQ(sum_of_square_roots(Numbers{*Rational::parse("1e-700")}), (Interval{0, 0x1p-1074}));
}

TEST(SumOfSquareRoots, RefusesNegativeNumbers) {
    EXPECT_THROW((void)sum_of_square_roots(Numbers{-1}), std::domain_error);
    EXPECT_THROW((void)compare({1}, {-1}), std::domain_error);
}

TEST(CompareSums, IntervalsSettleTheOrdinaryCase) {
    EXPECT_EQ(compare({2, 3}, {10}), (CertifiedSign{Sign::negative, Tier::interval}));
    EXPECT_EQ(compare({10}, {2, 3}), (CertifiedSign{Sign::positive, Tier::interval}));
}

TEST(CompareSums, EqualSumsAreRecognised) {
    const CertifiedSign equal{Sign::zero, Tier::exact};
    EXPECT_EQ(compare({2, 3, 5}, {5, 2, 3}), equal);
    EXPECT_EQ(compare({8}, {2, 2}), equal) << "√8 = 2√2";
    EXPECT_EQ(compare({2, 8, 18}, {72}), equal) << "1 + 2 + 3 = 6 times √2";
    EXPECT_EQ(compare({27, 5}, {3, 5, 12}), equal);
    EXPECT_EQ(compare({Rational(1) / Rational(2)},
                      {Rational(1) / Rational(8), Rational(1) / Rational(8)}),
              equal);
    EXPECT_EQ(compare({}, {}), equal);
    EXPECT_EQ(compare({0, 0}, {}), equal);
    EXPECT_EQ(compare({4, 9}, {25}).sign, Sign::zero) << "2 + 3 = 5";
}

TEST(CompareSums, LargeSquareFactorsNeedNoFactoring) {
    const Rational prime = 1'000'003, other = 999'983;
    const Rational square = prime * prime * other;  // √ = prime √other
    const Numbers many(3, square);
    EXPECT_EQ(compare(many, {9 * square}), (CertifiedSign{Sign::zero, Tier::exact}));
    EXPECT_EQ(compare(many, {9 * square + Rational(1) / *Rational::parse("1e30")}),
              (CertifiedSign{Sign::negative, Tier::exact}));
}

// Near-equalities: the sides agree in 4 and in 48 digits.
TEST(CompareSums, NearlyEqualSumsAreSeparatedByPrecision) {
    EXPECT_EQ(compare({10, 11}, {5, 18}), (CertifiedSign{Sign::positive, Tier::interval}));
    const Rational n = *Rational::parse("1e24");
    EXPECT_EQ(compare({n - 1, n + 1}, {n, n}), (CertifiedSign{Sign::negative, Tier::exact}))
        << "they differ by 1e-36 / 4, at 2e12: 160 bits";
}

TEST(CompareSums, TheCapLeavesUnequalSumsUndecidedAndEqualOnesNot) {
    const Rational n = *Rational::parse("1e24");
    const auto capped = [](const Numbers& a, const Numbers& b) {
        return compare_sums_of_square_roots(a, b, 64);
    };
    EXPECT_EQ(capped({n - 1, n + 1}, {n, n}), (CertifiedSign{Sign::zero, Tier::undecided}));
    EXPECT_EQ(capped({8 * n}, {2 * n, 2 * n}), (CertifiedSign{Sign::zero, Tier::exact}));
}

rc::Gen<Numbers> some_numbers() {
    return rc::gen::container<Numbers>(
        rc::gen::map(rc::gen::inRange(0, 40), [](int n) { return Rational(n); }));
}

RC_GTEST_PROP(CompareSumsLaw, ExchangingTheSidesFlipsTheSign, ()) {
    const Numbers a = *some_numbers(), b = *some_numbers();
    const CertifiedSign got = compare(a, b);
    RC_ASSERT(got.decided_by != Tier::undecided);
    RC_ASSERT(compare(b, a) == (CertifiedSign{-got.sign, got.decided_by}));
}

RC_GTEST_PROP(CompareSumsLaw, ACommonTermChangesNothing, (unsigned short common)) {
    Numbers a = *some_numbers(), b = *some_numbers();
    const CertifiedSign before = compare(a, b);
    a.insert(a.begin(), common);
    b.push_back(common);
    RC_ASSERT(compare(a, b) == before);
}

RC_GTEST_PROP(CompareSumsLaw, FourTimesARadicandIsTheSameAsTwoOfIt, ()) {
    const Numbers a = *some_numbers();
    Numbers quadrupled;
    Numbers doubled;
    for (const Rational& x : a) {
        quadrupled.push_back(4 * x);
        doubled.push_back(x);
        doubled.push_back(x);
    }
    const CertifiedSign got = compare(quadrupled, doubled);
    RC_ASSERT(got.sign == Sign::zero);
    RC_ASSERT(got.decided_by != Tier::undecided);
}

RC_GTEST_PROP(CompareSumsLaw, AgreesWithTheEnclosures, ()) {
    const Numbers a = *some_numbers(), b = *some_numbers();
    const Interval x = sum_of_square_roots(a), y = sum_of_square_roots(b);
    const Sign sign = compare(a, b).sign;
    if (x.lower > y.upper) RC_ASSERT(sign == Sign::positive);
    if (x.upper < y.lower) RC_ASSERT(sign == Sign::negative);
    if (sign == Sign::zero) RC_ASSERT(x.overlaps(y));
}

}  // namespace
}  // namespace sightline
