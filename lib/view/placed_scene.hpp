// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What every view of one scene shares: its edges by place, what is at them, and the hierarchy. Private.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/bvh.hpp"

namespace sightline::detail {

constexpr std::uint32_t no_edge = std::numeric_limits<std::uint32_t>::max();

/// All feature edges between the same two vertices: one segment of space.
struct PlacedEdge {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    /// Its feature edges: PlacedScene::edge_ids[first, last).
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool is_sheet = false;
};

/// A piece of a face, with the edges that its sides lie on.
struct PlacedTriangle {
    std::array<std::uint32_t, 3> corners{};
    /// Side k runs from corner k to corner k + 1; no_edge for diagonals of the face.
    std::array<std::uint32_t, 3> edges{};
    std::uint32_t face = 0;
};

struct PlacedScene {
    explicit PlacedScene(const Scene3& scene);

    const Scene3* scene;
    std::vector<PlacedEdge> edges;
    std::vector<EdgeId> edge_ids;
    /// Per feature edge of a solid: whether the solid fills more than half of what is round it.
    std::vector<char> is_reflex;
    std::vector<PlacedTriangle> triangles;
    std::vector<char> face_is_sheet;
    std::vector<char> is_feature;
    /// Per vertex: the placed edges that end there.
    std::vector<std::uint32_t> first_at;
    std::vector<std::uint32_t> edges_at;
    Bvh bvh;  ///< of the triangles
    bool has_sheets = false;
    bool has_world = false;

    [[nodiscard]] std::span<const EdgeId> ids(const PlacedEdge& e) const {
        return {edge_ids.data() + e.first, edge_ids.data() + e.last};
    }
    [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t vertex) const {
        return {edges_at.data() + first_at[vertex], edges_at.data() + first_at[vertex + 1]};
    }
    [[nodiscard]] const Point3& point(std::uint32_t vertex) const {
        return scene->vertices()[vertex];
    }
};

}  // namespace sightline::detail
