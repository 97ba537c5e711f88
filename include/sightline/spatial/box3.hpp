// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "sightline/geom/point.hpp"

namespace sightline {

/// A closed axis-parallel box with double corners. Boxes of double points need no rounding: only
/// minima and maxima are taken. The default box is empty: it contains nothing, and including
/// something in it gives that thing's box.
struct Box3 {
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    std::array<double, 3> low = {infinite, infinite, infinite};
    std::array<double, 3> high = {-infinite, -infinite, -infinite};

    [[nodiscard]] static constexpr Box3 of(const Point3& p) {
        return {{p.x, p.y, p.z}, {p.x, p.y, p.z}};
    }
    [[nodiscard]] static constexpr Box3 of(const Point3& a, const Point3& b) {
        Box3 box = of(a);
        box.include(b);
        return box;
    }
    [[nodiscard]] static constexpr Box3 of(const Point3& a, const Point3& b, const Point3& c) {
        Box3 box = of(a, b);
        box.include(c);
        return box;
    }

    constexpr void include(const Box3& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
    constexpr void include(const Point3& p) { include(of(p)); }

    [[nodiscard]] constexpr bool is_empty() const { return !(low[0] <= high[0]); }

    /// Whether the two closed boxes have a point in common.
    [[nodiscard]] constexpr bool meets(const Box3& other) const {
        // Without branches: which axis separates two boxes cannot be foretold.
        return (low[0] <= other.high[0]) & (other.low[0] <= high[0]) & (low[1] <= other.high[1]) &
               (other.low[1] <= high[1]) & (low[2] <= other.high[2]) & (other.low[2] <= high[2]);
    }
    [[nodiscard]] constexpr bool contains(const Box3& other) const {
        return other.is_empty() ||
               (low[0] <= other.low[0] && other.high[0] <= high[0] && low[1] <= other.low[1] &&
                other.high[1] <= high[1] && low[2] <= other.low[2] && other.high[2] <= high[2]);
    }
    [[nodiscard]] constexpr bool contains(const Point3& p) const { return contains(of(p)); }

    /// The corner whose coordinate i is the high one where bit i of `which` (0 to 7) is set.
    [[nodiscard]] constexpr Point3 corner(unsigned which) const {
        return {(which & 1U) != 0 ? high[0] : low[0], (which & 2U) != 0 ? high[1] : low[1],
                (which & 4U) != 0 ? high[2] : low[2]};
    }

    friend constexpr bool operator==(const Box3&, const Box3&) = default;
};

}  // namespace sightline
