// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/interval.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline {

struct ShortestPathOptions {
    Arithmetic arithmetic = Arithmetic::filtered;
    /// No effect on the result. 0: one a core.
    unsigned threads = 1;
    Tally* tally = nullptr;
};

/// A shortest free path: `from`, scene vertices, `to`.
struct ShortestPath {
    std::vector<RationalPoint2> points;  ///< ends included
    std::vector<VertexId> vertices;      ///< the scene vertices in between
    Interval length;                     ///< certified: the true length lies inside
};

/// A shortest path between two points outside the interior of B. Of several of certified equal or
/// undecidably close length the one with the fewest vertices, then the lexicographically least ids, wins.
/// Fails with inside_body, outside_of_world, unreachable, or coordinate_too_large (an end beyond 2^1020).
[[nodiscard]] Result<ShortestPath> shortest_path(const Scene2& scene, const RationalPoint2& from,
                                                 const RationalPoint2& to,
                                                 const ShortestPathOptions& options = {});

}  // namespace sightline
