// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/surd_line.hpp"

#include <array>
#include <cmath>

#include "sightline/arith/rational.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::detail {

namespace {

Rational power_of_two(int exponent) {
    Rational power = 1;
    const Rational factor = exponent < 0 ? Rational(1, 2) : Rational(2);
    for (int i = 0; i < std::abs(exponent); ++i) power *= factor;
    return power;
}

mpq_class to_gmp(const Rational& x) { return mpq_class(x.mpq()); }

}  // namespace

PluckerOf<Real> SurdLineSource::real_line() const {
    const auto real = [](const Surd& x) {
        const double v = x.approx_double();  // the nearest
        return Real{v, std::abs(v) * 0x1p-53 + 0x1p-1074};
    };
    return {{real(line_->d.x), real(line_->d.y), real(line_->d.z)},
            {real(line_->m.x), real(line_->m.y), real(line_->m.z)}};
}

ExactLine SurdLineSource::exact_line() const {
    // Every coordinate as a + b·√radicand, over one radicand and one denominator.
    const auto coordinates = line_->coordinates();
    const Rational scale = power_of_two(scale_exponent_);
    Rational radicand;
    for (const Surd& x : coordinates) {
        if (!x.is_rational()) radicand = x.radicand();
    }
    std::array<mpq_class, 6> a;
    std::array<mpq_class, 6> b;
    mpz_class denominator = 1;
    for (std::size_t i = 0; i < 6; ++i) {
        const Surd& x = coordinates[i];
        const Rational by = i < 3 ? Rational(1) : scale;
        a[i] = to_gmp(by * x.rational_part());
        if (!x.is_rational()) {
            const auto ratio = rational_square_root(x.radicand() / radicand);
            SIGHTLINE_EXPECT(ratio.has_value());
            const Rational size = by * *ratio;
            b[i] = to_gmp(x.root_sign() == Sign::negative ? -size : size);
        }
        mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), a[i].get_den_mpz_t());
        mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), b[i].get_den_mpz_t());
    }
    // √(p/q) = √(pq) / q: multiply the root's factors by q, and everything else too.
    const mpq_class c = to_gmp(radicand);
    ExactLine line;
    line.c = c.get_num() * c.get_den();
    const mpz_class q = sgn(c) == 0 ? mpz_class(1) : mpz_class(c.get_den());
    for (std::size_t i = 0; i < 6; ++i) {
        (i < 3 ? line.a.d[i] : line.a.m[i - 3]) = mpz_class(a[i] * denominator * q);
        (i < 3 ? line.b.d[i] : line.b.m[i - 3]) = mpz_class(b[i] * denominator);
    }
    return line;
}

}  // namespace sightline::detail
