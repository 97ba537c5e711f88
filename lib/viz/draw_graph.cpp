// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {
namespace {

/// How often lines one pixel wide would cover the picture, if it were some 900 pixels wide.
double coverage(std::span<const Position> segments, const Box& view) {
    constexpr double width = 900;
    const double half_x = view.high.x / 2 - view.low.x / 2;
    const double half_y = view.high.y / 2 - view.low.y / 2;
    const double height = width * (half_y / half_x);
    double length = 0;
    for (std::size_t i = 0; i + 1 < segments.size(); i += 2) {
        const Position& a = segments[i];
        const Position& b = segments[i + 1];
        length +=
            std::hypot((b.x / 2 - a.x / 2) / half_x * width, (b.y / 2 - a.y / 2) / half_y * height);
    }
    return length / (width * height);
}

/// Lines that stay readable as they crowd: thinner and more transparent. The exponents were found by
/// looking, on pictures of 40 to 850,000 edges; fainter lines would add up to a wrong colour.
Style edge_style(std::size_t edges, double coverage) {
    const double width = 1.1 / std::pow(std::max(1.0, static_cast<double>(edges) / 150), 0.14);
    return {.colour = Palette::blue,
            .width = std::clamp(width, 0.4, 1.1),
            .opacity = std::clamp(0.27 / std::pow(coverage, 0.65), 0.03, 0.8)};
}

}  // namespace

void add_graph(DrawList& list, const Scene2& scene, std::span<const VisibilityGraph::Edge> edges) {
    Layer layer{.name = "graph",
                .legend = "visibility edges",
                .count = edges.size(),
                .order = PaintOrder::graphs};
    layer.segments.reserve(2 * edges.size());
    for (const auto& [u, v] : edges) {
        layer.segments.push_back(detail::position(scene[u]));
        layer.segments.push_back(detail::position(scene[v]));
    }
    layer.style = edge_style(
        edges.size(), coverage(layer.segments, list.view.is_empty() ? window(scene) : list.view));
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
