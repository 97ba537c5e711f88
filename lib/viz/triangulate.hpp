// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sightline/viz/draw_list.hpp"

namespace sightline::viz::detail {

struct Triangles {
    std::vector<Position> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise, places in `points`
};

/// The inside of a polygon (even-odd rule) as triangles; any rings, also ones that touch, repeat or
/// cross. Corners are the polygon's own except where its edges cross. O(n log n) in practice.
[[nodiscard]] Triangles triangulate(const Polygon& polygon);

}  // namespace sightline::viz::detail
