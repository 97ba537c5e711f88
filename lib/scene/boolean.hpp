// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/geom/polygon2.hpp"

namespace sightline::detail {

/// Polygons that a Boolean operation gave, rounded.
struct BooleanResult {
    std::vector<Polygon2> polygons;
    /// Coordinates pairs that were not doubles and now are the nearest ones.
    std::size_t rounded_vertices = 0;
};

/// The union of polygons, each valid by itself.
[[nodiscard]] BooleanResult unite(const std::vector<Polygon2>& polygons);
/// The part of a polygon that lies in the closed inside of a ring, both valid by themselves.
[[nodiscard]] BooleanResult clip(const Polygon2& polygon, const Ring2& ring);

}  // namespace sightline::detail
