// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/expansion.hpp"
#include "planar/ray_walk.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline::detail {

/// Half rows of the visibility graph on places: for a place v, the visible places that are
/// lexicographically greater. Every edge belongs to one half row. One object a thread.
class GraphRows {
public:
    static constexpr bool wants_blocked = false;

    GraphRows(const Triangulation& t, const Crossings& crossings,
              const VisibilityGraphOptions& options);

    /// Appends the half row of v to out, in no particular order, without repeats.
    void append(Place v, std::vector<Place>& out);
    void add_to(Tally& tally) const noexcept { signs_.add_to(tally); }

    // As the visitor of the expansion:
    void vertex(const Crossing& c) {
        if ((c.flags & is_vertex_flag) != 0) out_->push_back(c.apex);
        if ((c.flags & is_pinch_flag) != 0 && every_) follow_beyond(c.apex);
    }
    void on_limit(const Crossing& c, Limit& limit);
    void follow(const Limit& limit) {
        if (every_) follow_beyond(limit.place);
    }

private:
    void begin(HalfEdge h);
    void look_along(HalfEdge h, Place p);
    [[nodiscard]] bool is_after(Place p) const;
    [[nodiscard]] bool is_straight_above(Place p) const;
    void follow_beyond(Place w);
    void report_once(Place p);
    [[nodiscard]] Limit towards(Place p) const;
    void exclude_boundary(HalfEdge h);

    const Triangulation& t_;
    const Crossings& crossings_;
    ConeSigns signs_;
    Expansion<GraphRows> expansion_;
    bool every_;
    bool body_edges_;
    double span_;
    Place v_ = no_index;
    Viewpoint from_;
    std::vector<Place>* out_ = nullptr;
    std::vector<Place> seen_;  // the viewpoint that last reported a place on a boundary ray
};

}  // namespace sightline::detail
