// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Follows the maximal free segments that touch a curve's generators along the curve: arcs, and the nodes
/// between them. Private.

#include <functional>

#include "sightline/skeleton/visibility_skeleton.hpp"
#include "skeleton/parameter.hpp"
#include "spatial/line_cut.hpp"

namespace sightline::detail {

/// A node as it is found, with the edges through whose neighbourhood arcs may leave it.
struct FoundNode {
    SkeletonNode node;
    /// Edges met by lines near the node's: those of its support, and those that end at its vertices.
    struct Element {
        std::uint32_t place;
        EdgeId edge;
        VertexId vertex;  ///< the end at the node; none when the edge is met inside
    };
    std::vector<Element> elements;
};

/// Receives what a sweep finds.
struct SweepOutput {
    /// Returns a number for the node, the same for equal nodes.
    std::function<std::uint32_t(FoundNode&&)> add_node;
    std::function<void(SkeletonArc&&)> add_arc;
};

class Sweep {
public:
    Sweep(const SceneForms& forms, const Policy& policy, SweepOutput output);

    void run(const Curve& curve);

private:
    struct Event {
        Parameter t;
        EdgeId edge;  ///< none at the ends of the curve
    };
    /// What is known between two events.
    struct State {
        bool is_free = false;
        bool is_known = false;
        SegmentLabel label;
        ArcType type{};
        BodyId blocker;
        std::uint32_t node = 0;  ///< where the arc begins
    };
    struct Interval {
        Parameter first, last;
    };

    [[nodiscard]] std::vector<Interval> intervals(const Curve& curve) const;
    [[nodiscard]] bool meets_generators(const Curve& curve, const Parameter& t) const;
    void collect_events(const Curve& curve);
    void add_edge_events(const Curve& curve, EdgeId e);
    void add_vertex_events(const Curve& curve, EdgeId e);
    void sweep(const Curve& curve, const Interval& interval);
    void pass(const Curve& curve, std::span<const Event> group, const Parameter& right,
              bool has_right, State& state);
    [[nodiscard]] bool concerns(const Curve& curve, std::span<const Event> group,
                                const State& state) const;
    [[nodiscard]] std::optional<std::uint32_t> node_at(const Curve& curve, const Event& event,
                                                       const SegmentLabel* unless);
    void look(const Curve& curve, const Parameter& t, State& state);
    [[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> generator_places(
        const Curve& curve) const;
    void add_arc(const Curve& curve, const State& state, std::uint32_t last);

    const SceneForms& forms_;
    const Policy& policy_;
    SweepOutput output_;
    LineCut cut_;
    std::vector<Event> events_;
    std::vector<EdgeId> permanent_;
};

/// Type, elements and root of the node whose line has been cut.
[[nodiscard]] FoundNode describe_node(const SceneForms& forms, const LineCut& cut, const Run& run,
                                      const Line& line, SegmentLabel&& label);
[[nodiscard]] ArcType arc_type(const SceneForms& forms, const LineCut& cut, const Run& run,
                               const Line& line, const SegmentLabel& label);

/// Pairs of edges of touching bodies that cross in a point inside both.
[[nodiscard]] std::vector<std::pair<EdgeId, EdgeId>> edge_crossings(const SceneForms& forms);

}  // namespace sightline::detail
