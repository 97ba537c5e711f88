// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A visibility skeleton as an undirected Boost.Graph graph, without a copy: a model of IncidenceGraph,
/// AdjacencyGraph, VertexListGraph and EdgeListGraph. It needs Boost; include it where you want to run Boost's
/// algorithms.
///
/// Vertices are the numbers of the nodes, edges the arcs; two nodes may have several arcs. Use
/// boost::identity_property_map as vertex index map.
///
///     std::vector<int> part(num_vertices(skeleton));
///     boost::connected_components(skeleton, part.data(), boost::vertex_index_map(…).color_map(…));

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline {

/// An arc, seen from one of its nodes. Equal for both directions.
struct SkeletonGraphEdge {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    ArcId arc;

    friend bool operator==(const SkeletonGraphEdge& a, const SkeletonGraphEdge& b) {
        return a.arc == b.arc;
    }
};

}  // namespace sightline

namespace sightline::detail {

struct SkeletonArcFrom {
    const VisibilitySkeleton* skeleton = nullptr;
    std::uint32_t source = 0;

    SkeletonGraphEdge operator()(ArcId arc) const {
        const auto& nodes = (*skeleton)[arc].nodes;
        const bool is_first = nodes[0].value == source;
        return {source, nodes[is_first ? 1 : 0].value, arc};
    }
};

struct SkeletonNeighbour {
    SkeletonArcFrom from;
    std::uint32_t operator()(ArcId arc) const { return from(arc).target; }
};

struct SkeletonEdgeAt {
    const VisibilitySkeleton* skeleton = nullptr;
    SkeletonGraphEdge operator()(std::uint32_t arc) const {
        const auto& nodes = (*skeleton)[ArcId{arc}].nodes;
        return {nodes[0].value, nodes[1].value, ArcId{arc}};
    }
};

struct SkeletonTraversal : boost::incidence_graph_tag,
                           boost::adjacency_graph_tag,
                           boost::vertex_list_graph_tag,
                           boost::edge_list_graph_tag {};

}  // namespace sightline::detail

template <>
struct boost::graph_traits<sightline::VisibilitySkeleton> {
    using vertex_descriptor = std::uint32_t;
    using edge_descriptor = sightline::SkeletonGraphEdge;
    using directed_category = boost::undirected_tag;
    using edge_parallel_category = boost::allow_parallel_edge_tag;
    using traversal_category = sightline::detail::SkeletonTraversal;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using vertex_iterator = boost::counting_iterator<std::uint32_t>;
    using edge_iterator =
        boost::transform_iterator<sightline::detail::SkeletonEdgeAt,
                                  boost::counting_iterator<std::uint32_t>, edge_descriptor>;
    using out_edge_iterator = boost::transform_iterator<sightline::detail::SkeletonArcFrom,
                                                        const sightline::ArcId*, edge_descriptor>;
    using adjacency_iterator = boost::transform_iterator<sightline::detail::SkeletonNeighbour,
                                                         const sightline::ArcId*, std::uint32_t>;
    static vertex_descriptor null_vertex() noexcept { return sightline::NodeId::none().value; }
};

namespace sightline {

[[nodiscard]] inline std::size_t num_vertices(const VisibilitySkeleton& g) {
    return g.nodes().size();
}
[[nodiscard]] inline std::size_t num_edges(const VisibilitySkeleton& g) { return g.arcs().size(); }

[[nodiscard]] inline auto vertices(const VisibilitySkeleton& g) {
    using Iterator = boost::graph_traits<VisibilitySkeleton>::vertex_iterator;
    return std::pair(Iterator(0), Iterator(static_cast<std::uint32_t>(g.nodes().size())));
}

[[nodiscard]] inline auto edges(const VisibilitySkeleton& g) {
    using Iterator = boost::graph_traits<VisibilitySkeleton>::edge_iterator;
    using Count = boost::counting_iterator<std::uint32_t>;
    const auto n = static_cast<std::uint32_t>(g.arcs().size());
    return std::pair(Iterator(Count(0), {&g}), Iterator(Count(n), {&g}));
}

[[nodiscard]] inline std::size_t out_degree(std::uint32_t n, const VisibilitySkeleton& g) {
    return g.arcs_at(NodeId{n}).size();
}

[[nodiscard]] inline auto out_edges(std::uint32_t n, const VisibilitySkeleton& g) {
    using Iterator = boost::graph_traits<VisibilitySkeleton>::out_edge_iterator;
    const auto arcs = g.arcs_at(NodeId{n});
    return std::pair(Iterator(arcs.data(), {&g, n}), Iterator(arcs.data() + arcs.size(), {&g, n}));
}

[[nodiscard]] inline auto adjacent_vertices(std::uint32_t n, const VisibilitySkeleton& g) {
    using Iterator = boost::graph_traits<VisibilitySkeleton>::adjacency_iterator;
    const auto arcs = g.arcs_at(NodeId{n});
    return std::pair(Iterator(arcs.data(), {{&g, n}}),
                     Iterator(arcs.data() + arcs.size(), {{&g, n}}));
}

[[nodiscard]] inline std::uint32_t source(const SkeletonGraphEdge& e,
                                          const VisibilitySkeleton& /*g*/) {
    return e.source;
}
[[nodiscard]] inline std::uint32_t target(const SkeletonGraphEdge& e,
                                          const VisibilitySkeleton& /*g*/) {
    return e.target;
}

}  // namespace sightline
