// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace sightline::viz::detail {

/// A point of the drawing grid.
struct GridPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

using GridSegment = std::pair<GridPoint, GridPoint>;

/// Decomposes segments into chains that run along each distinct segment once (segments without
/// length count, as a dot). Canonical: depends on the set of segments only. O(n log n).
[[nodiscard]] std::vector<std::vector<GridPoint>> trails(std::vector<GridSegment> segments);

}  // namespace sightline::viz::detail
