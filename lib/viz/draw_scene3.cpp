// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "sightline/viz/draw.hpp"
#include "sightline/viz/draw3.hpp"

namespace sightline::viz {
namespace {

Position position(const Point3& p) { return {p.x, p.y, p.z}; }

Layer face_layer(const Scene3& scene, std::string name, const Style& style,
                 bool (*is_shown)(const Body3&)) {
    Layer layer{
        .name = name, .legend = std::move(name), .order = PaintOrder::bodies, .style = style};
    for (const Triangle3& triangle : scene.triangles()) {
        if (!is_shown(scene[scene[triangle.face].body])) continue;
        Polygon polygon{{}, {}, triangle.face.value};
        for (const VertexId v : triangle.corners) polygon.outer.push_back(position(scene[v]));
        layer.polygons.push_back(std::move(polygon));
    }
    layer.count = static_cast<std::size_t>(std::ranges::count_if(
        scene.faces(), [&](const Face3& face) { return is_shown(scene[face.body]); }));
    return layer;
}

Layer edges_layer(const Scene3& scene, const DrawOptions3& options) {
    Layer layer{.name = "edges",
                .legend = "edges",
                .count = scene.edges().size(),
                .order = PaintOrder::graphs,
                .style = {.colour = Palette::outline, .width = 1.6, .marker_size = 0}};
    for (const Edge3& edge : scene.edges()) {
        const Position a = position(scene[edge.source]);
        const Position b = position(scene[edge.target]);
        if (options.edge_labels) {
            const Position middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
            layer.labels.push_back(
                {middle, to_string(EdgeId{static_cast<std::uint32_t>(layer.segments.size() / 2)})});
        }
        layer.segments.insert(layer.segments.end(), {a, b});
    }
    return layer;
}

Layer vertices_layer(const Scene3& scene, const DrawOptions3& options) {
    Layer layer{
        .name = "vertices",
        .legend = "vertices",
        .order = PaintOrder::vertices,
        .style = {
            .colour = Palette::outline, .width = 0, .marker = Marker::disc, .marker_size = 6}};
    for (std::uint32_t i = 0; i < scene.vertices().size(); ++i) {
        const VertexId v{i};
        if (!scene.is_feature(v)) continue;
        ++layer.count;
        if (options.vertices) layer.points.push_back(position(scene[v]));
        if (options.vertex_labels) layer.labels.push_back({position(scene[v]), to_string(v)});
    }
    return layer;
}

bool is_solid(const Body3& body) { return body.kind == SurfaceKind::solid && !body.is_world; }
bool is_sheet(const Body3& body) { return body.kind == SurfaceKind::sheet; }
bool is_world(const Body3& body) { return body.is_world; }

}  // namespace

Box box_around(const Scene3& scene, double margin) {
    Box box;
    for (const Edge3& edge : scene.edges()) {
        box.add(position(scene[edge.source]));
        box.add(position(scene[edge.target]));
    }
    if (box.is_empty()) return {{0, 0, 0}, {1, 1, 1}};
    const auto& [low, high] = box;
    const double by = margin * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    return {{low.x - by, low.y - by, low.z - by}, {high.x + by, high.y + by, high.z + by}};
}

void add_scene(DrawList& list, const Scene3& scene, const DrawOptions3& options) {
    const auto add_faces = [&](const char* name, Style style, bool (*is_shown)(const Body3&)) {
        Layer layer = face_layer(scene, name, style, is_shown);
        if (layer.count > 0) list.add(std::move(layer));
    };
    add_faces("faces", {.width = 0, .fill = {222, 226, 232}, .fill_opacity = options.solid_opacity},
              is_solid);
    add_faces("sheets", {.width = 0, .fill = Palette::sky_blue, .fill_opacity = 0.4}, is_sheet);
    add_faces("world", {.width = 0, .fill = Palette::solid, .fill_opacity = 0.12}, is_world);
    if (!scene.edges().empty()) list.add(edges_layer(scene, options));
    if (options.vertices || options.vertex_labels) list.add(vertices_layer(scene, options));
}

DrawList draw(const Scene3& scene, const DrawOptions3& options) {
    DrawList list;
    list.title = options.title;
    list.view = options.view;
    list.scale_bar = false;
    list.camera = options.camera;
    add_scene(list, scene, options);
    return list;
}

}  // namespace sightline::viz
