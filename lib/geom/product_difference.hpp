// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The sign of (a-b)(c-d) - (e-f)(g-h) for doubles, tier by tier. Private.

#include <cmath>
#include <limits>
#include <optional>

#include "geom/polynomials.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline::detail {

/// Double filter: the sign when it is certain, else empty. Any doubles, NaN and infinity included
/// (never decided then).
///
/// Proof of the bound. Let u = 2^-53 and M = 2^-1022. A rounded difference has relative error at
/// most u and no other, since subtraction cannot underflow inexactly. So p, the rounded first
/// product, and P, the exact one, satisfy p = P(1+δ₁)(1+δ₂)(1+δ₃) + η with |δ| <= u, |η| <=
/// 2^-1075, hence |P - p| <= (3u + 7u²)|p| + 2^-1074; q and Q likewise. The sign of P - Q is that
/// of p - q when
///     |p - q| > (3u + 7u²)(|p| + |q|) + 2^-1073.                                          (1)
/// Of the computed det, s and bound:  |p - q| >= |det|(1 - u);  s >= (|p| + |q|)(1 - u);
///     bound >= (K s (1 - u) - 2^-1075 + M)(1 - u)  with  K = 3u + 32u²,
/// and K(1-u)⁴ >= 3u + 7u², (M - 2^-1075)(1-u)² >= 2^-1073: so |det| > bound implies (1).
/// If a difference, product or sum overflows, bound is infinite or NaN and nothing is decided.
/// A product with a factor that is zero is zero exactly, for x - y rounds to zero only when x = y.
[[nodiscard]] inline std::optional<Sign> filtered_sign(const ProductDifference<double>& f) {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    constexpr double k = (3 + 32 * u) * u;
    const double x1 = f.a - f.b;
    const double y1 = f.c - f.d;
    const double x2 = f.e - f.f;
    const double y2 = f.g - f.h;
    const double p = x1 * y1;
    const double q = x2 * y2;
    const double det = p - q;
    const double bound = k * (std::abs(p) + std::abs(q)) + std::numeric_limits<double>::min();
    if (det > bound) return Sign::positive;
    if (-det > bound) return Sign::negative;
    if (p == 0 && q == 0 && (x1 == 0 || y1 == 0) && (x2 == 0 || y2 == 0)) return Sign::zero;
    return std::nullopt;
}

/// Interval tier: the sign when it is certain, else empty. Any doubles.
[[nodiscard]] std::optional<Sign> interval_sign(const ProductDifference<double>& f);

/// Exact tier: always the sign. Finite doubles.
[[nodiscard]] Sign exact_sign(const ProductDifference<double>& f);

/// Intervals, then exact numbers.
[[nodiscard]] CertifiedSign sign_after_filter(const ProductDifference<double>& f);

/// All tiers.
[[nodiscard]] inline CertifiedSign certified_sign(const ProductDifference<double>& f) {
    if (const auto sign = filtered_sign(f)) return {*sign, Tier::filter};
    return sign_after_filter(f);
}

}  // namespace sightline::detail
