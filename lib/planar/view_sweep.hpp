// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/expansion.hpp"
#include "planar/point_locator.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {

/// A place as a vertex of a view: a scene vertex (the least id there), or a crossing of walls.
[[nodiscard]] ViewVertex vertex_at(const Triangulation& t, Place p);

/// Builds the ring of one visibility polygon from the edges that end the cones of sight, in
/// counter-clockwise order. As a visitor of the expansion; one object a thread, reusable.
class ViewSweep {
public:
    static constexpr bool wants_blocked = true;

    ViewSweep(const Triangulation& t, const Crossings& crossings, Arithmetic arithmetic);

    /// `at` is where the viewpoint lies; it must see something (no point inside B).
    void run(const Viewpoint& from, const Location& at, std::vector<ViewVertex>& ring);
    /// Rays that may go on, at width zero, beyond a vertex: from the last run.
    [[nodiscard]] const std::vector<Place>& followed() const noexcept { return followed_; }
    void add_to(Tally& tally) const noexcept { signs_.add_to(tally); }

    // As the visitor of the expansion:
    void vertex(const Crossing& c) {
        if ((c.flags & is_knot_flag) != 0) followed_.push_back(c.apex);
    }
    void on_limit(const Crossing& c, Limit& limit) {
        if (c.apex >= frame_places) limit.place = c.apex;
        limit.armed = true;
    }
    void follow(const Limit& limit) { followed_.push_back(limit.place); }
    void blocked(HalfEdge exit, const Cone& cone);

private:
    void look_into(HalfEdge far_edge);
    void look_around(Place v);
    void close();
    [[nodiscard]] ViewVertex end(HalfEdge exit, const Limit& limit, Place corner) const;
    void add_piece(EdgeId carrier, const ViewVertex& right, const ViewVertex& left);

    const Triangulation& t_;
    const Crossings& crossings_;
    ConeSigns signs_;
    Expansion<ViewSweep> expansion_;
    Viewpoint from_;
    std::vector<ViewVertex>* ring_ = nullptr;
    std::vector<Place> followed_;
    // The last piece of boundary that was added: its carrier (an edge, or none at infinity).
    EdgeId carrier_;
    bool has_piece_ = false;
    EdgeId first_carrier_;
};

}  // namespace sightline::detail
