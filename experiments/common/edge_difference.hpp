// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>

#include "sightline/planar/visibility_graph.hpp"

namespace sightline::experiments {

/// How a graph differs from the right one.
struct EdgeDifference {
    std::size_t false_edges = 0;   ///< in the graph, not in the right one
    std::size_t missed_edges = 0;  ///< in the right one, not in the graph

    EdgeDifference& operator+=(const EdgeDifference& d) {
        false_edges += d.false_edges;
        missed_edges += d.missed_edges;
        return *this;
    }
};

/// Of one row: both ascending.
[[nodiscard]] inline EdgeDifference compare(std::span<const VertexId> row,
                                            std::span<const VertexId> right) {
    std::size_t common = 0;
    auto r = right.begin();
    for (const VertexId v : row) {
        r = std::lower_bound(r, right.end(), v);
        if (r != right.end() && *r == v) ++common;
    }
    return {row.size() - common, right.size() - common};
}

/// Of whole graphs on the same vertices, each edge counted once.
[[nodiscard]] inline EdgeDifference compare(const VisibilityGraph& graph,
                                            const VisibilityGraph& right) {
    EdgeDifference sum;
    for (std::uint32_t v = 0; v < right.vertex_count(); ++v) {
        sum += compare(graph.neighbours(VertexId{v}), right.neighbours(VertexId{v}));
    }
    return {sum.false_edges / 2, sum.missed_edges / 2};
}

}  // namespace sightline::experiments
