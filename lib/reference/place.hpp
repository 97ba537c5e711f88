// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <optional>

#include "sightline/geom/point.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::reference {

/// A point of the plane, exact: two doubles where they suffice, rationals where they do not.
class Place {
public:
    Place(const Point2& p)
        : double_(p) {}              // NOLINT(google-explicit-constructor): every point is a place
    Place(const RationalPoint2& p);  // NOLINT(google-explicit-constructor)

    /// Whether the coordinates are doubles.
    [[nodiscard]] bool is_double() const noexcept { return !exact_.has_value(); }
    /// The coordinates, when they are doubles.
    [[nodiscard]] const Point2& as_double() const noexcept { return double_; }
    [[nodiscard]] RationalPoint2 rational() const {
        return exact_ ? *exact_ : to_rational(double_);
    }

    friend bool operator==(const Place& a, const Place& b) { return (a <=> b) == 0; }
    /// Lexicographic.
    friend std::strong_ordering operator<=>(const Place& a, const Place& b);

private:
    Point2 double_;
    std::optional<RationalPoint2> exact_;
};

/// On which side of the directed line a→b the place c lies: positive is left. Exact.
[[nodiscard]] Sign side(const Place& a, const Place& b, const Place& c);

/// Order of the second coordinates.
[[nodiscard]] std::strong_ordering compare_y(const Place& a, const Place& b);

/// Where the lines a→b and c→d meet; they must not be parallel.
[[nodiscard]] Place crossing(const Place& a, const Place& b, const Place& c, const Place& d);

/// Whether x lies on the closed segment ab, given that it lies on its line.
[[nodiscard]] bool is_between(const Place& a, const Place& b, const Place& x);

/// A direction at a place: towards another place, or straight away from it.
struct Heading {
    Place tip;
    bool reversed = false;
};

/// Order of two headings round x, counter-clockwise from straight down (exclusive).
[[nodiscard]] std::strong_ordering order_round(const Place& x, const Heading& a, const Heading& b);

}  // namespace sightline::reference
