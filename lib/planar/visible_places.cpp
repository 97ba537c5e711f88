// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/visible_places.hpp"

#include <algorithm>

#include "planar/ray_walk.hpp"

namespace sightline::detail {

VisiblePlaces::VisiblePlaces(const Triangulation& t, const Crossings& crossings,
                             Arithmetic arithmetic)
    : t_(t), crossings_(crossings), signs_(t, arithmetic), expansion_(crossings, signs_, *this) {}

std::vector<Place> VisiblePlaces::from(const Viewpoint& q, const Location& at) {
    q_ = q;
    found_.clear();
    expansion_.look_from(q);
    const HalfEdge h = at.half_edge;
    if (at.kind == Location::Kind::place) {
        HalfEdge k = h;
        do {
            if (t_.is_free(k) || t_.is_free(t_.twin(k))) look_along(k);
            if (t_.is_free(k)) look_into(next(k));
            k = t_.rotate_ccw(k);
        } while (k != h);
    } else {
        for (const HalfEdge base : {h, t_.twin(h)}) {
            if (base == no_index || !t_.is_free(base)) continue;
            if (base != h && at.kind == Location::Kind::triangle) continue;
            for (const HalfEdge far_edge : {base, next(base), prev(base)}) {
                add(t_.origin(far_edge));
                if (at.kind == Location::Kind::triangle || far_edge != base) look_into(far_edge);
            }
        }
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
}

// The neighbour along an edge, or what comes first behind it when that is no vertex of the scene.
void VisiblePlaces::look_along(HalfEdge h) {
    RayWalk walk(t_, t_.origin(h), t_.target(h));
    Place p = walk.next_place();
    while (p != no_index && p >= frame_places && !t_.is_scene_place(p)) p = walk.next_place();
    if (p != no_index) add(p);
}

void VisiblePlaces::look_into(HalfEdge far_edge) {
    const std::uint32_t crossing = Crossings::beyond(t_, far_edge);
    if (crossing == no_index) return;
    const auto towards = [&](Place p) {
        const Point2& at = t_.position(p);
        return Limit{at.x - q_.position.x,
                     at.y - q_.position.y,
                     p,
                     Limit::Kind::towards,
                     true,
                     false,
                     false};
    };
    expansion_.expand({crossing, towards(t_.target(far_edge)), towards(t_.origin(far_edge))});
}

}  // namespace sightline::detail
