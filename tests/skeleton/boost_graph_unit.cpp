// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/boost_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/property_map/property_map.hpp>
#include <vector>

#include "sightline/skeleton/build.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<VisibilitySkeleton>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<VisibilitySkeleton>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<VisibilitySkeleton>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<VisibilitySkeleton>));

constexpr boost::identity_property_map index;

std::vector<std::uint32_t> parts(const VisibilitySkeleton& skeleton) {
    std::vector<std::uint32_t> part(num_vertices(skeleton));
    std::vector<boost::default_color_type> colour(part.size());
    boost::connected_components(skeleton, boost::make_iterator_property_map(part.begin(), index),
                                boost::vertex_index_map(index).color_map(
                                    boost::make_iterator_property_map(colour.begin(), index)));
    return part;
}

TEST(SkeletonGraph, ATetrahedronsEdgeLinesAreOneOctahedron) {
    const auto skeleton = visibility_skeleton(testing::scene3("family tetrahedron"));
    EXPECT_EQ(num_vertices(skeleton), 6u);
    EXPECT_EQ(num_edges(skeleton), 12u);
    EXPECT_EQ(parts(skeleton), std::vector<std::uint32_t>(6, 0));

    // Edge lines with a common end are joined by lines of their face: only the opposite edge is two arcs away.
    std::vector<int> hops(6, 0);
    std::vector<boost::default_color_type> colour(6);
    boost::breadth_first_search(
        skeleton, 0U,
        boost::visitor(
            boost::make_bfs_visitor(boost::record_distances(
                boost::make_iterator_property_map(hops.begin(), index), boost::on_tree_edge())))
            .vertex_index_map(index)
            .color_map(boost::make_iterator_property_map(colour.begin(), index)));
    std::ranges::sort(hops);
    EXPECT_EQ(hops, (std::vector<int>{0, 1, 1, 1, 1, 2}));
}

TEST(SkeletonGraph, ACubesFacesAreJoinedByTheirEdges) {
    const auto skeleton = visibility_skeleton(testing::scene3("family cube"));
    EXPECT_EQ(parts(skeleton), std::vector<std::uint32_t>(24, 0));
}

TEST(SkeletonGraph, EveryArcIsAnOutEdgeOfBothItsNodes) {
    const auto skeleton = visibility_skeleton(testing::scene3("family tetrahedra 2"));
    std::size_t ends = 0;
    for (auto [n, last] = vertices(skeleton); n != last; ++n) {
        auto [neighbour, no_more] = adjacent_vertices(*n, skeleton);
        for (auto [e, end] = out_edges(*n, skeleton); e != end; ++e, ++neighbour, ++ends) {
            const auto& nodes = skeleton[(*e).arc].nodes;
            EXPECT_EQ(source(*e, skeleton), *n);
            EXPECT_EQ(target(*e, skeleton), *neighbour);
            EXPECT_EQ(std::minmax(source(*e, skeleton), target(*e, skeleton)),
                      std::minmax(nodes[0].value, nodes[1].value));
        }
        EXPECT_EQ(neighbour, no_more);
    }
    EXPECT_EQ(ends, 2 * num_edges(skeleton));
    std::size_t arcs = 0;
    for (auto [e, end] = edges(skeleton); e != end; ++e) EXPECT_EQ((*e).arc.index(), arcs++);
    EXPECT_EQ(arcs, num_edges(skeleton));
}

}  // namespace
}  // namespace sightline
