// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bounds of scalar products in doubles. Private.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// A direction for separating tests: any doubles, at most 1/4 in absolute value, so that products with
/// finite coordinates and their sums are finite.
using Normal3 = std::array<double, 3>;

constexpr double rounding_unit = std::numeric_limits<double>::epsilon() / 2;

/// |n|·|p| by components: errors are relative to it.
inline double magnitude(const Normal3& n, const Point3& p) {
    return std::abs(n[0]) * std::abs(p.x) + std::abs(n[1]) * std::abs(p.y) +
           std::abs(n[2]) * std::abs(p.z);
}

/// n·p, rounded. Three products and two sums, each rounded, and products may underflow: it errs by
/// less than 3u(1 + 4u) Σ|nᵢpᵢ| + 2^-1073.
inline double product(const Normal3& n, const Point3& p) {
    return n[0] * p.x + n[1] * p.y + n[2] * p.z;
}

/// Twice the error of product(), whatever the magnitude itself has been rounded by: room for adding or
/// subtracting the bound, which rounds once more.
inline double product_error(double magnitude) {
    return 6 * rounding_unit * magnitude + std::numeric_limits<double>::min();
}

/// Certainly not more than n·p.
inline double product_below(const Normal3& n, const Point3& p) {
    return product(n, p) - product_error(magnitude(n, p));
}

/// Certainly not less than n·p.
inline double product_above(const Normal3& n, const Point3& p) {
    return product(n, p) + product_error(magnitude(n, p));
}

/// v scaled by a power of two so that its largest component is between 1/8 and 1/4; zero when v is
/// zero or not finite.
inline Normal3 scaled_normal(const Normal3& v) {
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    const int exponent = -std::ilogb(largest) - 3;
    return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
}

/// (b - a) × (c - a) as a direction; any rounding is harmless, as it is only proposed.
inline Normal3 proposed_normal(const Normal3& u, const Normal3& v) {
    const Normal3 s = scaled_normal(u);
    const Normal3 t = scaled_normal(v);
    return scaled_normal(
        {s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]});
}

/// b - a, halved against overflow.
inline Normal3 half_difference(const Point3& b, const Point3& a) {
    return {b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
}

}  // namespace sightline::detail
