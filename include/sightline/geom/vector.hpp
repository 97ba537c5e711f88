// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <ostream>

#include "sightline/arith/rational.hpp"
#include "sightline/geom/point.hpp"

namespace sightline {

/// A displacement in the plane. Rational, because the difference of two doubles need not be a
/// double.
struct Vector2 {
    Rational x;
    Rational y;

    [[nodiscard]] bool is_zero() const noexcept {
        return x.sign() == Sign::zero && y.sign() == Sign::zero;
    }
    friend bool operator==(const Vector2&, const Vector2&) = default;
    friend std::strong_ordering operator<=>(const Vector2&, const Vector2&) = default;
    [[nodiscard]] friend Vector2 operator-(const Vector2& v) { return {-v.x, -v.y}; }
    [[nodiscard]] friend Vector2 operator+(const Vector2& v, const Vector2& w) {
        return {v.x + w.x, v.y + w.y};
    }
    [[nodiscard]] friend Vector2 operator-(const Vector2& v, const Vector2& w) {
        return {v.x - w.x, v.y - w.y};
    }
    [[nodiscard]] friend Vector2 operator*(const Rational& k, const Vector2& v) {
        return {k * v.x, k * v.y};
    }
    friend std::ostream& operator<<(std::ostream& out, const Vector2& v) {
        return out << '(' << v.x << ", " << v.y << ')';
    }
};

[[nodiscard]] inline Vector2 operator-(const RationalPoint2& to, const RationalPoint2& from) {
    return {to.x - from.x, to.y - from.y};
}

[[nodiscard]] inline RationalPoint2 operator+(const RationalPoint2& p, const Vector2& v) {
    return {p.x + v.x, p.y + v.y};
}

[[nodiscard]] inline Rational dot(const Vector2& v, const Vector2& w) {
    return v.x * w.x + v.y * w.y;
}

/// The third component of the vector product: positive when w points to the left of v.
[[nodiscard]] inline Rational cross(const Vector2& v, const Vector2& w) {
    return v.x * w.y - v.y * w.x;
}

/// The square of v's length.
[[nodiscard]] inline Rational squared_length(const Vector2& v) { return dot(v, v); }

}  // namespace sightline
