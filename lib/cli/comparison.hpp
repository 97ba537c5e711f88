// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/scene2.hpp"

/// Results against the reference.
namespace sightline::detail {

/// How a graph differs from the right one in the rows that were compared.
struct GraphComparison {
    std::size_t rows = 0;
    std::size_t edges = 0;                          ///< of these rows, in the right graph
    std::size_t false_count = 0;                    ///< edges that should not be there
    std::size_t missed_count = 0;                   ///< edges that are not there
    std::vector<VisibilityGraph::Edge> false_some;  ///< the first few
    std::vector<VisibilityGraph::Edge> missed_some;

    [[nodiscard]] bool is_equal() const noexcept { return false_count + missed_count == 0; }
};

/// An even choice of `count` vertices out of n; all when there are no more.
[[nodiscard]] std::vector<VertexId> sampled_vertices(std::size_t n, std::size_t count);

/// Adds the row of v: what the graph says against `right`, both ascending.
void compare_row(const VisibilityGraph& graph, VertexId v, const std::vector<VertexId>& right,
                 GraphComparison& comparison);

}  // namespace sightline::detail
