// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {
namespace {

constexpr Style solid_style{
    .colour = Palette::outline, .width = 1, .fill = Palette::solid, .fill_opacity = 1};

std::vector<Position> ring_positions(const Scene2& scene, const RingRange2& ring) {
    std::vector<Position> points;
    points.reserve(ring.count);
    for (const Edge2& edge : scene.edges().subspan(ring.first.index(), ring.count)) {
        points.push_back(detail::position(scene[edge.source]));
    }
    return points;
}

Layer bodies_layer(const Scene2& scene) {
    Layer layer{
        .name = "bodies", .legend = "bodies", .order = PaintOrder::bodies, .style = solid_style};
    std::map<BodyId, std::size_t> place;
    for (const RingRange2& ring : scene.rings()) {
        if (ring.body.is_none() || ring.is_hole) continue;
        place[ring.body] = layer.polygons.size();
        layer.polygons.push_back({ring_positions(scene, ring), {}, ring.body.value});
    }
    for (const RingRange2& ring : scene.rings()) {
        if (!ring.is_hole || !place.contains(ring.body)) continue;
        layer.polygons[place.at(ring.body)].holes.push_back(ring_positions(scene, ring));
    }
    layer.count = scene.body_count();
    return layer;
}

/// Everything between the border of the picture and the border of the world.
Layer outside_layer(const Scene2& scene, const Box& view) {
    Layer layer{.name = "outside",
                .legend = "outside of the world",
                .order = PaintOrder::outside,
                .style = solid_style};
    layer.style.fill = {222, 224, 228};
    const auto& [low, high] = view;
    Polygon outside{{{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}}, {}, 0};
    for (const RingRange2& ring : scene.rings()) {
        if (ring.body.is_none() && !ring.is_hole)
            outside.holes.push_back(ring_positions(scene, ring));
    }
    layer.polygons.push_back(std::move(outside));
    return layer;
}

/// Walls as chains: consecutive edges that share a vertex are one.
Layer walls_layer(const Scene2& scene) {
    Layer layer{.name = "walls",
                .legend = "walls",
                .order = PaintOrder::walls,
                .style = {.colour = Palette::black, .width = 2.2}};
    VertexId end = VertexId::none();
    std::uint32_t id = 0;
    for (const Edge2& edge : scene.edges()) {
        if (edge.kind == EdgeKind2::wall) {
            if (end != edge.source) {
                layer.polylines.push_back({{detail::position(scene[edge.source])}, id});
            }
            layer.polylines.back().points.push_back(detail::position(scene[edge.target]));
            end = edge.target;
            ++layer.count;
        } else {
            end = VertexId::none();
        }
        ++id;
    }
    return layer;
}

Layer points_layer(const Scene2& scene) {
    Layer layer{
        .name = "points",
        .legend = "points",
        .count = scene.points().size(),
        .order = PaintOrder::vertices,
        .style = {
            .colour = Palette::purple, .width = 0, .marker = Marker::diamond, .marker_size = 9}};
    for (const VertexId v : scene.points()) layer.points.push_back(detail::position(scene[v]));
    return layer;
}

Layer vertices_layer(const Scene2& scene, const DrawOptions& options) {
    Layer layer{
        .name = "vertices",
        .legend = "vertices",
        .count = scene.vertex_count(),
        .order = PaintOrder::vertices,
        .style = {
            .colour = Palette::outline, .width = 0, .marker = Marker::disc, .marker_size = 4}};
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        const Position at = detail::position(scene[VertexId{i}]);
        if (options.vertices) layer.points.push_back(at);
        if (options.vertex_labels) layer.labels.push_back({at, to_string(VertexId{i})});
    }
    return layer;
}

}  // namespace

Box window(const Scene2& scene, std::span<const RationalPoint2> places) {
    Box box;
    for (const Point2& p : scene.vertices()) box.add(detail::position(p));
    for (const RationalPoint2& p : places) box.add(detail::position(p));
    return window_around(box);
}

void add_scene(DrawList& list, const Scene2& scene, const DrawOptions& options) {
    if (scene.has_world()) {
        list.add(outside_layer(scene, list.view.is_empty() ? window(scene) : list.view));
    }
    if (scene.body_count() > 0) list.add(bodies_layer(scene));
    if (Layer walls = walls_layer(scene); walls.count > 0) list.add(std::move(walls));
    if (options.vertices || options.vertex_labels) list.add(vertices_layer(scene, options));
    if (!scene.points().empty()) list.add(points_layer(scene));
}

DrawList draw(const Scene2& scene, const DrawOptions& options) {
    return detail::begin(scene, options, {});
}

namespace detail {

DrawList begin(const Scene2& scene, const DrawOptions& options,
               std::span<const RationalPoint2> places) {
    DrawList list;
    list.title = options.title;
    list.view = options.view.is_empty() ? window(scene, places) : options.view;
    add_scene(list, scene, options);
    return list;
}

}  // namespace detail
}  // namespace sightline::viz
