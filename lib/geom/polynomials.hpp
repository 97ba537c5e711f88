// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The polynomials behind the planar predicates, each written once for any number type. Private.
///
/// They are polynomials in differences of input coordinates, so that points far from the origin
/// lose no precision in the first tiers.

#include <utility>

#include "sightline/geom/line2.hpp"
#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// (a - b)(c - d) - (e - f)(g - h): all cross and dot products of differences of points.
template <typename Number>
struct ProductDifference {
    Number a, b, c, d, e, f, g, h;

    [[nodiscard]] Number value() const { return (a - b) * (c - d) - (e - f) * (g - h); }
};

/// Twice the signed area of the triangle abc: (b - a) × (c - a).
template <typename Number, typename Point>
[[nodiscard]] ProductDifference<Number> orientation_polynomial(const Point& a, const Point& b,
                                                               const Point& c) {
    return {b.x, a.x, c.y, a.y, b.y, a.y, c.x, a.x};
}

/// (b - a) · (q - p).
template <typename Number, typename Point>
[[nodiscard]] ProductDifference<Number> dot_polynomial(const Point& a, const Point& b,
                                                       const Point& p, const Point& q) {
    return {b.x, a.x, q.x, p.x, a.y, b.y, q.y, p.y};
}

/// (b - a) × (q - p).
template <typename Number, typename Point>
[[nodiscard]] ProductDifference<Number> cross_polynomial(const Point& a, const Point& b,
                                                         const Point& p, const Point& q) {
    return {b.x, a.x, q.y, p.y, b.y, a.y, q.x, p.x};
}

/// A vector times a factor w; stands for the vector (x/w, y/w).
template <typename Number>
struct Homogeneous2 {
    Number x, y, w;
};

/// p - base.
template <typename Number>
[[nodiscard]] Homogeneous2<Number> homogeneous(const Point2& p, const Point2& base) {
    return {Number(p.x) - Number(base.x), Number(p.y) - Number(base.y), Number(1.0)};
}

/// p - base for the meeting point p = s + (n/w) d of two lines s + R d and t + R e, where
/// w = d × e, positive, and n = (t - s) × e.
template <typename Number>
[[nodiscard]] Homogeneous2<Number> homogeneous(const ImplicitPoint2& p, const Point2& base) {
    const auto difference = [](const Point2& to, const Point2& from) {
        return std::pair{Number(to.x) - Number(from.x), Number(to.y) - Number(from.y)};
    };
    const auto [dx, dy] = difference(p.first().target, p.first().source);
    const auto [ex, ey] = difference(p.second().target, p.second().source);
    const auto [tx, ty] = difference(p.second().source, p.first().source);
    const auto [sx, sy] = difference(p.first().source, base);
    const Number w = dx * ey - dy * ex;
    const Number n = tx * ey - ty * ex;
    return {sx * w + n * dx, sy * w + n * dy, w};
}

/// The point at which differences are taken: a generator, so that some of them vanish.
[[nodiscard]] inline Point2 base_of(const Point2& p) { return p; }
[[nodiscard]] inline Point2 base_of(const ImplicitPoint2& p) { return p.first().source; }

/// (b - a) × (c - a), times the positive weights of the points, of which any may be implicit.
template <typename Number, typename A, typename B, typename C>
[[nodiscard]] Number homogeneous_orientation(const A& a, const B& b, const C& c) {
    const Point2 base = base_of(a);
    const auto p = homogeneous<Number>(a, base);
    const auto q = homogeneous<Number>(b, base);
    const auto r = homogeneous<Number>(c, base);
    return p.x * (q.y * r.w - r.y * q.w) - p.y * (q.x * r.w - r.x * q.w) +
           p.w * (q.x * r.y - r.x * q.y);
}

/// p - q as a vector, times the positive weights of p and q.
template <typename Number, typename P, typename Q>
[[nodiscard]] std::pair<Number, Number> homogeneous_difference(const P& p, const Q& q) {
    const Point2 base = base_of(p);
    const auto a = homogeneous<Number>(p, base);
    const auto b = homogeneous<Number>(q, base);
    return {a.x * b.w - b.x * a.w, a.y * b.w - b.y * a.w};
}

/// (b - a) · (q - p), times the positive weights of the points, of which any may be implicit.
template <typename Number, typename A, typename B, typename P, typename Q>
[[nodiscard]] Number homogeneous_dot(const A& a, const B& b, const P& p, const Q& q) {
    const auto [ax, ay] = homogeneous_difference<Number>(b, a);
    const auto [px, py] = homogeneous_difference<Number>(q, p);
    return ax * px + ay * py;
}

}  // namespace sightline::detail
