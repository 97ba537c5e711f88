// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sightline/arith/sign.hpp"

namespace sightline {

/// The predicates that are counted; one row each in every result's `stats.predicates`.
enum class Predicate : std::uint8_t {
    orientation2,          ///< side of a line through two points
    order_along_line2,     ///< order of two points along a direction
    order_of_directions2,  ///< counter-clockwise order of directions round a point
    constructed_order2,    ///< comparisons that involve an intersection point
    point_location2,       ///< tests made while locating a query point
    orientation3,          ///< side of a plane through three points
    side_of_line3,         ///< how one line passes another
    line_plane3,           ///< how a line passes a plane
    transversals3,         ///< whether lines meet four segments, and where
    line_form3,            ///< sign of a linear form on a constructed line
    curve_parameter3,      ///< roots on a one-parameter family of lines, and their order
    image_orientation3,    ///< side of a plane through the viewpoint and two points
    constructed_order3,    ///< order along an edge of where other edges pass before it
    count_
};

/// The name under which a predicate appears in JSON.
[[nodiscard]] std::string_view name_of(Predicate predicate) noexcept;

/// How many calls of one predicate each tier decided.
struct TierCounts {
    std::uint64_t calls = 0;
    std::uint64_t filter = 0;
    std::uint64_t interval = 0;
    std::uint64_t exact = 0;
    std::uint64_t undecided = 0;

    TierCounts& operator+=(const TierCounts& other) noexcept;
    friend bool operator==(const TierCounts&, const TierCounts&) = default;
};

/// Counts of deciding tiers, per predicate. Plain values: a thread has its own, sums are exact.
class Tally {
public:
    [[nodiscard]] TierCounts& operator[](Predicate p) noexcept {
        return counts_[static_cast<std::size_t>(p)];
    }
    [[nodiscard]] const TierCounts& operator[](Predicate p) const noexcept {
        return counts_[static_cast<std::size_t>(p)];
    }
    /// Counts one call of p that `tier` decided.
    void add(Predicate p, Tier tier) noexcept;
    Tally& operator+=(const Tally& other) noexcept;
    friend bool operator==(const Tally&, const Tally&) = default;

private:
    std::array<TierCounts, static_cast<std::size_t>(Predicate::count_)> counts_{};
};

}  // namespace sightline
