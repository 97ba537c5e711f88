// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <iosfwd>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "sightline/event/swath.hpp"
#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/free_segment3.hpp"

/// Critical lines: those that features fix, each named by its generators. Whether something blocks them
/// is not asked here. Docs: docs/structures/visual-events.md.

namespace sightline {

/// The line through two vertices.
struct VV {
    VertexId first;
    VertexId second;

    friend auto operator<=>(const VV&, const VV&) = default;
};

/// In the plane of a face, the line through a vertex in that plane and the point where an edge meets it.
struct FvE {
    FaceId face;
    VertexId vertex;
    EdgeId edge;

    friend auto operator<=>(const FvE&, const FvE&) = default;
};

/// The line through a vertex that meets two edges.
struct VEE {
    VertexId vertex;
    std::array<EdgeId, 2> edges;

    friend auto operator<=>(const VEE&, const VEE&) = default;
};

/// The line in which the planes of two faces meet.
struct FF {
    std::array<FaceId, 2> faces;

    friend auto operator<=>(const FF&, const FF&) = default;
};

/// The line in the plane of a face through the two points where edges meet it.
struct FEE {
    FaceId face;
    std::array<EdgeId, 2> edges;

    friend auto operator<=>(const FEE&, const FEE&) = default;
};

/// The lines that meet four edges: two at most, if finitely many.
struct EEEE {
    std::array<EdgeId, 4> edges;

    friend auto operator<=>(const EEEE&, const EEEE&) = default;
};

using CriticalLine = std::variant<VV, FvE, VEE, FF, FEE, EEEE>;

/// "VV", "FvE", "VEE", "FF", "FEE", "EEEE".
[[nodiscard]] std::string_view name_of(const CriticalLine& line) noexcept;
/// "VEE v1 e2 e3".
std::ostream& operator<<(std::ostream& out, const CriticalLine& line);

/// Coordinates, exact and scaled: all lines that meet the carriers of the generators, ascending. More than
/// one only for EEEE; none when the generators fix no line: two vertices at one place, an edge
/// parallel to the plane, a vertex in one plane with two edges, lines that meet four edges in families.
[[nodiscard]] std::vector<SurdLine3> lines_of(const CriticalLine& line, const Scene3& scene);

/// The line through an edge, from its source to its target.
[[nodiscard]] RationalLine3 carrier(EdgeId edge, const Scene3& scene);
/// The plane of a face; its normal points to where the face is counter-clockwise.
[[nodiscard]] Plane3 plane_of(FaceId face, const Scene3& scene);

/// Whether a line meets the relative interior of an edge in one point.
[[nodiscard]] bool meets_inside(const SurdLine3& line, EdgeId edge, const Scene3& scene);

/// What passes through all vertices of a support and meets the carriers of its edges: isolated lines, for
/// nodes, and swaths, for arcs. `along` is not looked at.
[[nodiscard]] LineFamilies families_of(const Support& support, const Scene3& scene);

/// The isolated lines of families_of that meet the relative interiors of the edges: where the nodes with this
/// support lie, ascending.
[[nodiscard]] std::vector<SurdLine3> lines_of(const Support& support, const Scene3& scene);

/// The same for lines that lie in the planes of faces, too: what touches only a corner of a face, in its plane, is
/// fixed by that plane.
[[nodiscard]] std::vector<SurdLine3> lines_of(const Support& support, std::span<const FaceId> faces,
                                              const Scene3& scene);

}  // namespace sightline
