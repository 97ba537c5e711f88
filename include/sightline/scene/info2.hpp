// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline {

/// Where two bodies, or a body and the outside of the world (none), touch.
struct BodyContact2 {
    BodyId first;
    BodyId second;
    std::size_t points = 0;  ///< places where they meet in a point only: pinholes
    std::size_t edges = 0;   ///< pairs of edges with a common piece: sealed

    friend bool operator==(const BodyContact2&, const BodyContact2&) = default;
};

/// What a scene holds, and how degenerate it is. Lists are ascending.
struct SceneInfo2 {
    std::size_t vertices = 0;
    std::size_t points = 0;
    std::size_t bodies = 0;
    std::size_t holes = 0;  ///< of bodies
    std::size_t body_edges = 0;
    std::size_t world_edges = 0;
    std::size_t walls = 0;
    bool has_world = false;
    Point2 low;   ///< least coordinates
    Point2 high;  ///< greatest coordinates

    std::vector<BodyContact2> contacts;
    /// Places with several vertices.
    std::vector<std::vector<VertexId>> coincident;
    /// Places where the rings of one body touch themselves or each other; the least vertex there.
    std::vector<VertexId> pinches;
    /// Vertices with their two edges of a ring or wall on one line.
    std::vector<VertexId> straight;
    /// Not straight, but a move of the vertex by 4 ulps of its coordinates could make it so.
    std::vector<VertexId> nearly_straight;
    /// A vertex in the relative interior of an edge (of a body, the world or a wall).
    std::vector<std::pair<VertexId, EdgeId>> vertices_on_edges;
    std::size_t crossing_walls = 0;     ///< pairs that cross in a point inside both
    std::size_t overlapping_walls = 0;  ///< pairs with a common piece
    /// False when there are so many pairs that counting stopped: the two numbers are lower bounds.
    bool all_walls_compared = true;

    double approx_shortest_edge = 0;  ///< 0 without edges
    double approx_extent = 0;         ///< the longer side of the bounding box

    /// Whether any list or number above says that something is degenerate.
    [[nodiscard]] bool is_degenerate() const noexcept;

    friend bool operator==(const SceneInfo2&, const SceneInfo2&) = default;
};

/// Counts and lists; exact but for the fields named approx_ and for nearly_straight, a hint.
/// Cost O((n + touching pairs) log n).
[[nodiscard]] SceneInfo2 describe(const Scene2& scene);

/// A line a fact, for people; long lists are cut after eight.
[[nodiscard]] std::string to_text(const SceneInfo2& info);
std::ostream& operator<<(std::ostream& out, const SceneInfo2& info);

}  // namespace sightline
