// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "reference/exact3.hpp"
#include "reference/line_picture3.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline::reference::detail {

/// Features met at one point of a segment; ascending.
struct Place {
    std::vector<VertexId> vertices;
    std::vector<EdgeId> edges;

    friend auto operator<=>(const Place&, const Place&) = default;
};

/// What the segments of a cell have in common. Two segments that can be moved into each other without a
/// change of it are in one cell.
struct Cell {
    SegmentLabel label;
    std::vector<Place> places;  ///< sorted
    /// The faces in which what blocks the line behind an end runs: between bodies in contact.
    std::vector<FaceId> contact;

    friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// The lines that keep the conditions of a cell, near one of them.
struct Freedom {
    int dimension = 0;
    /// For dimension 1: the pencil that they are; else a regulus.
    struct Pencil {
        RationalTriple point;
        Plane plane;

        friend bool operator==(const Pencil&, const Pencil&) = default;
    };
    std::optional<Pencil> pencil;
};

[[nodiscard]] Freedom freedom(const ExactScene& scene, const Cell& cell);

/// The faces of which the segment touches a vertex or two edges, and in whose plane the line lies.
[[nodiscard]] std::vector<FaceId> faces_in_plane(const ExactScene& scene, const Cell& cell,
                                                 const ExactLine& line);
[[nodiscard]] NodeType node_type(const ExactScene& scene, const Cell& cell, const ExactLine& line);
[[nodiscard]] ArcType arc_type(const ExactScene& scene, const Cell& cell, const Freedom& freedom);

/// Which of the two common transversals of the cell's edges the line is, when there are two.
[[nodiscard]] Root root_of(const ExactScene& scene, const Cell& cell, const ExactLine& line);

}  // namespace sightline::reference::detail
