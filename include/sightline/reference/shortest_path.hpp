// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/planar/shortest_path.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// A shortest free path by its definition: Dijkstra's algorithm over all pairs of places that see each
/// other, with exact comparison of sums of square roots.
///
/// A path is free when its segments are and when it crosses no wall where it bends: walls and bodies part
/// the neighbourhood of a vertex into sectors; a path that comes in one sector leaves in the same one, or
/// in one that bodies alone part from it (through a pinhole). A path along a wall keeps to one of its
/// sides, and does not pass another wall that crosses it. An end on a wall belongs to both sides. A free
/// segment between the two ends is a free path, whatever it runs along.
///
/// Vertices at which the path goes straight on are no vertices of it. Of the shortest paths, the one with
/// the fewest vertices, and of these the one with the least sequence of ids (of vertices at one place, the
/// least id counts). With from == to: one point, no vertices, length 0.
/// Fails with inside_body, outside_of_world or unreachable.
///
/// O(n^3) predicates; exponential in the number of shortest paths of equal length.
[[nodiscard]] Result<ShortestPath> shortest_path(const Scene2& scene, const RationalPoint2& from,
                                                 const RationalPoint2& to,
                                                 const ShortestPathOptions& options = {});

}  // namespace sightline::reference
