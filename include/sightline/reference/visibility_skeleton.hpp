// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sightline/arith/surd.hpp"
#include "sightline/geom/plucker.hpp"
#include "sightline/scene/scene3.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline::reference {

/// A maximal free segment on a given line.
struct FreeSegment3 {
    SegmentLabel label;
    /// t of its ends, of the points of the line that have the value t in the first coordinate in
    /// which the line's direction is not zero; empty at infinity. from < to.
    std::optional<Surd> from;
    std::optional<Surd> to;
    /// What stops it at `from` and at `to` (in the label these are sorted).
    std::array<SegmentEnd, 2> ends;
    /// The dimension of its cell.
    int dimension = 0;

    friend bool operator==(const FreeSegment3&, const FreeSegment3&) = default;
};

/// All maximal free segments on a line (semantics 2.4, 3.1, 3.2), in ascending order of t.
///
/// The line is cut at all points where it meets faces, edges and vertices. A piece in between is blocked when it
/// lies inside a solid, or on the boundaries of several whose cross-sections round the line cover the disc. An
/// interval of the line in sheets blocks when they separate, near it, the cells in which the line comes from those
/// in which it leaves; then the segment on either side goes on through the interval to its far end.
///
/// Contract: the line's coordinates are of one quadratic field. O(n) predicates, and O(k² n) for k planes
/// that meet at a sheet.
[[nodiscard]] std::vector<FreeSegment3> maximal_free_segments(const Scene3& scene,
                                                              const SurdLine3& line);

/// The visibility skeleton by its definition, in exact numbers: every one-parameter family of lines that features
/// generate (lines through a point and an edge; lines that meet three skew edges) is cut at all lines of it that
/// meet another feature; one line between two neighbours, and each of those, is asked for the maximal free segment
/// that touches the generators, its label, and the dimension of the conditions that the label keeps.
///
/// Degeneracy rules beyond those of VisibilitySkeleton
///  (1) Where the line, behind an end, runs between solids in contact, it must do so for the ends to stay equal:
///      the planes of those faces are conditions of the cell, too. So lines in the plane of a contact that end at
///      its border are told from those that enter one of the bodies there.
///  (2) An edge that the segment runs along without reaching both its vertices fixes the line.
///  (3) An arc may end in a segment that by its own support has one degree of freedom: lines in the plane of a face
///      that meet two of its edges and another edge e, up to the one through the vertex v that the two share, which
///      like its neighbours round v touches v and e only. That segment is a node (FvE), and cuts the arc of its
///      neighbours in two; both, like the node, have the same label.
///
/// Cost: O(n³) families of O(n) lines, O(n) exact predicates each.
[[nodiscard]] VisibilitySkeleton visibility_skeleton(const Scene3& scene);

}  // namespace sightline::reference
