// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/geom/plucker.hpp"
#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/shooting.hpp"

/// Free segments of space by definition (semantics 2.4, 3.1, 3.2), in exact numbers and through all
/// triangles, pieces and local pictures.
///
/// - B is the closed union of the solids and, with a world, of everything outside it. A point is in its
///   interior when all directions from it lead into solids: a piece of a face that two solids share
///   is interior, an edge or a point that they share need not be.
/// - A piece of the line is blocked when it lies in the interior of B.
/// - A maximal interval of the line inside the union W of the sheets, with something of the segment
///   before and after it, is crossed when the segment comes and leaves in different components
///   of the complement of W ∪ B near the interval, while B alone does not separate these. Where the segment
///   borders several components, it is not crossed when one of those it comes in is one of those it leaves in.
/// - A segment ends at the far end of an interval that it would cross. The sheets that stop it are those of
///   which each, without the others, is crossed; when there is none, all that it meets there.
///
/// Cost: O(n) predicates a piece, and O(k² n) where k planes meet on the line.

namespace sightline::reference {

/// Whether x is in the interior of B.
[[nodiscard]] bool is_interior(const Scene3& scene, const RationalPoint3& x);

/// Whether the segment pq is free. When p == q: whether p is not in the interior of B.
[[nodiscard]] bool is_free(const Scene3& scene, const RationalPoint3& p, const RationalPoint3& q);

/// Where the free segment from p in the given direction ends; p itself when the first step is
/// blocked. Contract: direction ≠ 0, and p is not in the interior of B.
[[nodiscard]] FreeEnd3 first_hit(const Scene3& scene, const RationalPoint3& p,
                                 const Vector3& direction);

/// The maximal free segments on a line, in its direction; the first end of a label is the one at which the
/// segment starts (labels as such sort their ends).
[[nodiscard]] std::vector<SegmentLabel> maximal_segments(const Scene3& scene,
                                                         const RationalLine3& line);
[[nodiscard]] std::vector<SegmentLabel> maximal_segments(const Scene3& scene,
                                                         const SurdLine3& line);

}  // namespace sightline::reference
