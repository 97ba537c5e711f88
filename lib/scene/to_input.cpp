// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "sightline/scene/scene_io.hpp"

namespace sightline {
namespace {

/// The first vertex of a ring in the numbering, and its element under construction.
struct Placed {
    std::uint32_t first = 0;
    SceneElement2 element;
};

Ring2 vertices_of(const Scene2& scene, const RingRange2& ring, std::uint32_t first) {
    const auto vertices = scene.vertices().subspan(first, ring.count);
    return {vertices.begin(), vertices.end()};
}

/// The world's ring takes the rings of plain bodies that follow it as holes; a body takes its own.
void add_rings(const Scene2& scene, std::vector<Placed>& placed) {
    const std::span<const RingRange2> rings = scene.rings();
    std::uint32_t next_vertex = 0;
    bool last_is_world = false;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const std::uint32_t first = scene[rings[i].first].source.value;
        const bool follows = i > 0 && first == next_vertex;
        const bool is_plain = !rings[i].is_hole && !(i + 1 < rings.size() && rings[i + 1].is_hole);
        const bool is_hole = rings[i].is_hole || (last_is_world && follows && is_plain);
        next_vertex = first + rings[i].count;
        if (is_hole) {
            std::get<Polygon2>(placed.back().element)
                .holes.push_back(vertices_of(scene, rings[i], first));
            continue;
        }
        last_is_world = rings[i].body.is_none();
        placed.push_back({first, Polygon2{vertices_of(scene, rings[i], first), {}}});
    }
}

void add_walls(const Scene2& scene, std::vector<Placed>& placed) {
    VertexId end = VertexId::none();
    for (const Edge2& edge : scene.edges()) {
        if (edge.kind != EdgeKind2::wall) continue;
        if (edge.source != end) {
            placed.push_back({edge.source.value, Polyline2{{scene[edge.source]}}});
        }
        std::get<Polyline2>(placed.back().element).points.push_back(scene[edge.target]);
        end = edge.target;
    }
}

}  // namespace

SceneInput2 to_input(const Scene2& scene) {
    std::vector<Placed> placed;
    add_rings(scene, placed);
    add_walls(scene, placed);
    for (const VertexId v : scene.points()) placed.push_back({v.value, scene[v]});
    std::vector<std::pair<std::uint32_t, std::size_t>> order;
    order.reserve(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i) order.emplace_back(placed[i].first, i);
    std::sort(order.begin(), order.end());
    SceneInput2 input;
    input.world = scene.has_world();
    for (const auto& [first, i] : order) input.elements.push_back(std::move(placed[i].element));
    return input;
}

}  // namespace sightline
