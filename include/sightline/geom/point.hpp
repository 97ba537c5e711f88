// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <iosfwd>

#include "sightline/arith/rational.hpp"

namespace sightline {

/// A point of the plane with finite double coordinates, taken as the exact rational numbers they
/// are. Ordered lexicographically, x first. -0.0 equals 0.0.
struct Point2 {
    double x = 0;
    double y = 0;

    friend bool operator==(const Point2&, const Point2&) = default;
    friend std::partial_ordering operator<=>(const Point2&, const Point2&) = default;
    /// "(x, y)", each coordinate as the shortest decimal that reads back to the same double.
    friend std::ostream& operator<<(std::ostream& out, const Point2& p);
};

/// A point of the plane with rational coordinates: a constructed point, or an input given as a
/// fraction.
struct RationalPoint2 {
    Rational x;
    Rational y;

    friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
    friend std::strong_ordering operator<=>(const RationalPoint2&, const RationalPoint2&) = default;
    /// "(x, y)", as exact fractions.
    friend std::ostream& operator<<(std::ostream& out, const RationalPoint2& p);
};

/// A point of space with finite double coordinates, taken as the exact rational numbers they are.
/// Ordered lexicographically, x first. -0.0 equals 0.0.
struct Point3 {
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Point3&, const Point3&) = default;
    friend std::partial_ordering operator<=>(const Point3&, const Point3&) = default;
    /// "(x, y, z)", each coordinate as the shortest decimal that reads back to the same double.
    friend std::ostream& operator<<(std::ostream& out, const Point3& p);
};

/// A point of space with rational coordinates.
struct RationalPoint3 {
    Rational x;
    Rational y;
    Rational z;

    friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
    friend std::strong_ordering operator<=>(const RationalPoint3&, const RationalPoint3&) = default;
    /// "(x, y, z)", as exact fractions.
    friend std::ostream& operator<<(std::ostream& out, const RationalPoint3& p);
};

/// The same point with rational coordinates; exact.
[[nodiscard]] inline RationalPoint2 to_rational(const Point2& p) {
    return {Rational(p.x), Rational(p.y)};
}

[[nodiscard]] inline RationalPoint3 to_rational(const Point3& p) {
    return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

/// The nearest doubles to p's coordinates, for drawing.
[[nodiscard]] inline Point2 approx_point(const RationalPoint2& p) {
    return {p.x.approx_double(), p.y.approx_double()};
}

[[nodiscard]] inline Point3 approx_point(const RationalPoint3& p) {
    return {p.x.approx_double(), p.y.approx_double(), p.z.approx_double()};
}

}  // namespace sightline
