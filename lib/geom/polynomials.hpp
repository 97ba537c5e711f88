// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The polynomials behind the planar predicates, each written once for any number type.

namespace sightline::detail {

/// (a - b)(c - d) - (e - f)(g - h): all orientations and dot products of differences of points.
template <typename Number>
struct ProductDifference {
    Number a, b, c, d, e, f, g, h;

    [[nodiscard]] Number value() const { return (a - b) * (c - d) - (e - f) * (g - h); }
};

/// Twice the signed area of the triangle abc: (b - a) × (c - a).
template <typename Number, typename Point>
[[nodiscard]] constexpr ProductDifference<Number> orientation_polynomial(const Point& a,
                                                                         const Point& b,
                                                                         const Point& c) {
    return {b.x, a.x, c.y, a.y, b.y, a.y, c.x, a.x};
}

/// (b - a) · (q - p).
template <typename Number, typename Point>
[[nodiscard]] constexpr ProductDifference<Number> dot_polynomial(const Point& a, const Point& b,
                                                                 const Point& p, const Point& q) {
    return {b.x, a.x, q.x, p.x, a.y, b.y, q.y, p.y};
}

/// (b - a) × (q - p).
template <typename Number, typename Point>
[[nodiscard]] constexpr ProductDifference<Number> cross_polynomial(const Point& a, const Point& b,
                                                                   const Point& p, const Point& q) {
    return {b.x, a.x, q.y, p.y, b.y, a.y, q.x, p.x};
}

}  // namespace sightline::detail
