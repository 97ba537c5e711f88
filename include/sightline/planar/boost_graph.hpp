// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A visibility graph as a Boost.Graph graph, without a copy: a model of IncidenceGraph, AdjacencyGraph
/// and VertexListGraph. The one public header (with its 3D sisters) that needs Boost; include it where
/// you want to run Boost's algorithms.
///
/// Vertices are the numbers 0 … n − 1 of the scene's vertices; an edge is the pair of its ends, source
/// first. Use boost::identity_property_map as vertex index map.
///
///     std::vector<int> hops(num_vertices(graph));
///     boost::breadth_first_search(graph, 0, boost::vertex_index_map(boost::identity_property_map{})…);

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <utility>

#include "sightline/planar/visibility_graph.hpp"

namespace sightline::detail {

struct BoostVertex {
    std::uint32_t operator()(VertexId v) const noexcept { return v.value; }
};

struct BoostOutEdge {
    std::uint32_t source = 0;
    std::pair<std::uint32_t, std::uint32_t> operator()(VertexId v) const noexcept {
        return {source, v.value};
    }
};

struct BoostTraversal : boost::incidence_graph_tag,
                        boost::adjacency_graph_tag,
                        boost::vertex_list_graph_tag {};

}  // namespace sightline::detail

template <>
struct boost::graph_traits<sightline::VisibilityGraph> {
    using vertex_descriptor = std::uint32_t;
    using edge_descriptor = std::pair<std::uint32_t, std::uint32_t>;
    using directed_category = boost::undirected_tag;
    using edge_parallel_category = boost::disallow_parallel_edge_tag;
    using traversal_category = sightline::detail::BoostTraversal;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = boost::counting_iterator<std::uint32_t>;
    using adjacency_iterator =
        boost::transform_iterator<sightline::detail::BoostVertex, const sightline::VertexId*>;
    using out_edge_iterator =
        boost::transform_iterator<sightline::detail::BoostOutEdge, const sightline::VertexId*,
                                  edge_descriptor>;
    static vertex_descriptor null_vertex() noexcept { return sightline::VertexId::none().value; }
};

namespace sightline {

[[nodiscard]] inline std::size_t num_vertices(const VisibilityGraph& g) { return g.vertex_count(); }

[[nodiscard]] inline auto vertices(const VisibilityGraph& g) {
    using Iterator = boost::graph_traits<VisibilityGraph>::vertex_iterator;
    return std::pair(Iterator(0), Iterator(static_cast<std::uint32_t>(g.vertex_count())));
}

[[nodiscard]] inline std::size_t out_degree(std::uint32_t v, const VisibilityGraph& g) {
    return g.neighbours(VertexId{v}).size();
}

[[nodiscard]] inline auto adjacent_vertices(std::uint32_t v, const VisibilityGraph& g) {
    using Iterator = boost::graph_traits<VisibilityGraph>::adjacency_iterator;
    const auto row = g.neighbours(VertexId{v});
    return std::pair(Iterator(row.data(), {}), Iterator(row.data() + row.size(), {}));
}

[[nodiscard]] inline auto out_edges(std::uint32_t v, const VisibilityGraph& g) {
    using Iterator = boost::graph_traits<VisibilityGraph>::out_edge_iterator;
    const auto row = g.neighbours(VertexId{v});
    return std::pair(Iterator(row.data(), {v}), Iterator(row.data() + row.size(), {v}));
}

}  // namespace sightline

namespace boost {

// The ends of an edge are pairs of numbers, for which only boost is searched.
[[nodiscard]] inline std::uint32_t source(const std::pair<std::uint32_t, std::uint32_t>& e,
                                          const sightline::VisibilityGraph& /*g*/) {
    return e.first;
}
[[nodiscard]] inline std::uint32_t target(const std::pair<std::uint32_t, std::uint32_t>& e,
                                          const sightline::VisibilityGraph& /*g*/) {
    return e.second;
}

}  // namespace boost
