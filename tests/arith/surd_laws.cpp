// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of Surd by their numbers, and MPFR with many bits as the outside opinion.
#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "sightline/arith/surd.hpp"

namespace sightline {
namespace {

Rational fraction(int n, int d) { return Rational(n) / Rational(d); }

rc::Gen<Rational> rationals() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(-60, 61), rc::gen::inRange(1, 13)),
                        [](const auto& p) { return fraction(p.first, p.second); });
}

rc::Gen<Rational> radicands() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 60), rc::gen::inRange(1, 13)),
                        [](const auto& p) { return fraction(p.first, p.second); });
}

// A number of Q(√c), its radicand scaled by a square now and then.
Surd number_of(const Rational& c) {
    const Rational k = *rc::gen::map(rc::gen::inRange(1, 5), [](int i) { return Rational(i); });
    return {*rationals(), *rationals(), k * k * c};
}

// The sign of a + b√c + e√f with 2000 bits, or zero when that many show nothing.
Sign sign_by_mpfr(const Rational& a, const Rational& b, const Rational& c, const Rational& e,
                  const Rational& f) {
    mpfr_t sum;
    mpfr_t term;
    mpfr_inits2(2000, sum, term, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_q(sum, a.mpq(), MPFR_RNDN);
    for (const auto& [factor, radicand] : {std::pair{b, c}, std::pair{e, f}}) {
        mpfr_set_q(term, radicand.mpq(), MPFR_RNDN);
        mpfr_sqrt(term, term, MPFR_RNDN);
        mpfr_mul_q(term, term, factor.mpq(), MPFR_RNDN);
        mpfr_add(sum, sum, term, MPFR_RNDN);
    }
    const bool is_noise = mpfr_zero_p(sum) != 0 || mpfr_get_exp(sum) < -1500;
    const int sign = mpfr_sgn(sum);
    mpfr_clears(sum, term, static_cast<mpfr_ptr>(nullptr));
    return is_noise ? Sign::zero : sign_of(sign);
}

Sign sign_by_mpfr(const Surd& x) {
    return sign_by_mpfr(x.rational_part(), static_cast<int>(x.root_sign()), x.radicand(), 0, 0);
}

RC_GTEST_PROP(SurdLaw1, IsAField, ()) {
    const Rational c = *radicands();
    const Surd x = number_of(c), y = number_of(c), z = number_of(c);
    RC_ASSERT(x + y == y + x);
    RC_ASSERT(x * y == y * x);
    RC_ASSERT((x + y) + z == x + (y + z));
    RC_ASSERT((x * y) * z == x * (y * z));
    RC_ASSERT(x * (y + z) == x * y + x * z);
    RC_ASSERT(x - y == -(y - x));
    RC_ASSERT(x - x == Surd());
    if (y != Surd()) RC_ASSERT(x / y * y == x);
}

RC_GTEST_PROP(SurdLaw2, TheOrderIsTheSignOfTheDifference, ()) {
    const Rational c = *radicands();
    const Surd x = number_of(c), y = number_of(c);
    RC_ASSERT((x < y) == ((x - y).sign() == Sign::negative));
    RC_ASSERT((x == y) == ((x - y).sign() == Sign::zero));
}

RC_GTEST_PROP(SurdLaw3, TheOrderIsTotalAcrossFields, ()) {
    const Surd x = number_of(*radicands()), y = number_of(*radicands()),
               z = number_of(*radicands());
    RC_ASSERT((x <=> y) == (0 <=> (y <=> x)));
    RC_ASSERT(((x <=> y) == 0) == (x == y));
    if (x <= y && y <= z) RC_ASSERT(x <= z);
    const Rational a = *rationals(), b = *rationals();
    RC_ASSERT((Surd(a) <=> Surd(b)) == (a <=> b));
}

RC_GTEST_PROP(SurdLaw4, SquaresMoveUnderTheRoot, ()) {
    const Rational a = *rationals(), b = *rationals(), c = *radicands(), k = abs(*rationals());
    RC_ASSERT(Surd(a, b * k, c) == Surd(a, b, k * k * c));
}

RC_GTEST_PROP(SurdOracle, SignsAreThoseOfManyBits, ()) {
    const Surd x = number_of(*radicands()), y = number_of(*radicands());
    RC_ASSERT(x.sign() == sign_by_mpfr(x));
    const auto [a, b, c] = std::tuple{*rationals(), *rationals(), *radicands()};
    const auto [e, f] = std::tuple{*rationals(), *radicands()};
    RC_ASSERT(sign_of_sum(a, b, c, e, f) == sign_by_mpfr(a, b, c, e, f));
}

RC_GTEST_PROP(SurdOracle, EnclosuresContainTheirNumber, ()) {
    const Surd x = number_of(*radicands());
    const Interval box = enclosure(x);
    RC_ASSERT(Surd(Rational(box.lower)) <= x);
    RC_ASSERT(x <= Surd(Rational(box.upper)));
    RC_ASSERT(box.contains(x.approx_double()));
}

RC_GTEST_PROP(SurdOracle, TextComesBack, ()) {
    const Surd x = number_of(*radicands());
    RC_ASSERT(Surd::parse(x.to_string()) == x);
}

// Every a + b√c with small parts, each against each: order and equality as 2000 bits say.
TEST(SurdExhaustive, SmallNumbersAreOrderedAsTheyShould) {
    std::vector<Surd> all;
    for (int a = -2; a <= 2; ++a) {
        for (int b = -2; b <= 2; ++b) {
            for (int c = 0; c <= 8; ++c) all.emplace_back(a, b, c);
        }
    }
    const auto b_of = [](const Surd& x) { return Rational(static_cast<int>(x.root_sign())); };
    for (const Surd& x : all) {
        for (const Surd& y : all) {
            const Sign expected = sign_by_mpfr(x.rational_part() - y.rational_part(), b_of(x),
                                               x.radicand(), -b_of(y), y.radicand());
            ASSERT_EQ(static_cast<int>(expected) <=> 0, x <=> y) << x << " and " << y;
            ASSERT_EQ(expected == Sign::zero, x == y) << x << " and " << y;
        }
    }
}

}  // namespace
}  // namespace sightline
