// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The few exact predicates on points of space that validation needs. Private.

#include <array>

#include "sightline/arith/sign.hpp"
#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// On which side of the plane through a, b, c the point d lies: positive when a, b, c turn
/// counter-clockwise seen from d; zero when the four are coplanar.
[[nodiscard]] Sign orientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] Sign orientation3(const RationalPoint3& a, const RationalPoint3& b,
                                const RationalPoint3& c, const RationalPoint3& d);

/// The point without its coordinate number `axis`; the other two in cyclic order, so that a triangle whose
/// normal points along the axis keeps its sense.
[[nodiscard]] inline Point2 drop(const Point3& p, int axis) {
    return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

[[nodiscard]] inline RationalPoint2 drop(const RationalPoint3& p, int axis) {
    return axis == 0   ? RationalPoint2{p.y, p.z}
           : axis == 1 ? RationalPoint2{p.z, p.x}
                       : RationalPoint2{p.x, p.y};
}

/// Whether three points lie on one line.
[[nodiscard]] bool are_collinear(const Point3& a, const Point3& b, const Point3& c);
[[nodiscard]] bool are_collinear(const RationalPoint3& a, const RationalPoint3& b,
                                 const RationalPoint3& c);

/// Whether b lies strictly between a and c on the line through them.
[[nodiscard]] bool is_between(const Point3& a, const Point3& b, const Point3& c);
[[nodiscard]] bool is_between(const RationalPoint3& a, const RationalPoint3& b,
                              const RationalPoint3& c);

/// An oriented plane by three points that are not collinear, with an axis along which it can be looked at.
struct Plane3 {
    std::array<Point3, 3> points;
    int axis = 2;              ///< the plane is not parallel to it
    Sign facing = Sign::zero;  ///< of the normal's coordinate number `axis`

    /// The points are not collinear.
    static Plane3 through(const Point3& a, const Point3& b, const Point3& c);

    /// Side of p: positive in front, where the points turn counter-clockwise.
    [[nodiscard]] Sign side(const Point3& p) const {
        return orientation3(points[0], points[1], points[2], p);
    }
    /// Turn of three points of the plane, seen from the front.
    [[nodiscard]] Sign turn(const Point3& a, const Point3& b, const Point3& c) const;
    [[nodiscard]] bool contains(const Plane3& other) const {
        return side(other.points[0]) == Sign::zero && side(other.points[1]) == Sign::zero &&
               side(other.points[2]) == Sign::zero;
    }
    /// For coplanar planes: whether they face the same way.
    [[nodiscard]] bool faces_like(const Plane3& other) const {
        return turn(other.points[0], other.points[1], other.points[2]) == Sign::positive;
    }
};

}  // namespace sightline::detail
