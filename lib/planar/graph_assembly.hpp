// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/triangulation.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline::detail {

/// Half rows of consecutive places, as one worker found them.
struct HalfRows {
    Place first = 0;                  ///< the place of the first row
    std::vector<std::uint64_t> ends;  ///< where each row ends in `places`
    std::vector<Place> places;
};

/// The graph on vertices from all half rows (ascending by `first`): symmetric, each row ascending.
[[nodiscard]] VisibilityGraph assemble(const Triangulation& t, std::vector<HalfRows> rows,
                                       unsigned threads);

}  // namespace sightline::detail
