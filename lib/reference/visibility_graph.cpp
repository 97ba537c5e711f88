// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/visibility_graph.hpp"

#include "reference/fan.hpp"
#include "reference/sight_line.hpp"

namespace sightline::reference {
namespace {

bool is_edge(const SightLine& line, const VisibilityGraphOptions& options) {
    if (options.collinear == Collinear::nearest_only && line.passes_vertex()) return false;
    if (!line.is_free()) return false;
    if (!options.body_edges && line.runs_along_bodies()) return false;
    return !options.tangent_only ||
           (line.is_free({.beyond_p = true}) && line.is_free({.beyond_q = true}));
}

// The neighbours of v with ids from `first` on.
std::vector<VertexId> row(const Scene2& scene, VertexId v, std::uint32_t first,
                          const VisibilityGraphOptions& options) {
    std::vector<VertexId> result;
    if (is_interior(scene, scene[v])) return result;  // sealed in from all sides
    const Fan fan(scene, v);
    for (std::uint32_t i = first; i < scene.vertex_count(); ++i) {
        const Point2& w = scene[VertexId{i}];
        if (w == scene[v]) continue;
        const SightLine line(scene, fan.towards(w), scene[v], w, Reach::segment);
        if (is_edge(line, options)) result.push_back(VertexId{i});
    }
    return result;
}

}  // namespace

std::vector<VertexId> visible_from(const Scene2& scene, VertexId v,
                                   const VisibilityGraphOptions& options) {
    return row(scene, v, 0, options);
}

VisibilityGraph visibility_graph(const Scene2& scene, const VisibilityGraphOptions& options) {
    std::vector<VisibilityGraph::Edge> edges;
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        for (const VertexId w : row(scene, VertexId{i}, i + 1, options)) {
            edges.emplace_back(VertexId{i}, w);
        }
    }
    return VisibilityGraph::from_edges(scene.vertex_count(), std::move(edges));
}

}  // namespace sightline::reference
