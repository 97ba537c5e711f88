// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// The visibility graph by its definition (semantics 4.1): every pair of vertices is tested. Exact
/// whatever `options.arithmetic` says; one thread.
///
/// - u, w at different places are adjacent when the segment is free and, with `nearest_only`,
/// contains
///   no other scene vertex. Vertices at one place are not adjacent, and have the same neighbours.
/// - `tangent_only` keeps an edge when at either end the segment stays free if it is extended a
/// little
///   beyond that end.
/// - Without `body_edges`, an edge that lies on boundaries of bodies or of the world, all along, is
/// left
///   out.
///
/// O(n) tests of O(edges in that direction) each, per vertex.
[[nodiscard]] VisibilityGraph visibility_graph(const Scene2& scene,
                                               const VisibilityGraphOptions& options = {});

/// One row of it: the neighbours of v, ascending.
[[nodiscard]] std::vector<VertexId> visible_from(const Scene2& scene, VertexId v,
                                                 const VisibilityGraphOptions& options = {});

}  // namespace sightline::reference
