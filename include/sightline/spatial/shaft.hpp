// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sightline/geom/point.hpp"
#include "sightline/spatial/box3.hpp"

namespace sightline {

/// The convex sets between which shafts are made, by their corners: a point, a segment, a triangle or
/// a box. Corners may coincide or be collinear.
class Convex3 {
public:
    enum class Shape : std::uint8_t { point, segment, triangle, box };

    explicit Convex3(const Point3& p) : shape_(Shape::point), size_(1), corners_{p} {}
    Convex3(const Point3& a, const Point3& b) : shape_(Shape::segment), size_(2), corners_{a, b} {}
    Convex3(const Point3& a, const Point3& b, const Point3& c)
        : shape_(Shape::triangle), size_(3), corners_{a, b, c} {}
    /// Contract: the box is not empty, and finite.
    explicit Convex3(const Box3& box);

    [[nodiscard]] Shape shape() const noexcept { return shape_; }
    /// A box's corner i is Box3::corner(i).
    [[nodiscard]] std::span<const Point3> corners() const noexcept {
        return {corners_.data(), size_};
    }

private:
    Shape shape_;
    std::uint8_t size_;
    std::array<Point3, 8> corners_;
};

/// The shaft between two convex sets: the union of all segments from one to the other, which is their
/// convex hull.
///
/// Its tests are conservative: where they say that something misses the shaft, it does, exactly; where
/// it misses by less than rounding, or touches, they say that it may meet. The planes are the hull's
/// facets and those through a hull's edge and parallel to an axis, so that for boxes no other
/// plane could tell more. Built in O(product of the corners' numbers); a test costs O(planes), at most
/// some 30. \cite haines_wallace_1994
class Shaft {
public:
    Shaft(const Convex3& from, const Convex3& to);

    /// False only when no point of the closed box is in the shaft.
    [[nodiscard]] bool may_meet(const Box3& box) const;
    /// False only when no point of the convex hull of the points is in the shaft.
    [[nodiscard]] bool may_meet(std::span<const Point3> points) const;
    [[nodiscard]] bool may_meet(const Point3& p) const { return may_meet({&p, 1}); }

    /// The box of both sets; exact.
    [[nodiscard]] const Box3& bounds() const noexcept { return bounds_; }
    [[nodiscard]] std::size_t plane_count() const noexcept { return planes_.size(); }

private:
    /// The shaft lies in normal · x < offset, for all x and with all errors of rounding that a test of
    /// a point within bounds_ makes.
    struct Plane {
        std::array<double, 3> normal;
        double offset;
        double corner_offset;  ///< the same without the errors of the test
    };

    friend class ShaftBuilder;

    Box3 bounds_;
    std::vector<Plane> planes_;
};

}  // namespace sightline
