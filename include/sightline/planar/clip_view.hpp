// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sightline/planar/visibility_polygon.hpp"

namespace sightline {

/// A closed axis-parallel box, low < high in both coordinates.
struct RationalBox2 {
    RationalPoint2 low;
    RationalPoint2 high;

    [[nodiscard]] bool contains(const RationalPoint2& p) const {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
    }
    friend bool operator==(const RationalBox2&, const RationalBox2&) = default;
};

/// The part of what `from` sees that lies in the box, in the canonical form of exact_ring and without
/// vertices at infinity: as if the box were the outer boundary of the world. `ring` is an exact_ring;
/// the box must contain `from` (SIGHTLINE_EXPECT). What meets the box in its boundary only is dropped.
///
/// What is seen is star-shaped about `from` and a half-plane that contains `from` keeps it so; hence
/// clipping edge by edge is right (Sutherland, Hodgman, "Reentrant polygon clipping", 1974). O(n).
[[nodiscard]] std::vector<ViewPoint> clipped_ring(const RationalPoint2& from,
                                                  std::span<const ViewPoint> ring,
                                                  const RationalBox2& box);

/// The part of a needle in the box; empty when no segment of it is there.
[[nodiscard]] std::optional<std::pair<ViewPoint, ViewPoint>> clipped_needle(
    const RationalPoint2& from, const std::pair<ViewPoint, ViewPoint>& needle,
    const RationalBox2& box);

}  // namespace sightline
