// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/boundary_sweep.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

/// A ring, wall or point of the input and where its vertices went.
struct ChainRecord {
    enum class Kind : std::uint8_t { outer, hole, wall, point };
    Kind kind = Kind::outer;
    std::uint32_t element = 0;
    std::uint32_t hole = 0;          ///< number of the hole within its polygon
    std::uint32_t first_vertex = 0;  ///< its vertices are consecutive
    std::uint32_t vertex_count = 0;
    std::uint32_t first_edge = 0;
    std::uint32_t edge_count = 0;
    Owner owner = free_space;
    bool is_body_hole = false;  ///< free inside
    bool reversed = false;      ///< its edges run against the numbering
};

/// The flattened input: what a Scene2 stores, and which element each part came
/// from.
struct SceneLayout {
    const SceneInput2* input = nullptr;
    std::vector<Point2> vertices;
    std::vector<Edge2> edges;
    std::vector<ChainRecord> chains;  ///< in input order
    std::uint32_t body_count = 0;

    [[nodiscard]] const ChainRecord& chain_of_vertex(VertexId v) const;
    [[nodiscard]] const ChainRecord& chain_of_edge(std::uint32_t e) const;
    [[nodiscard]] const ChainRecord* outer_ring_of(Owner owner) const;
    /// `file:line: `, or nothing.
    [[nodiscard]] std::string origin(std::uint32_t element) const;
    /// "element 2 (polygon), hole 1".
    [[nodiscard]] std::string name_of_chain(const ChainRecord& chain) const;
    /// "element 2 (polygon), hole 1, vertex 4 (3, 5)".
    [[nodiscard]] std::string name_of_vertex(VertexId v) const;
    /// "element 2 (polygon), hole 1, edge 4 (3 5, 4 6)".
    [[nodiscard]] std::string name_of_edge(std::uint32_t e) const;
};

/// Flattens and checks each ring and wall by itself; then orients the rings.
[[nodiscard]] Result<SceneLayout> lay_out(const SceneInput2& input);

/// The error for what the sweep found.
[[nodiscard]] Error describe_fault(const SceneLayout& layout, const SweepFault& fault);

/// The first wall that meets the interior of a body or lies outside of the
/// world, if any. `inside`: what the sweep said about the walls' vertices.
[[nodiscard]] Result<void> check_walls(const SceneLayout& layout,
                                       const std::vector<SweepInside>& inside);

/// Whether p lies strictly inside (positive), on (zero) or outside (negative)
/// of a closed chain.
[[nodiscard]] Sign side_of_ring(const SceneLayout& layout, const ChainRecord& ring,
                                const Point2& p);

}  // namespace sightline::detail
