// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/boost_graph.hpp"

#include <gtest/gtest.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/property_map/function_property_map.hpp>

#include "support/scenes.hpp"

namespace sightline {
namespace {

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<VisibilityGraph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<VisibilityGraph>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<VisibilityGraph>));

// Two walls side by side: the outer ends see each other only round the inner ones.
TEST(BoostGraph, DijkstraFindsTheWayRoundAWall) {
    const Scene2 scene = testing::scene2("wall 1 -1, 1 3; point 0 0; point 2 0");
    const VisibilityGraph graph = visibility_graph(scene);
    std::vector<double> distance(num_vertices(graph));
    const auto length = boost::make_function_property_map<std::pair<std::uint32_t, std::uint32_t>>(
        [&](const auto& e) {
            const Point2& p = scene[VertexId{e.first}];
            const Point2& q = scene[VertexId{e.second}];
            return std::hypot(p.x - q.x, p.y - q.y);
        });
    boost::dijkstra_shortest_paths_no_color_map(
        graph, 2U,
        boost::weight_map(length)
            .vertex_index_map(boost::identity_property_map{})
            .distance_map(boost::make_iterator_property_map(distance.begin(),
                                                            boost::identity_property_map{})));
    EXPECT_DOUBLE_EQ(distance[3], 2 * std::sqrt(2.0)) << "by way of (1, -1)";
}

TEST(BoostGraph, BreadthFirstSearchCountsHops) {
    const Scene2 scene = testing::scene2("wall 1 -1, 1 3; point 0 0; point 2 0");
    const VisibilityGraph graph = visibility_graph(scene);
    std::vector<int> hops(num_vertices(graph), 0);
    std::vector<boost::default_color_type> colour(num_vertices(graph));
    const boost::identity_property_map index;
    boost::breadth_first_search(
        graph, 2U,
        boost::visitor(
            boost::make_bfs_visitor(boost::record_distances(
                boost::make_iterator_property_map(hops.begin(), index), boost::on_tree_edge())))
            .vertex_index_map(index)
            .color_map(boost::make_iterator_property_map(colour.begin(), index)));
    EXPECT_EQ(hops, (std::vector<int>{1, 1, 0, 2}));
}

}  // namespace
}  // namespace sightline
