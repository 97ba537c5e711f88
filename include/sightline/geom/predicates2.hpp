// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/arith/sign.hpp"
#include "sightline/geom/point.hpp"

namespace sightline {

/// On which side of the directed line a→b the point c lies.
///
/// positive: left of it; negative: right of it; zero: on it, or a == b.
/// Exact for all finite inputs.
///
/// Laws
///  (1) orientation(b, c, a) ==  orientation(a, b, c)
///  (2) orientation(b, a, c) == -orientation(a, b, c)
///  (3) adding one vector to a, b and c changes nothing, when the sums are exact
///  (4) multiplying all coordinates by one power of two changes nothing, when the products are
///  exact (5) exchanging x and y in all three points flips the sign
///
/// Cost: 2 products when the filter decides (2 ns), else intervals, else exact products (30-100
/// ns).
[[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const Point2& c);
/// The same for rational points. Cost: rational arithmetic.
[[nodiscard]] Sign orientation(const RationalPoint2& a, const RationalPoint2& b,
                               const RationalPoint2& c);
/// The same for a rational point against a line through two input points; intervals first.
[[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const RationalPoint2& c);

}  // namespace sightline
