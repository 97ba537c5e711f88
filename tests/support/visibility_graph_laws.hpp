// SPDX-License-Identifier: GPL-3.0-or-later
// What any visibility graph must satisfy, whatever computed it.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/reference/free_segment.hpp"
#include "support/graphs.hpp"
#include "support/transforms.hpp"

namespace sightline::testing {

using GraphFunction =
    std::function<VisibilityGraph(const Scene2& scene, const VisibilityGraphOptions& options)>;

/// All combinations of the options that change the result.
inline std::vector<VisibilityGraphOptions> graph_options() {
    std::vector<VisibilityGraphOptions> all;
    for (const Collinear collinear : {Collinear::nearest_only, Collinear::every_vertex}) {
        for (const bool body_edges : {true, false}) {
            for (const bool tangent_only : {false, true}) {
                all.push_back({.collinear = collinear,
                               .body_edges = body_edges,
                               .tangent_only = tangent_only});
            }
        }
    }
    return all;
}

inline std::string to_string(const VisibilityGraphOptions& options) {
    std::string text = options.collinear == Collinear::nearest_only ? "nearest" : "all";
    if (!options.body_edges) text.append(", no body edges");
    if (options.tangent_only) text.append(", tangent");
    return text;
}

/// (1) The adjacency is symmetric, ascending, without loops.
inline void expect_canonical(const VisibilityGraph& graph) {
    EXPECT_EQ(graph, VisibilityGraph::from_edges(graph.vertex_count(), graph.edges()));
}

/// (2) Every edge is a free segment between different places.
inline void expect_edges_free(const Scene2& scene, const VisibilityGraph& graph) {
    for (const auto& [u, v] : graph.edges()) {
        EXPECT_NE(scene[u], scene[v]) << to_string(EdgeList{{u, v}});
        EXPECT_TRUE(reference::is_free(scene, u, v)) << to_string(EdgeList{{u, v}});
    }
}

/// (3) Vertices at one place have the same neighbours.
inline void expect_places_agree(const Scene2& scene, const VisibilityGraph& graph) {
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            if (scene[VertexId{i}] != scene[VertexId{j}]) continue;
            const auto a = graph.neighbours(VertexId{i});
            const auto b = graph.neighbours(VertexId{j});
            EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()))
                << "v" << j << " v" << i;
        }
    }
}

/// (4) Of the four graphs with and without each restriction, the restricted is part of the other.
inline void expect_restrictions_restrict(const Scene2& scene, const GraphFunction& build) {
    const VisibilityGraph all = build(scene, {.collinear = Collinear::every_vertex});
    for (const VisibilityGraphOptions& options : graph_options()) {
        EXPECT_EQ(to_string(missing_from(all, build(scene, options))), "") << to_string(options);
    }
}

/// (5) Translations, scalings by powers of two, mirror images and shears change nothing.
inline void expect_motions_change_nothing(const SceneInput2& input, const GraphFunction& build,
                                          const VisibilityGraphOptions& options) {
    const VisibilityGraph graph = build(*Scene2::make(input), options);
    for (const auto& map : exact_maps()) {
        const auto moved = Scene2::make(mapped(input, map));
        ASSERT_TRUE(moved.has_value()) << moved.error().message;
        EXPECT_TRUE(same_graph(build(*moved, options), graph)) << to_string(options);
    }
}

/// (6) The order of the elements changes names only.
inline void expect_order_changes_names_only(const SceneInput2& input, const GraphFunction& build,
                                            const VisibilityGraphOptions& options) {
    const Renumbered renumbered = with_elements_reversed(input);
    const VisibilityGraph graph = build(*Scene2::make(input), options);
    EXPECT_TRUE(same_graph(build(*Scene2::make(renumbered.input), options),
                           renamed(graph, renumbered.image)))
        << to_string(options);
}

inline void expect_visibility_graph_laws(const SceneInput2& input, const GraphFunction& build) {
    const Scene2 scene = *Scene2::make(input);
    for (const VisibilityGraphOptions& options : graph_options()) {
        const VisibilityGraph graph = build(scene, options);
        expect_canonical(graph);
        expect_edges_free(scene, graph);
        expect_places_agree(scene, graph);
        expect_motions_change_nothing(input, build, options);
        expect_order_changes_names_only(input, build, options);
    }
    expect_restrictions_restrict(scene, build);
}

}  // namespace sightline::testing
