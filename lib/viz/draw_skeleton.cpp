// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <string>

#include "sightline/event/catalogue.hpp"
#include "sightline/skeleton/geometry.hpp"
#include "sightline/viz/draw.hpp"
#include "viz/vector_math.hpp"

namespace sightline::viz {
namespace {

using detail::dot;
using detail::operator-;

constexpr std::array arc_types{ArcType::ev, ArcType::eee, ArcType::fv, ArcType::fe};
constexpr std::array node_types{NodeType::vv,  NodeType::vee, NodeType::eeee,
                                NodeType::fve, NodeType::fee, NodeType::ff};

/// Where all lines of an arc meet, some of which are given.
std::optional<Position> centre_of(const SkeletonArc& arc, std::span<const RationalLine3> lines,
                                  const Scene3& scene) {
    for (const EventFamily& family : families_keeping(arc.label.support, scene)) {
        const auto is_in = [&](const RationalLine3& l) { return family.swath.contains(l); };
        if (family.swath.kind() != SwathKind::pencil || !std::ranges::all_of(lines, is_in))
            continue;
        const Vector3& c = family.swath.centre().p;
        return Position{c.x.approx_double(), c.y.approx_double(), c.z.approx_double()};
    }
    return std::nullopt;
}

/// The line of a node, among those that its support and its faces allow.
std::optional<SurdLine3> line_of(const SkeletonNode& node, const Scene3& scene,
                                 SkeletonGeometry& geometry) {
    if (!node.faces.empty() && node.root == Root::only) {
        const auto lines = lines_of(node.label.support, node.faces, scene);
        if (lines.size() == 1) return lines[0];
    }
    return geometry.line(node);
}

RuledSurface surface_of(const VisibilitySkeleton& skeleton, ArcId id, const Scene3& scene,
                        SkeletonGeometry& geometry, unsigned count, const Box& box) {
    const SkeletonArc& arc = skeleton[id];
    RuledSurface surface;
    const auto add = [&](const SurdLine3& line) {
        auto piece = approx_piece(line, arc.label, scene, box);
        if (!piece) return;
        const auto runs_back = [&](const LinePiece& before) {
            return dot(piece->to - piece->from, before.to - before.from) < 0;
        };
        if (!surface.lines.empty() && runs_back(surface.lines.back())) {
            std::swap(piece->from, piece->to);
        }
        surface.lines.push_back(*piece);
    };
    const auto first = line_of(skeleton[arc.nodes[0]], scene, geometry);
    const auto last = line_of(skeleton[arc.nodes[1]], scene, geometry);
    const std::vector<RationalLine3> inner = geometry.lines(skeleton, id, count - 2);
    if (first) add(*first);
    for (const RationalLine3& line : inner) add(to_surd(line));
    if (last) add(*last);
    if (!inner.empty()) surface.centre = centre_of(arc, inner, scene);
    return surface;
}

/// The types that occur, each with its layer; empty ones are left out in the end.
template <typename Type>
struct Layers {
    std::vector<std::pair<Type, Layer>> all;

