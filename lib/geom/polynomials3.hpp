// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The polynomials behind the predicates of space, each written once for any number type. Private.

#include "sightline/geom/point.hpp"
#include "sightline/geom/vector3.hpp"

namespace sightline::detail {

/// to - from, in the given number type.
template <typename Number, typename Point>
[[nodiscard]] BasicVector3<Number> difference(const Point& to, const Point& from) {
    return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y),
            Number(to.z) - Number(from.z)};
}

/// Six times the signed volume of the tetrahedron abcd: the determinant of b-a, c-a, d-a.
template <typename Number, typename Point>
[[nodiscard]] Number orientation3_polynomial(const Point& a, const Point& b, const Point& c,
                                             const Point& d) {
    return determinant(difference<Number>(b, a), difference<Number>(c, a),
                       difference<Number>(d, a));
}

/// ((b - a) × (c - a)) · (q - p).
template <typename Number, typename Point>
[[nodiscard]] Number line_plane_polynomial(const Point& a, const Point& b, const Point& c,
                                           const Point& p, const Point& q) {
    return determinant(difference<Number>(b, a), difference<Number>(c, a),
                       difference<Number>(q, p));
}

}  // namespace sightline::detail
