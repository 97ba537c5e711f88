// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/corners.hpp"

#include "planar/ray_walk.hpp"

namespace sightline::detail {

Corners::Corners(const Triangulation& t, General general)
    : t_(&t), general_(general), corners_(t.place_count()) {
    for (Place p = frame_places; p < t.first_constructed(); ++p) corners_[p] = classify(p);
}

Corner Corners::classify(Place p) const {
    const Triangulation& t = *t_;
    Corner c;
    const HalfEdge start = t.leaving(p);
    HalfEdge h = start;
    do {
        if (t.is_wall(h)) return {.kind = Corner::Kind::general};
        const bool solid = !t.is_free(h);
        const bool solid_before = !t.is_free(t.twin(h));
        if (solid && !solid_before) c.first = t.target(h);
        if (!solid && solid_before) c.last = t.target(h);
        h = t.rotate_ccw(h);
    } while (h != start);
    if (t.is_pinch(p)) return {.kind = Corner::Kind::general};
    if (c.first == no_index) return c;
    c.first_position = t.position(c.first);
    c.last_position = t.position(c.last);
    switch (t.orientation(p, c.first, c.last)) {
        case Sign::positive:
            c.kind = Corner::Kind::convex;
            break;
        case Sign::negative:
            c.kind = Corner::Kind::reflex;
            break;
        case Sign::zero:
            c.kind = Corner::Kind::flat;
            break;
    }
    return c;
}

bool Corners::is_tangent(const Viewpoint& v, Place w, ConeSigns& signs) const {
    const Corner& c = corners_[w];
    switch (c.kind) {
        case Corner::Kind::open:
            return true;
        case Corner::Kind::reflex:
            return false;
        case Corner::Kind::general:
            if (general_ == General::any_direction) return true;
            break;
        default: {
            const Point2& p = t_->position(w);
            Limit ray;
            ray.x = p.x - v.position.x;
            ray.y = p.y - v.position.y;
            ray.place = w;
            return signs.certain_side(v, ray, c.first) * signs.certain_side(v, ray, c.last) !=
                   Sign::negative;
        }
    }
    RayWalk walk(*t_, v.place, w);
    walk.skip_to(w);
    return walk.can_leave();
}

}  // namespace sightline::detail
