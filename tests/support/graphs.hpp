// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility graphs in tests: written down, and compared with the differing edges named.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "sightline/planar/visibility_graph.hpp"

namespace sightline::testing {

using EdgeList = std::vector<VisibilityGraph::Edge>;

/// "0-1 3-12 …"
inline EdgeList edge_list(const std::string& text) {
    EdgeList edges;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        std::istringstream edge(word);
        VertexId u;
        VertexId v;
        char dash = 0;
        edge >> u.value >> dash >> v.value;
        edges.emplace_back(std::min(u, v), std::max(u, v));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

inline std::string to_string(const EdgeList& edges) {
    std::ostringstream text;
    for (const auto& [u, v] : edges) text << u.value << '-' << v.value << ' ';
    return text.str();
}

/// The edges of a that b lacks.
inline EdgeList missing_from(const VisibilityGraph& b, const VisibilityGraph& a) {
    const EdgeList of_a = a.edges();
    const EdgeList of_b = b.edges();
    EdgeList result;
    std::set_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::back_inserter(result));
    return result;
}

/// Whether the graphs are equal; if not, which edges differ.
inline ::testing::AssertionResult same_graph(const VisibilityGraph& actual,
                                             const VisibilityGraph& expected) {
    if (actual == expected) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "missing: " << to_string(missing_from(actual, expected))
           << "\nfalse: " << to_string(missing_from(expected, actual)) << "\nvertices "
           << actual.vertex_count() << " and " << expected.vertex_count();
}

inline ::testing::AssertionResult same_graph(const VisibilityGraph& actual,
                                             const std::string& edges) {
    return same_graph(actual, VisibilityGraph::from_edges(actual.vertex_count(), edge_list(edges)));
}

}  // namespace sightline::testing
