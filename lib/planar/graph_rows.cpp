// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_rows.hpp"

#include <algorithm>

namespace sightline::detail {

GraphRows::GraphRows(const Triangulation& t, const Crossings& crossings,
                     const VisibilityGraphOptions& options)
    : t_(t),
      crossings_(crossings),
      signs_(t, options.arithmetic),
      expansion_(crossings, signs_, *this),
      every_(options.collinear == Collinear::every_vertex),
      body_edges_(options.body_edges),
      span_(std::max(t.position(2).x - t.position(0).x, t.position(2).y - t.position(0).y)),
      seen_(t.place_count(), no_index) {}

void GraphRows::append(Place v, std::vector<Place>& out) {
    v_ = v;
    from_ = {t_.position(v), v};
    out_ = &out;
    expansion_.look_from(from_);
    const HalfEdge start = t_.leaving(v);
    HalfEdge h = start;
    do {
        begin(h);
        h = t_.rotate_ccw(h);
    } while (h != start);
}

bool GraphRows::is_after(Place p) const {
    if (p >= t_.first_constructed()) return t_.compare(v_, p) == Sign::negative;
    const Point2& q = t_.position(p);
    return from_.position.x < q.x || (from_.position.x == q.x && from_.position.y < q.y);
}

bool GraphRows::is_straight_above(Place p) const {
    if (p < t_.first_constructed() && v_ < t_.first_constructed())
        return t_.position(p).x == from_.position.x;
    return t_.exact_position(p).x == t_.exact_position(v_).x;
}

Limit GraphRows::towards(Place p) const {
    const Point2& q = t_.position(p);
    return {q.x - from_.position.x,
            q.y - from_.position.y,
            p,
            Limit::Kind::towards,
            true,
            false,
            false};
}

// The triangle (v, p, q) of h: the edge to p, then the cone between p and q, as far as they lie in the
// half-plane of greater places. The ray straight down belongs to the other half-plane.
void GraphRows::begin(HalfEdge h) {
    const Place p = t_.target(h);
    const Place q = t_.apex(h);
    const bool p_after = is_after(p);
    if (p_after) look_along(h, p);
    if (!t_.is_free(h)) return;
    const bool q_after = is_after(q);
    if (!p_after && !q_after) return;
    const std::uint32_t crossing = Crossings::beyond(t_, next(h));
    const bool q_above = q_after && is_straight_above(q);
    if (crossing == no_index) {
        if (q_above && every_) follow_beyond(q);
        return;
    }
    Cone cone{crossing, towards(q), towards(p)};
    if (!q_after) {
        const Limit up{0, span_, no_index, Limit::Kind::up, false, true, false};
        if (is_straight_above(p)) return;
        cone.left = up;
    } else if (!p_after) {
        const Limit down{0, -span_, no_index, Limit::Kind::down, false, false, true};
        cone.right = down;
        cone.right.touches = is_straight_above(p);  // here: below
    }
    cone.left.armed |= q_above;
    expansion_.expand(cone);
}

void GraphRows::look_along(HalfEdge h, Place p) {
    const HalfEdge g = t_.twin(h);
    const bool left_free = t_.is_free(h);
    const bool right_free = t_.is_free(g);
    if (!left_free && !right_free) return;
    const bool on_boundary = t_.is_constrained(h) && left_free != right_free;
    if (on_boundary && !body_edges_)
        exclude_boundary(h);
    else if (t_.is_scene_place(p))
        out_->push_back(p);
    // The cone on the left of the ray straight up belongs to the other half-plane.
    if (every_ ? t_.is_pinch(p) || t_.is_wall(h) || (!right_free && is_straight_above(p))
               : !t_.is_scene_place(p))
        follow_beyond(p);
}

// Marks what lies on the boundary from h on, straight, as reported: body_edges = false.
void GraphRows::exclude_boundary(HalfEdge h) {
    const Place first = t_.target(h);
    RayWalk walk(t_, v_, first);
    for (Place p = walk.next_place(); p != no_index && walk.ran_along_boundary();
         p = walk.next_place())
        seen_[p] = v_;
}

void GraphRows::on_limit(const Crossing& c, Limit& limit) {
    const bool first = limit.kind != Limit::Kind::towards;
    if ((c.flags & is_vertex_flag) != 0 && !limit.silent && (every_ || first)) report_once(c.apex);
    limit.place = c.apex;
    limit.kind = Limit::Kind::towards;
    limit.armed = !limit.silent;
}

// The ray v→w beyond the visible place w: all vertices on it, or the first one when w itself is none.
void GraphRows::follow_beyond(Place w) {
    RayWalk walk(t_, v_, w);
    walk.skip_to(w);
    for (Place p = walk.next_place(); p != no_index; p = walk.next_place()) {
        if (!t_.is_scene_place(p)) continue;
        report_once(p);
        if (!every_) return;
    }
}

void GraphRows::report_once(Place p) {
    if (seen_[p] == v_) return;
    seen_[p] = v_;
    out_->push_back(p);
}

}  // namespace sightline::detail
