// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sightline/event/segment_file.hpp"
#include "sightline/event/transversals.hpp"

/// Lines tangent to four triangles: through a boundary point of each, and entering none.
///
/// Rules for degenerate cases
///  (1) A line enters a triangle when it meets its inside: in one point, or along a chord when it
///      lies in the plane. A line along an edge, or through a corner, does not.
///  (2) A line is listed as a line when no other tangent is near it, otherwise it belongs to a
///      component, as with transversals().
///  (3) Pencils in the plane of a triangle are cut down to lines that do not enter it; that plane
///      holds no larger family. Any other family may have single lines that lie in a triangle's
///      plane and enter it: these are to be left out of it (is_tangent()).
///  (4) A line that meets several edges of a triangle has the first of them in its support.

namespace sightline {

/// The edge of a triangle from corner i to corner i + 1.
[[nodiscard]] RationalSegment3 edge_of(const RationalTriangle3& triangle, std::size_t i);

/// The certificate: whether the line goes through a boundary point and does not enter the triangle.
[[nodiscard]] bool is_tangent(const SurdLine3& line, const RationalTriangle3& triangle);

struct TriangleTangents {
    struct Line {
        std::array<std::uint8_t, 4> edges;  ///< rule (4), one of each triangle
        std::uint8_t root = 0;              ///< among the lines of these edges' lines
        SurdLine3 line;                     ///< scaled
    };
    std::vector<Line> lines;                       ///< ascending by edges, then by line
    std::vector<TransversalComponent> components;  ///< by kind, plane, point
};

/// All lines tangent to four triangles. Exact; general position has at most 162 of them.
/// Cost: 81 times that of transversals(). \cite bronnimann_devillers_lazard_sottile_2007
[[nodiscard]] TriangleTangents triangle_tangents(const std::array<RationalTriangle3, 4>& triangles);

}  // namespace sightline
