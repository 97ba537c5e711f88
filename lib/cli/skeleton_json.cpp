// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/skeleton_json.hpp"

#include <string>
#include <vector>

#include "cli/exact_json.hpp"
#include "sightline/skeleton/geometry.hpp"

namespace sightline::detail {
namespace {

using Layout = JsonWriter::Layout;

void write_vertices(JsonWriter& json, const std::vector<VertexId>& vertices) {
    json.begin_array(Layout::inline_);
    for (const VertexId v : vertices) json.value(v.value);
    json.end();
}

void write_edges(JsonWriter& json, const Scene3& scene, const std::vector<EdgeId>& edges) {
    json.begin_array(Layout::inline_);
    for (const EdgeId e : edges) {
        json.begin_array(Layout::inline_);
        json.value(scene[e].source.value);
        json.value(scene[e].target.value);
        json.end();
    }
    json.end();
}

void write_features(JsonWriter& json, const Scene3& scene, const std::vector<VertexId>& vertices,
                    const std::vector<EdgeId>& edges) {
    json.begin_object(Layout::inline_);
    json.key("vertices");
    write_vertices(json, vertices);
    json.key("edges");
    write_edges(json, scene, edges);
    json.end();
}

/// Faces by their first input face; a sheet's back is marked; null at infinity.
void write_end(JsonWriter& json, const Scene3& scene, const SegmentEnd& end) {
    if (end.empty()) return json.null();
    json.begin_array(Layout::inline_);
    for (const FaceSide& side : end) {
        const std::uint32_t number = scene[side.face].input_faces.front();
        if (!side.back) {
            json.value(number);
            continue;
        }
        json.begin_object(Layout::inline_);
        json.member("back", number);
        json.end();
    }
    json.end();
}

void write_ends(JsonWriter& json, const Scene3& scene, const SegmentLabel& label) {
    json.key("ends");
    json.begin_array(Layout::inline_);
    for (const SegmentEnd& end : label.ends) write_end(json, scene, end);
    json.end();
}

void write_node(JsonWriter& json, const Scene3& scene, SkeletonGeometry& geometry,
                const SkeletonNode& node) {
    const Support& support = node.label.support;
    json.begin_object(Layout::inline_);
    json.member("type", name_of(node.type));
    json.key("support");
    write_features(json, scene, support.vertices, support.edges);
    json.key("plucker");
    if (const auto line = geometry.line(node)) {
        write_line(json, *line);
    } else {
        json.null();  // a node that inexact arithmetic made up
    }
    json.key("along");
    write_edges(json, scene, support.along);
    write_ends(json, scene, node.label);
    json.key("faces");
    json.begin_array(Layout::inline_);
    for (const FaceId f : node.faces) json.value(scene[f].input_faces.front());
    json.end();
    json.key("root");
    if (node.root == Root::only) {
        json.null();
    } else {
        json.value(node.root == Root::first ? 0U : 1U);
    }
    json.end();
}

void write_arc(JsonWriter& json, const Scene3& scene, SkeletonGeometry& geometry,
               const VisibilitySkeleton& skeleton, ArcId a) {
    const SkeletonArc& arc = skeleton[a];
    const Support& support = arc.label.support;
    json.begin_object(Layout::inline_);
    json.member("type", name_of(arc.type));
    json.key("generators");
    if (const auto generators = geometry.generators(skeleton, a)) {
        write_features(json, scene, generators->vertices, generators->edges);
    } else {
        json.null();
    }
    json.key("support");
    write_features(json, scene, support.vertices, support.edges);
    write_ends(json, scene, arc.label);
    json.key("nodes");
    json.begin_array(Layout::inline_);
    for (const NodeId n : arc.nodes) json.value(n.value);
    json.end();
    json.end();
}

}  // namespace

void write_skeleton(JsonWriter& json, const Scene3& scene, const VisibilitySkeleton& skeleton,
                    std::optional<ArcType> only) {
    SkeletonGeometry geometry(scene);
    json.begin_object();
    json.key("nodes");
    json.begin_array();
    for (const SkeletonNode& node : skeleton.nodes()) write_node(json, scene, geometry, node);
    json.end();
    json.key("arcs");
    json.begin_array();
    for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
        if (only && skeleton[ArcId{a}].type != *only) continue;
        write_arc(json, scene, geometry, skeleton, ArcId{a});
    }
    json.end();
    json.end();
}

}  // namespace sightline::detail
