// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/corners.hpp"
#include "planar/expansion.hpp"
#include "planar/ray_walk.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline::detail {

/// Half rows of the visibility graph on places: for a place v, the visible places that are
/// lexicographically greater. Every edge belongs to one half row. One object a thread.
class GraphRows {
public:
    static constexpr bool wants_blocked = false;

    /// `corners` are needed for the tangent graph only; otherwise null.
    GraphRows(const Triangulation& t, const Crossings& crossings, const Corners* corners,
              const VisibilityGraphOptions& options);
    GraphRows(const GraphRows&) = delete;  // the expansion refers to its visitor
    GraphRows& operator=(const GraphRows&) = delete;

    /// Appends the half row of v to out, in no particular order, without repeats.
    void append(Place v, std::vector<Place>& out);
    void add_to(Tally& tally) const noexcept { signs_.add_to(tally); }

    // As the visitor of the expansion:
    void vertex(const Crossing& c) {
        if ((c.flags & is_vertex_flag) != 0) report(c.apex);
        if ((c.flags & is_knot_flag) != 0 && every_) follow_beyond(c.apex);
    }
    void on_limit(const Crossing& c, Limit& limit);
    void follow(const Limit& limit) {
        if (every_) follow_beyond(limit.place);
    }

private:
    /// A direction from the viewpoint that bounds a cone, and on which side of the half-plane it lies.
    struct Bound {
        Limit limit;
        bool after;  ///< in the half-plane of greater places
        bool above;  ///< straight up
        bool below;  ///< straight down
    };
    /// Where a direction lies round a convex corner, counter-clockwise from the body's last edge.
    enum class Wedge : std::uint8_t { tangent_first, crossing, tangent_last };

    void begin(HalfEdge h);
    void begin_tangent(HalfEdge h, std::uint32_t crossing);
    void begin_cone(std::uint32_t crossing, Bound right, Bound left);
    void look_along(HalfEdge h, Place p, bool above);
    [[nodiscard]] Wedge wedge_of(Place p);
    [[nodiscard]] bool is_after(Place p) const;
    [[nodiscard]] Bound towards(Place p) const;
    [[nodiscard]] Bound away_from(Place p) const;
    void follow_beyond(Place w);
    void follow_after(const Bound& b) {
        if (every_ && b.after) follow_beyond(b.limit.place);
    }
    void report(Place p) {
        if (corners_ == nullptr || corners_->is_tangent(from_, bound_, p, signs_))
            out_->push_back(p);
    }
    void report_once(Place p);
    void exclude_boundary(HalfEdge h);

    const Triangulation& t_;
    const Crossings& crossings_;
    const Corners* corners_;
    ConeSigns signs_;
    Expansion<GraphRows> expansion_;
    bool every_;
    bool body_edges_;
    double span_;
    Place v_ = no_index;
    Viewpoint from_;
    double bound_ = 0;
    Corner corner_;  // of v, when the tangent graph is asked for
    std::vector<Place>* out_ = nullptr;
    std::vector<Place> seen_;  // the viewpoint that last reported a place on a boundary ray
};

}  // namespace sightline::detail
