// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/geom/point.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// Whether the segment pq is free (semantics 2.4): it meets the interior of B nowhere, and crosses
/// W nowhere. By definition: every elementary interval and every maximal interval inside a wall is
/// looked at, in exact numbers.
///
/// - B is the closed union of the bodies and, with a world, of everything outside it. A piece of an
/// edge
///   that two bodies share is interior to B; a single point that they share is a free pinhole.
/// - Grazing vertices and edges and running along edges and walls is free.
/// - A maximal interval of the segment inside W, not reaching an end of the segment, is blocked
/// when the
///   segment comes and leaves in different components of the complement of W ∪ B near the interval
///   and B alone does not separate these.
/// - When p == q: whether the point is not in the interior of B.
///
/// O(n) predicates when nothing degenerate lies on the segment.
[[nodiscard]] bool is_free(const Scene2& scene, const RationalPoint2& p, const RationalPoint2& q);

/// The same between the places of two vertices.
[[nodiscard]] bool is_free(const Scene2& scene, VertexId u, VertexId w);

}  // namespace sightline::reference
