// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <functional>
#include <iosfwd>

#include "sightline/geom/point.hpp"
#include "sightline/geom/vector.hpp"

namespace sightline {

/// A direction of the plane: a vector other than zero, up to a positive factor.
///
/// Kept in canonical form, as two coprime integers, so that equal directions are equal objects.
/// Ordered counter-clockwise from the positive x-axis, over one full turn.
class Direction2 {
public:
    /// The direction of v. Throws std::domain_error when v is zero.
    explicit Direction2(const Vector2& v);
    /// From one point to another. Throws std::domain_error when they are equal.
    Direction2(const Point2& from, const Point2& to);
    Direction2(const RationalPoint2& from, const RationalPoint2& to);

    /// The representative: coprime integers.
    [[nodiscard]] const Vector2& vector() const noexcept { return v_; }
    [[nodiscard]] const Rational& x() const noexcept { return v_.x; }
    [[nodiscard]] const Rational& y() const noexcept { return v_.y; }

    [[nodiscard]] friend Direction2 reversed(const Direction2& d) {
        return Direction2(-d.v_, Canonical{});
    }
    /// A quarter turn counter-clockwise.
    [[nodiscard]] friend Direction2 turned_left(const Direction2& d) {
        return Direction2({-d.v_.y, d.v_.x}, Canonical{});
    }

    friend bool operator==(const Direction2&, const Direction2&) = default;
    friend std::strong_ordering operator<=>(const Direction2& a, const Direction2& b);
    friend std::ostream& operator<<(std::ostream& out, const Direction2& d);

private:
    struct Canonical {};
    Direction2(Vector2 v, Canonical) noexcept : v_(std::move(v)) {}

    Vector2 v_;
};

/// On which side of direction d the direction e points: positive left, negative right, zero when
/// parallel (equal or opposite).
[[nodiscard]] Sign side_of(const Direction2& d, const Direction2& e);

}  // namespace sightline

template <>
struct std::hash<sightline::Direction2> {
    std::size_t operator()(const sightline::Direction2& d) const noexcept {
        return d.x().hash() * 31 + d.y().hash();
    }
};
