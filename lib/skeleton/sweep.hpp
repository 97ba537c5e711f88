// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Follows the maximal free segments that touch a curve's generators along the curve: arcs, and the nodes
/// between them. Private.
///
/// A stay of the line in one state (free with one label, or blocked by one face) is found from a sample
/// inside it, and extended to both sides up to the nearest event that ends it; then what is left of the
/// curve on both sides is searched likewise. So the work is one line cut and one search a state,
/// and only what is near the segments concerned is ever looked at.

#include <functional>

#include "sightline/skeleton/visibility_skeleton.hpp"
#include "skeleton/reach.hpp"
#include "spatial/line_cut.hpp"

namespace sightline::detail {

/// An edge that lines near a node's line may meet near one of its places: one of the support, or one that ends
/// at a support vertex.
struct NearEdge {
    std::uint32_t place;
    EdgeId edge;
    VertexId vertex;  ///< the end at the node; none when the edge is met inside
};

/// What tells cells with equal labels apart where bodies touch: which features are met at one place, and the
/// faces between which what is blocked behind the ends runs. Empty when no bodies touch.
struct CellParts {
    std::vector<std::vector<std::pair<Feature, std::uint32_t>>> places;
    std::vector<FaceId> contact;

    friend bool operator==(const CellParts&, const CellParts&) = default;
};

/// Receives what a sweep finds.
struct SweepOutput {
    /// Returns a number for the node, the same for equal nodes, and whether it is new.
    std::function<std::pair<std::uint32_t, bool>(SkeletonNode&&)> add_node;
    /// Three edges, sorted, that lines near a new node may meet in different points.
    std::function<void(const std::array<EdgeId, 3>&)> add_swath;
    std::function<void(SkeletonArc&&)> add_arc;
};

class Sweep {
public:
    Sweep(const SceneForms& forms, const Policy& policy, SweepOutput output);

    void run(const Curve& curve);

private:
    using Interval = CurveInterval;
    /// The line at one parameter between events.
    struct State {
        bool is_free = false;
        bool is_arc = false;    ///< else free, but not by the family's conditions alone
        bool is_event = false;  ///< a single line between solids in contact behind an end
        SegmentLabel label;
        CellParts parts;
        ArcType type{};
        StoppingFaces stopping;
        FaceId blocker;            ///< crossed inside between the generators
        BodyId blocker_body;       ///< when no face is
        std::vector<FaceId> seal;  ///< faces of bodies in contact that block together
    };
    [[nodiscard]] std::vector<Interval> intervals(const Curve& curve) const;
    [[nodiscard]] bool meets_generators(const Curve& curve, const Parameter& t) const;
    void explore(const Curve& curve, const Interval& interval, unsigned depth);
    /// How far the state at t reaches, if no event is at t itself.
    [[nodiscard]] std::optional<Reach> reach_of(const Curve& curve, const Interval& interval,
                                                const Parameter& t, const State& state) const;
    void search_free(ReachSearch& search, const Curve& curve, const State& state,
                     std::span<const EventName> dismissed) const;
    [[nodiscard]] State look(const Curve& curve, const Parameter& t);
    void follow_arc(const Curve& curve, const Interval& interval, const Parameter& t,
                    const State& state, Reach& reach);
    void add_arcs(const Curve& curve, const State& state, const Reach& reach, std::uint32_t left,
                  std::uint32_t right);
    /// Where planar arcs past v end on the arc (rule 3 of VisibilitySkeleton), from left to right.
    [[nodiscard]] std::vector<std::uint32_t> dividing_nodes(const Curve& curve, const State& state,
                                                            const Reach& reach);
    [[nodiscard]] std::optional<std::uint32_t> planar_end(const Curve& curve, const Curve& planar);
    [[nodiscard]] std::optional<std::uint32_t> planar_end(const Curve& curve,
                                                          std::array<EdgeId, 3> edges);
    [[nodiscard]] bool is_arc_next_to(const Curve& curve, Interval interval, bool at_left);
    [[nodiscard]] std::vector<EdgeId> edges_round(const Curve& curve) const;
    [[nodiscard]] Reach blocked_reach(const Curve& curve, const Interval& interval,
                                      const Parameter& t, const State& state, bool& hit) const;
    [[nodiscard]] std::optional<std::uint32_t> node_at(const Curve& curve, const Parameter& t,
                                                       const EventName& at, const State* unless);
    [[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> generator_places(
        const Curve& curve) const;
    [[nodiscard]] std::optional<Run> run_of(const Curve& curve, bool at_limit);
    [[nodiscard]] bool keeps_to_plane(const Curve& curve, FaceId f) const;
    [[nodiscard]] bool is_pressed(const Curve& curve, const std::vector<FaceId>& contact) const;
    void find_lonely_nodes(const Curve& curve);
    void leave_node(const Line& line, const Run& run);
    [[nodiscard]] bool lies_in_plane(const Line& line, EdgeId a, EdgeId b) const;

    const SceneForms& forms_;
    const Policy& policy_;
    SweepOutput output_;
    LineCut cut_;
    // Where sheets are crossed, several segments of one line may touch the generators: a sweep for each.
    std::size_t rank_ = 0;
    bool has_more_ = false;
    std::vector<NearEdge> near_;
    std::vector<Reach> blocked_;  ///< stays in blocked states, from left to right
};

/// The node whose line has been cut, without its root.
[[nodiscard]] SkeletonNode describe_node(const SceneForms& forms, const LineCut& cut,
                                         const Run& run, const Line& line, SegmentLabel&& label);
/// Edges met near the run's places by lines near the cut one.
void find_near_edges(const SceneForms& forms, const LineCut& cut, const Run& run,
                     std::vector<NearEdge>& near);
/// Type of the arc of the curve to which the cut line's run belongs.
[[nodiscard]] ArcType arc_type(const Curve& curve, const LineCut& cut, const Run& run,
                               const SegmentLabel& label);

[[nodiscard]] CellParts cell_parts(const SceneForms& forms, const LineCut& cut, const Run& run);

}  // namespace sightline::detail
