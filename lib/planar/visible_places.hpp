// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/corners.hpp"
#include "planar/expansion.hpp"
#include "planar/point_locator.hpp"

namespace sightline::detail {

/// The scene places that any point sees (nearest on each ray), all round: what joins the ends of a path
/// to the tangent graph. As a visitor of the expansion.
class VisiblePlaces {
public:
    static constexpr bool wants_blocked = false;

    VisiblePlaces(const Triangulation& t, const Crossings& crossings, Arithmetic arithmetic);
    VisiblePlaces(const VisiblePlaces&) = delete;  // the expansion refers to its visitor
    VisiblePlaces& operator=(const VisiblePlaces&) = delete;

    /// Ascending.
    [[nodiscard]] std::vector<Place> from(const Viewpoint& q, const Location& at);
    void add_to(Tally& tally) const noexcept { signs_.add_to(tally); }

    // As the visitor of the expansion:
    void vertex(const Crossing& c) { add(c.apex); }
    void on_limit(const Crossing& c, Limit& limit) { limit.place = c.apex; }
    void follow(const Limit& /*limit*/) {}

private:
    void add(Place p) {
        if (t_.is_scene_place(p)) found_.push_back(p);
    }
    void look_into(HalfEdge far_edge);
    void look_along(HalfEdge h);

    const Triangulation& t_;
    const Crossings& crossings_;
    ConeSigns signs_;
    Expansion<VisiblePlaces> expansion_;
    Viewpoint q_;
    std::vector<Place> found_;
};

}  // namespace sightline::detail
