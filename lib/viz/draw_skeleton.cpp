// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "sightline/event/catalogue.hpp"
#include "sightline/viz/draw.hpp"
#include "viz/vector_math.hpp"

namespace sightline::viz {
namespace {

using detail::dot;
using detail::operator-;

constexpr std::array arc_types{ArcType::ev, ArcType::eee, ArcType::fv, ArcType::fe};
constexpr std::array node_types{NodeType::vv,  NodeType::vee, NodeType::eeee,
                                NodeType::fve, NodeType::fee, NodeType::ff};

RationalPoint3 place(VertexId v, const Scene3& scene) { return to_rational(scene[v]); }

/// The line of a node's support, if that fixes one.
std::optional<SurdLine3> own_line(const SkeletonNode& node, const Scene3& scene) {
    const std::vector<SurdLine3> lines = lines_of(node.label.support, scene);
    const std::size_t index = node.root == Root::second ? 1 : 0;
    if (index < lines.size()) return lines[index];
    return std::nullopt;
}

/// The line of a swath in which an arc in it ends at the node.
std::optional<SurdLine3> line_in(const Swath& swath, const SkeletonNode& node,
                                 const Scene3& scene) {
    const auto own = own_line(node, scene);
    if (own) return swath.contains(*own) ? own : std::nullopt;
    for (const VertexId v : node.label.support.vertices) {
        if (swath.all_pass(place(v, scene))) continue;
        if (const auto line = swath.line_through(place(v, scene))) return to_surd(*line);
    }
    return std::nullopt;
}

/// The swaths that an arc may lie in: that of its type first.
std::vector<Swath> swaths_of_arc(const SkeletonArc& arc, const Scene3& scene) {
    std::vector<EventFamily> families = families_keeping(arc.label.support, scene);
    std::ranges::stable_partition(
        families, [&](const EventFamily& f) { return name_of(f.kind) == name_of(arc.type); });
    std::vector<Swath> swaths;
    for (EventFamily& f : families) swaths.push_back(std::move(f.swath));
    return swaths;
}

/// Where a line meets an edge, from 0 at its source to 1 at its target.
double parameter_on(const SurdLine3& line, EdgeId e, const Scene3& scene) {
    const SurdVector3 source = to_surd(vector_to(place(scene[e].source, scene)));
    const SurdVector3 along = to_surd(vector_to(place(scene[e].target, scene))) - source;
    const SurdVector3 from_source = line.m - cross(source, line.d);
    const SurdVector3 turning = cross(along, line.d);
    // (source + t along) × d = m, measured along the direction in which it changes.
    return (dot(from_source, turning) / dot(turning, turning)).approx_double();
}

/// An edge of the support along which the swath's lines can be counted.
std::optional<EdgeId> guide_of(const Swath& swath, const Support& support,
                               std::span<const SurdLine3> ends, const Scene3& scene) {
    for (const EdgeId e : support.edges) {
        const RationalLine3 l = carrier(e, scene);
        if (!swath.is_regulus() && (is_on(l, swath.centre()) || swath.contains(l))) continue;
        const bool is_parallel = std::ranges::any_of(
            ends, [&](const SurdLine3& end) { return cross(to_surd(l.d), end.d).is_zero(); });
        if (!is_parallel && swath.all_meet(l)) return e;
    }
    return std::nullopt;
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
    for (const NodeId n : nodes_of(skeleton, options)) {
        const auto line = line_of(skeleton, n, scene);
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

std::optional<SurdLine3> line_of(const VisibilitySkeleton& skeleton, NodeId node,
                                 const Scene3& scene) {
    if (auto line = own_line(skeleton[node], scene)) return line;
    for (const ArcId a : skeleton.arcs_at(node)) {
        for (const Swath& swath : swaths_of_arc(skeleton[a], scene)) {
            if (auto line = line_in(swath, skeleton[node], scene)) return line;
        }
    }
    return std::nullopt;
}

RuledSurface approx_surface(const Swath& swath, const SurdLine3& first, const SurdLine3& last,
                            EdgeId guide, const SegmentLabel& label, const Scene3& scene,
                            unsigned count, const Box& box) {
    const LineCurve3 curve =
        swath.along(place(scene[guide].source, scene), place(scene[guide].target, scene));
    const double from = parameter_on(first, guide, scene);
    const double to = parameter_on(last, guide, scene);
    RuledSurface surface;
    const auto add = [&](const SurdLine3& line) {
        if (line.d.is_zero()) return;
        auto piece = approx_piece(line, label, scene, box);
        if (!piece) return;
        const auto runs_back = [&](const LinePiece& before) {
            return dot(piece->to - piece->from, before.to - before.from) < 0;
        };
        if (!surface.lines.empty() && runs_back(surface.lines.back())) {
            std::swap(piece->from, piece->to);
        }
        surface.lines.push_back(*piece);
    };
    add(first);
    for (unsigned i = 1; i + 1 < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        add(to_surd(curve.at(Rational(from * (1 - share) + to * share))));
    }
    add(last);
    if (swath.kind() == SwathKind::pencil) {
        const Vector3& c = swath.centre().p;
        surface.centre = Position{c.x.approx_double(), c.y.approx_double(), c.z.approx_double()};
    }
    return surface;
}

RuledSurface approx_surface(const VisibilitySkeleton& skeleton, ArcId arc, const Scene3& scene,
                            unsigned count, const Box& box) {
    const SkeletonArc& shown = skeleton[arc];
    for (const Swath& swath : swaths_of_arc(shown, scene)) {
        std::vector<SurdLine3> ends;
        for (const NodeId n : shown.nodes) {
            if (auto line = line_in(swath, skeleton[n], scene)) ends.push_back(std::move(*line));
        }
        if (ends.size() != 2) continue;
        const auto guide = guide_of(swath, shown.label.support, ends, scene);
        if (!guide) continue;
        return approx_surface(swath, ends[0], ends[1], *guide, shown.label, scene, count, box);
    }
    return {};
}

void add_skeleton(DrawList& list, const Scene3& scene, const VisibilitySkeleton& skeleton,
                  const SkeletonDrawOptions& options) {
    SIGHTLINE_EXPECT(options.lines_per_arc >= 2);
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
