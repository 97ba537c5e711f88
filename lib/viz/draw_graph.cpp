// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {
namespace {

/// Lines that stay readable as their number grows: thinner and more transparent.
Style edge_style(std::size_t edges) {
    const double crowd = std::max(1.0, static_cast<double>(edges) / 150);
    return {.colour = Palette::blue,
            .width = std::clamp(1.1 / std::pow(crowd, 0.14), 0.4, 1.1),
            .opacity = std::clamp(0.8 / std::pow(crowd, 0.37), 0.05, 0.8)};
}

}  // namespace

void add_graph(DrawList& list, const Scene2& scene, std::span<const VisibilityGraph::Edge> edges) {
    Layer layer{.name = "graph",
                .legend = "visibility edges",
                .count = edges.size(),
                .order = PaintOrder::graphs,
                .style = edge_style(edges.size())};
    layer.segments.reserve(2 * edges.size());
    for (const auto& [u, v] : edges) {
        layer.segments.push_back(detail::position(scene[u]));
        layer.segments.push_back(detail::position(scene[v]));
    }
    list.add(std::move(layer));
}

void add_graph(DrawList& list, const Scene2& scene, const VisibilityGraph& graph) {
    add_graph(list, scene, graph.edges());
}

DrawList draw(const Scene2& scene, const VisibilityGraph& graph, const DrawOptions& options) {
    DrawList list = detail::begin(scene, options, {});
    add_graph(list, scene, graph);
    return list;
}

}  // namespace sightline::viz
