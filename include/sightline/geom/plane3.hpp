// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "sightline/geom/vector3.hpp"

namespace sightline {

/// The oriented plane of the points x with normal·x == offset; normal ≠ 0. Multiples by a positive
/// number are the same plane, but are not equal.
struct Plane3 {
    Vector3 normal;
    Rational offset;

    /// normal·p - offset: positive on the side that the normal points to.
    [[nodiscard]] Rational height(const RationalPoint3& p) const {
        return dot(normal, vector_to(p)) - offset;
    }
    /// A normal that vanishes: three collinear points have no plane.
    [[nodiscard]] bool is_degenerate() const { return normal.is_zero(); }

    friend bool operator==(const Plane3&, const Plane3&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Plane3& plane) {
        return out << plane.normal << " . x = " << plane.offset;
    }
};

/// The plane of three points; its normal points to where they are counter-clockwise.
[[nodiscard]] inline Plane3 plane_through(const RationalPoint3& a, const RationalPoint3& b,
                                          const RationalPoint3& c) {
    const Vector3 normal = cross(b - a, c - a);
    return {normal, dot(normal, vector_to(a))};
}

}  // namespace sightline