    Layer& operator[](Type type) {
        return std::ranges::find(all, type, &std::pair<Type, Layer>::first)->second;
    }
    void add_to(DrawList& list) {
        for (auto& [type, layer] : all) {
            if (layer.count > 0) list.add(std::move(layer));
        }
    }
};

std::vector<ArcId> arcs_of(const VisibilitySkeleton& skeleton, const SkeletonDrawOptions& options) {
    if (options.arcs) return *options.arcs;
    std::vector<ArcId> arcs;
    for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) arcs.push_back(ArcId{a});
    return arcs;
}

std::set<NodeId> nodes_of(const VisibilitySkeleton& skeleton, const SkeletonDrawOptions& options) {
    std::set<NodeId> nodes;
    if (options.nodes) {
        nodes.insert(options.nodes->begin(), options.nodes->end());
    } else if (options.arcs) {
        for (const ArcId a : *options.arcs) {
            nodes.insert(skeleton[a].nodes.begin(), skeleton[a].nodes.end());
        }
    } else {
        for (std::uint32_t n = 0; n < skeleton.nodes().size(); ++n) nodes.insert(NodeId{n});
    }
    return nodes;
}

void add_arcs(DrawList& list, const Scene3& scene, const VisibilitySkeleton& skeleton,
              const SkeletonDrawOptions& options, const Box& box) {
    Layers<ArcType> surfaces;
    Layers<ArcType> outlines;
    const std::vector<ArcId> arcs = arcs_of(skeleton, options);
    // Paler as they crowd.
    const double opacity =
        std::clamp(0.4 * std::sqrt(12.0 / static_cast<double>(arcs.size() + 1)), 0.06, 0.4);
    for (const ArcType type : arc_types) {
        const std::string name(name_of(type));
        const Colour colour = colour_of(type);
        surfaces.all.push_back(
            {type,
             {.name = "arcs " + name,
              .legend = name + " arcs",
              .order = PaintOrder::views,
              .style = {.colour = colour, .width = 0, .fill = colour, .fill_opacity = opacity}}});
        outlines.all.push_back(
            {type,
             {.name = "outlines " + name,
              .order = PaintOrder::views + 1,
              .style = {.colour = colour, .width = 0.8, .opacity = std::min(1.0, 2 * opacity)}}});
    }
    SkeletonGeometry geometry(scene);
    std::size_t left_out = 0;
    for (const ArcId a : arcs) {
        const RuledSurface surface = approx_surface(skeleton, a, scene, options.lines_per_arc, box);
        if (surface.lines.empty()) {
            ++left_out;
            continue;
        }
        const ArcType type = skeleton[a].type;
        add_surface(surfaces[type], surface, a.value);
        add_outline(outlines[type], surface, a.value);
        ++surfaces[type].count;
        ++outlines[type].count;
    }
    surfaces.add_to(list);
    outlines.add_to(list);
    if (left_out > 0) {
        list.notes.push_back("Not drawn: " + with_thousands(left_out) +
                             " arcs without lines near the scene.");
    }
}

void add_nodes(DrawList& list, const Scene3& scene, const VisibilitySkeleton& skeleton,
               const SkeletonDrawOptions& options, const Box& box) {
    Layers<NodeType> layers;
    for (const NodeType type : node_types) {
        const std::string name(name_of(type));
        layers.all.push_back({type,
                              {.name = "nodes " + name,
                               .legend = name + " nodes",
                               .order = PaintOrder::paths,
                               .style = {.colour = colour_of(type), .width = 2.4}}});
    }
    SkeletonGeometry geometry(scene);
    for (const NodeId n : nodes_of(skeleton, options)) {
        const auto line = line_of(skeleton[n], scene, geometry);
        const auto piece = line ? approx_piece(*line, skeleton[n].label, scene, box) : std::nullopt;
        if (!piece) continue;
        Layer& layer = layers[skeleton[n].type];
        layer.polylines.push_back({{piece->from, piece->to}, n.value});
        ++layer.count;
    }
    layers.add_to(list);
}

}  // namespace

Colour colour_of(ArcType type) noexcept {
    switch (type) {
        case ArcType::ev:
            return Palette::sky_blue;
        case ArcType::eee:
            return Palette::vermilion;
        case ArcType::fv:
            return Palette::green;
        case ArcType::fe:
            return Palette::yellow;
    }
    return Palette::black;
}

Colour colour_of(NodeType type) noexcept {
    switch (type) {
        case NodeType::vv:
            return Palette::blue;
        case NodeType::vee:
            return Palette::purple;
        case NodeType::eeee:
            return {150, 30, 10};
        case NodeType::fve:
            return {0, 90, 60};
        case NodeType::fee:
            return {160, 120, 0};
        case NodeType::ff:
            return Palette::black;
    }
    return Palette::black;
}

RuledSurface approx_surface(const VisibilitySkeleton& skeleton, ArcId arc, const Scene3& scene,
                            unsigned count, const Box& box) {
    SIGHTLINE_EXPECT(count >= 3);
    SkeletonGeometry geometry(scene);
    return surface_of(skeleton, arc, scene, geometry, count, box);
}

void add_skeleton(DrawList& list, const Scene3& scene, const VisibilitySkeleton& skeleton,
                  const SkeletonDrawOptions& options) {
    SIGHTLINE_EXPECT(options.lines_per_arc >= 3);
    const Box box = list.view.is_empty() ? box_around(scene, options.margin) : list.view;
    add_arcs(list, scene, skeleton, options, box);
    add_nodes(list, scene, skeleton, options, box);
}

DrawList draw(const Scene3& scene, const VisibilitySkeleton& skeleton,
              const SkeletonDrawOptions& options) {
    DrawList list = draw(scene, options.scene);
    add_skeleton(list, scene, skeleton, options);
    return list;
}

}  // namespace sightline::viz
