// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/exact3.hpp"

#include <algorithm>

#include "geom/polynomial_sign.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

Sign orientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return polynomial_sign(Arithmetic::filtered,
                           [&]<typename Number>() -> Number {
                               const Number bx = Number(b.x) - Number(a.x);
                               const Number by = Number(b.y) - Number(a.y);
                               const Number bz = Number(b.z) - Number(a.z);
                               const Number cx = Number(c.x) - Number(a.x);
                               const Number cy = Number(c.y) - Number(a.y);
                               const Number cz = Number(c.z) - Number(a.z);
                               const Number dx = Number(d.x) - Number(a.x);
                               const Number dy = Number(d.y) - Number(a.y);
                               const Number dz = Number(d.z) - Number(a.z);
                               return bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) +
                                      bz * (cx * dy - cy * dx);
                           })
        .sign;
}

bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
    for (int axis = 0; axis < 3; ++axis)
        if (orientation(drop(a, axis), drop(b, axis), drop(c, axis)) != Sign::zero) return false;
    return true;
}

bool is_between(const Point3& a, const Point3& b, const Point3& c) {
    // Along a line coordinates are monotone, so that their order is the lexicographic order of points.
    return ((a < b && b < c) || (c < b && b < a)) && are_collinear(a, b, c);
}

Plane3 Plane3::through(const Point3& a, const Point3& b, const Point3& c) {
    Plane3 plane{{a, b, c}};
    for (plane.axis = 2; plane.axis >= 0; --plane.axis) {
        const int axis = plane.axis;
        plane.facing = orientation(drop(a, axis), drop(b, axis), drop(c, axis));
        if (plane.facing != Sign::zero) break;
    }
    return plane;
}

Sign Plane3::turn(const Point3& a, const Point3& b, const Point3& c) const {
    return facing * orientation(drop(a, axis), drop(b, axis), drop(c, axis));
}

}  // namespace sightline::detail
