// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "sightline/scene/scene3.hpp"

namespace sightline {

/// Where two bodies touch, or one body (first == second) touches itself.
struct BodyContact3 {
    BodyId first;
    BodyId second;
    std::size_t places = 0;  ///< vertices on the other one's surface, and points where edges cross
    std::size_t edges = 0;   ///< pairs of edges with a common piece
    std::size_t faces = 0;   ///< pairs of faces with a common piece: sealed, between solids

    friend bool operator==(const BodyContact3&, const BodyContact3&) = default;
};

/// What a scene of space holds, and how degenerate it is. Lists are ascending.
struct SceneInfo3 {
    std::size_t vertices = 0;
    std::size_t feature_vertices = 0;
    std::size_t edges = 0;
    std::size_t border_edges = 0;  ///< of sheets
    std::size_t faces = 0;
    std::size_t input_faces = 0;
    std::size_t holes = 0;  ///< of faces
    std::size_t triangles = 0;
    std::size_t solids = 0;  ///< bodies that are solid, without the world
    std::size_t sheets = 0;
    bool has_world = false;
    Point3 low;   ///< least coordinates
    Point3 high;  ///< greatest coordinates

    std::vector<BodyContact3> contacts;
    /// Places with several feature vertices.
    std::vector<std::vector<VertexId>> coincident;
    /// Vertices that lie on no surface.
    std::vector<VertexId> isolated;
    /// Vertices on surfaces that are no features: inside of a merged face, on a straight edge, or unused.
    std::vector<VertexId> flat;
    /// Planes with several faces, of one body or of several.
    std::vector<std::vector<FaceId>> coplanar;
    /// Lines with several edges.
    std::vector<std::vector<EdgeId>> collinear;
    /// Edges that are parallel to another edge, and the number of their directions.
    std::size_t parallel_edges = 0;
    std::size_t parallel_directions = 0;
    /// Edges whose two faces would be coplanar if a vertex were moved by 4 ulps of its coordinates.
    std::vector<EdgeId> nearly_flat;

    double approx_shortest_edge = 0;
    double approx_extent = 0;  ///< the longest side of the bounding box

    /// Whether bodies touch, features share places, planes or lines, or vertices are none; parallel edges alone don't
    /// count.
    [[nodiscard]] bool is_degenerate() const noexcept;

    friend bool operator==(const SceneInfo3&, const SceneInfo3&) = default;
};

/// Counts and lists; exact but for the fields named approx_ and for nearly_flat, a hint.
/// Cost O((n + touching pairs) log n).
[[nodiscard]] SceneInfo3 describe(const Scene3& scene);

/// A line a fact, for people; long lists are cut after eight.
[[nodiscard]] std::string to_text(const SceneInfo3& info);
std::ostream& operator<<(std::ostream& out, const SceneInfo3& info);

}  // namespace sightline
