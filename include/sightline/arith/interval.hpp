// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>

#include "sightline/arith/rational.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline {

/// A closed interval of real numbers with double ends, lower <= upper; an end may be infinite.
///
/// A plain result: an enclosure of a number that is not a double. It has no arithmetic; what
/// computes intervals is private and rounds outward.
struct Interval {
    double lower = 0;
    double upper = 0;

    [[nodiscard]] constexpr bool contains(double x) const noexcept {
        return lower <= x && x <= upper;
    }
    [[nodiscard]] bool contains(const Rational& x) const;
    [[nodiscard]] constexpr bool contains(const Interval& other) const noexcept {
        return lower <= other.lower && other.upper <= upper;
    }
    [[nodiscard]] constexpr bool overlaps(const Interval& other) const noexcept {
        return lower <= other.upper && other.lower <= upper;
    }
    /// Whether it holds one number only.
    [[nodiscard]] constexpr bool is_point() const noexcept { return lower == upper; }
    /// The sign of every number in it; empty when they differ.
    [[nodiscard]] constexpr std::optional<Sign> sign() const noexcept {
        if (lower > 0) return Sign::positive;
        if (upper < 0) return Sign::negative;
        if (lower == 0 && upper == 0) return Sign::zero;
        return std::nullopt;
    }
    /// A double in the interval, near its middle, for drawing and reports.
    [[nodiscard]] double approx_middle() const noexcept;

    friend constexpr bool operator==(const Interval&, const Interval&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Interval& x);
};

/// The smallest interval that contains x: one double, or two neighbours.
[[nodiscard]] Interval enclosure(const Rational& x);

}  // namespace sightline
