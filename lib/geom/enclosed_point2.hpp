// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A rational point prepared for the fast tiers. Private.

#include <cmath>
#include <concepts>
#include <utility>

#include "arith/interval_cgal.hpp"
#include "geom/error_bounded.hpp"
#include "geom/polynomials.hpp"
#include "sightline/arith/interval.hpp"
#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// A rational number with its smallest enclosing interval.
struct EnclosedNumber {
    explicit EnclosedNumber(Rational x) : exact(std::move(x)), range(enclosure(exact)) {}

    /// The number itself, or what a tier may know of it.
    template <typename Number>
    [[nodiscard]] Number as() const {
        if constexpr (std::same_as<Number, Rational>) {
            return exact;
        } else if constexpr (std::same_as<Number, IntervalNumber>) {
            return {range.lower, range.upper};
        } else if constexpr (std::same_as<Number, ErrorBounded>) {
            return {range.lower, range.upper - range.lower};
        } else {
            return range.lower;
        }
    }

    Rational exact;
    Interval range;
};

/// A rational point with its enclosures, made once and used in many predicates.
/// When is_input() it is the point input(), and predicates on Point2 are faster still.
struct EnclosedPoint2 {
    explicit EnclosedPoint2(const RationalPoint2& p)
        : x(p.x), y(p.y), base{finite(x.range), finite(y.range)} {}

    [[nodiscard]] bool is_input() const noexcept {
        return x.range.is_point() && y.range.is_point();
    }
    [[nodiscard]] const Point2& input() const noexcept { return base; }

    EnclosedNumber x;
    EnclosedNumber y;
    /// Some double point; near this one where doubles reach.
    Point2 base;

private:
    static double finite(const Interval& range) noexcept {
        return std::isfinite(range.lower)   ? range.lower
               : std::isfinite(range.upper) ? range.upper
                                            : 0;
    }
};

/// p - base.
template <typename Number>
[[nodiscard]] Homogeneous2<Number> homogeneous(const EnclosedPoint2& p, const Point2& base) {
    return {p.x.template as<Number>() - Number(base.x), p.y.template as<Number>() - Number(base.y),
            Number(1.0)};
}

[[nodiscard]] inline Point2 base_of(const EnclosedPoint2& p) { return p.base; }

/// Whether two points are at the same place.
[[nodiscard]] inline bool is_at(const Point2& p, const Point2& q) { return p == q; }
[[nodiscard]] inline bool is_at(const EnclosedPoint2& p, const Point2& q) {
    return p.is_input() && p.input() == q;
}

}  // namespace sightline::detail
