// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/visibility_graph.hpp"

#include <algorithm>

namespace sightline {

VisibilityGraph VisibilityGraph::from_edges(std::size_t vertex_count, std::vector<Edge> edges) {
    std::vector<Edge> arcs;
    arcs.reserve(2 * edges.size());
    for (const auto& [u, v] : edges) {
        SIGHTLINE_EXPECT(u != v && u.index() < vertex_count && v.index() < vertex_count);
        arcs.emplace_back(u, v);
        arcs.emplace_back(v, u);
    }
    std::sort(arcs.begin(), arcs.end());
    arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());

    std::vector<std::uint64_t> offsets(vertex_count + 1, 0);
    std::vector<VertexId> targets;
    targets.reserve(arcs.size());
    for (const auto& [u, v] : arcs) {
        ++offsets[u.index() + 1];
        targets.push_back(v);
    }
    for (std::size_t i = 0; i < vertex_count; ++i) offsets[i + 1] += offsets[i];
    return {std::move(offsets), std::move(targets)};
}

bool VisibilityGraph::has_edge(VertexId u, VertexId v) const {
    const auto row = neighbours(u);
    return std::binary_search(row.begin(), row.end(), v);
}

std::vector<VisibilityGraph::Edge> VisibilityGraph::edges() const {
    std::vector<Edge> result;
    result.reserve(edge_count());
    for (std::uint32_t i = 0; i < vertex_count(); ++i) {
        const auto row = neighbours(VertexId{i});
        const auto above = std::upper_bound(row.begin(), row.end(), VertexId{i});
        for (auto it = above; it != row.end(); ++it) result.emplace_back(VertexId{i}, *it);
    }
    return result;
}

}  // namespace sightline
