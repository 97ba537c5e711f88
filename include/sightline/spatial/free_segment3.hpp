// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "sightline/scene/id.hpp"

namespace sightline {

/// A face as something that stops a segment: for a sheet, the side that is hit. The front is the side from
/// which the face is seen counter-clockwise; a solid's face is only hit at its front.
struct FaceSide {
    FaceId face;
    bool back = false;

    friend constexpr auto operator<=>(const FaceSide&, const FaceSide&) = default;
};

/// Where a free segment ends: the faces whose closure contains the end point and that bound what stops the
/// segment there, ascending; empty at infinity.
///
/// What stops a segment at a point is the set of solids that contain the blocked piece of its line behind that
/// point, inside or on their boundary (a piece that runs between two solids in contact is blocked by both), or
/// the sheet that it crosses there. A segment that lies in the plane of a sheet's face hits its front.
using SegmentEnd = std::vector<FaceSide>;

/// The features that a free segment touches, its ends included; each list ascending.
struct Support {
    /// Feature vertices on the segment.
    std::vector<VertexId> vertices;
    /// Feature edges met in their relative interior, without those that the segment runs along.
    std::vector<EdgeId> edges;
    /// Feature edges that share a piece of positive length with the segment and do not have both their
    /// vertices on it.
    std::vector<EdgeId> along;

    friend auto operator<=>(const Support&, const Support&) = default;
};

/// What tells one cell of maximal free segments from others: support and ends. The two ends are sorted.
struct SegmentLabel {
    Support support;
    std::array<SegmentEnd, 2> ends;

    friend auto operator<=>(const SegmentLabel&, const SegmentLabel&) = default;
    /// "v1 v2 e3 along e4 | f1 f2- | inf"; a sheet's back has a minus.
    friend std::ostream& operator<<(std::ostream& out, const SegmentLabel& label);
};

}  // namespace sightline
