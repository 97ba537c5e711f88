// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of a scene that change no answer: exact motions, mirror images, renumberings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::testing {

/// The scene with every point replaced.
inline SceneInput2 mapped(SceneInput2 input, const std::function<Point2(const Point2&)>& map) {
    const auto map_ring = [&map](std::vector<Point2>& ring) {
        for (Point2& p : ring) p = map(p);
    };
    for (SceneElement2& element : input.elements) {
        if (auto* polygon = std::get_if<Polygon2>(&element)) {
            map_ring(polygon->outer);
            for (Ring2& hole : polygon->holes) map_ring(hole);
        } else if (auto* wall = std::get_if<Polyline2>(&element)) {
            map_ring(wall->points);
        } else {
            Point2& p = std::get<Point2>(element);
            p = map(p);
        }
    }
    return input;
}

/// Maps that are exact on small integers and keep or mirror all orientations.
inline std::vector<std::function<Point2(const Point2&)>> exact_maps() {
    return {
        [](const Point2& p) { return Point2{p.x + 1024, p.y - 512}; },
        [](const Point2& p) { return Point2{p.x * 0x1p-300, p.y * 0x1p-300}; },
        [](const Point2& p) { return Point2{p.x * 0x1p+400, p.y * 0x1p+400}; },
        [](const Point2& p) { return Point2{-p.x, p.y}; },
        [](const Point2& p) { return Point2{p.y, p.x}; },
        [](const Point2& p) {
            return Point2{p.x, p.x + p.y};
        },  // shear: affine maps keep visibility
    };
}

inline std::size_t vertex_count(const SceneElement2& element) {
    if (const auto* polygon = std::get_if<Polygon2>(&element)) {
        std::size_t n = polygon->outer.size();
        for (const Ring2& hole : polygon->holes) n += hole.size();
        return n;
    }
    if (const auto* wall = std::get_if<Polyline2>(&element)) return wall->points.size();
    return 1;
}

/// A scene with its elements (but a world's polygon) in the opposite order, and where each vertex went.
struct Renumbered {
    SceneInput2 input;
    std::vector<VertexId> image;
};

inline Renumbered with_elements_reversed(const SceneInput2& input) {
    const std::size_t n = input.elements.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::reverse(order.begin() + (input.world ? 1 : 0), order.end());
    std::vector<std::uint32_t> old_start(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        old_start[i + 1] =
            old_start[i] + static_cast<std::uint32_t>(vertex_count(input.elements[i]));
    }
    Renumbered result{input, std::vector<VertexId>(old_start[n])};
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < n; ++i) {
        result.input.elements[i] = input.elements[order[i]];
        for (std::uint32_t v = old_start[order[i]]; v < old_start[order[i] + 1]; ++v) {
            result.image[v] = VertexId{next++};
        }
    }
    return result;
}

/// The graph with its vertices renamed.
inline VisibilityGraph renamed(const VisibilityGraph& graph, const std::vector<VertexId>& image) {
    std::vector<VisibilityGraph::Edge> edges;
    for (const auto& [u, v] : graph.edges()) edges.emplace_back(image[u.index()], image[v.index()]);
    return VisibilityGraph::from_edges(graph.vertex_count(), std::move(edges));
}

}  // namespace sightline::testing
