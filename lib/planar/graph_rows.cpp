// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_rows.hpp"

#include <algorithm>

namespace sightline::detail {

GraphRows::GraphRows(const Triangulation& t, const Crossings& crossings, const Corners* corners,
                     const VisibilityGraphOptions& options)
    : t_(t),
      crossings_(crossings),
      corners_(corners),
      signs_(t, options.arithmetic),
      expansion_(crossings, signs_, *this),
      every_(options.collinear == Collinear::every_vertex),
      body_edges_(options.body_edges),
      span_(std::max(t.position(2).x - t.position(0).x, t.position(2).y - t.position(0).y)),
      seen_(t.place_count(), no_index) {}

void GraphRows::append(Place v, std::vector<Place>& out) {
    if (corners_ != nullptr) corner_ = (*corners_)[v];
    if (corner_.kind == Corner::Kind::reflex) return;
    v_ = v;
    from_ = {t_.position(v), v};
    out_ = &out;
    expansion_.look_from(from_);
    bound_ = signs_.bound(from_);
    const HalfEdge start = t_.leaving(v);
    const std::size_t before = out.size();
    HalfEdge h = start;
    if (!body_edges_) {
        do {
            exclude_boundary(h);
            h = t_.rotate_ccw(h);
        } while (h != start);
    }
    do {
        begin(h);
        h = t_.rotate_ccw(h);
    } while (h != start);
    if (corner_.kind != Corner::Kind::general) return;
    // No wedge of tangent directions was known beforehand.
    const auto crosses = [&](Place w) {
        return !corners_->is_tangent({t_.position(w), w}, v, signs_);
    };
    out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(), crosses),
              out.end());
}

bool GraphRows::is_after(Place p) const {
    if (p >= t_.first_constructed()) return t_.compare(v_, p) == Sign::negative;
    const Point2& q = t_.position(p);
    return from_.position.x < q.x || (from_.position.x == q.x && from_.position.y < q.y);
}

GraphRows::Bound GraphRows::towards(Place p) const {
    const Point2& q = t_.position(p);
    Bound b{{q.x - from_.position.x, q.y - from_.position.y, p, Limit::Kind::towards, true, false,
             false},
            is_after(p),
            false,
            false};
    const bool vertical = p < t_.first_constructed()
                              ? q.x == from_.position.x
                              : t_.exact_position(p).x == t_.exact_position(v_).x;
    b.above = vertical && b.after;
    b.below = vertical && !b.after;
    return b;
}

GraphRows::Bound GraphRows::away_from(Place p) const {
    const Bound b = towards(p);
    return {{-b.limit.x, -b.limit.y, p, Limit::Kind::away_from, false, false, false},
            !b.after,
            b.below,
            b.above};
}

// The triangle (v, p, q) of h: the edge to p, then the cone between p and q.
void GraphRows::begin(HalfEdge h) {
    const Place p = t_.target(h);
    const Bound right = towards(p);
    if (right.after) look_along(h, p, right.above);
    if (!t_.is_free(h) || corner_.kind == Corner::Kind::flat) return;
    const std::uint32_t crossing = Crossings::beyond(t_, next(h));
    if (corner_.kind == Corner::Kind::convex)
        begin_tangent(h, crossing);
    else
        begin_cone(crossing, right, towards(t_.apex(h)));
}

// Directions between the extensions of the corner's edges cross the body behind v: left out.
void GraphRows::begin_tangent(HalfEdge h, std::uint32_t crossing) {
    const Wedge at_right = wedge_of(t_.target(h));
    const Wedge at_left = wedge_of(t_.apex(h));
    const Bound right = towards(t_.target(h));
    const Bound left = towards(t_.apex(h));
    if (at_right == at_left) {
        if (at_right != Wedge::crossing) begin_cone(crossing, right, left);
        return;
    }
    const auto extends = [&](Place edge, Place p) {
        return p != edge && signs_.certain_side(from_, towards(edge).limit, p) == Sign::zero;
    };
    if (at_right == Wedge::tangent_first) {
        if (extends(corner_.first, right.limit.place))
            follow_after(right);
        else
            begin_cone(crossing, right, away_from(corner_.first));
    }
    if (at_left == Wedge::tangent_last) {
        if (extends(corner_.last, left.limit.place))
            follow_after(left);
        else
            begin_cone(crossing, away_from(corner_.last), left);
    }
}

GraphRows::Wedge GraphRows::wedge_of(Place p) {
    if (p == corner_.first) return Wedge::tangent_last;
    if (p == corner_.last) return Wedge::tangent_first;
    const Sign of_first = signs_.certain_side(from_, towards(corner_.first).limit, p);
    const Sign of_last = signs_.certain_side(from_, towards(corner_.last).limit, p);
    if (of_first != Sign::negative && of_last != Sign::negative) return Wedge::tangent_first;
    if (of_first != Sign::positive && of_last != Sign::positive) return Wedge::tangent_last;
    return Wedge::crossing;
}

// A cone as far as it lies in the half-plane of greater places. The ray straight down belongs to the
// other half-plane, the ray straight up to this one.
void GraphRows::begin_cone(std::uint32_t crossing, Bound right, Bound left) {
    if (!left.after && !right.after) return;
    if (right.above) {
        // Unless a corner's tangent directions begin straight up, the cone on the right has that ray.
        if (right.limit.kind == Limit::Kind::away_from && crossing != no_index)
            expansion_.expand({crossing, right.limit, right.limit});
        return;
    }
    if (crossing == no_index) {
        if (left.above && left.limit.kind == Limit::Kind::towards) follow_after(left);
        return;
    }
    if (!left.after) {
        left.limit = {0, span_, no_index, Limit::Kind::up, false, true, false};
    } else if (!right.after) {
        right.limit = {
            0,     -span_, no_index, Limit::Kind::down, right.below && right.limit.touches,
            false, true};
    }
    left.limit.armed |= left.above;
    expansion_.expand({crossing, left.limit, right.limit});
}

void GraphRows::look_along(HalfEdge h, Place p, bool above) {
    const bool left_free = t_.is_free(h);
    const bool right_free = t_.is_free(t_.twin(h));
    if (!left_free && !right_free) return;
    const bool on_boundary = left_free != right_free;
    const bool reach = corner_.kind == Corner::Kind::open ||
                       corner_.kind == Corner::Kind::general || p == corner_.first ||
                       p == corner_.last ||
                       (corner_.kind == Corner::Kind::convex && wedge_of(p) != Wedge::crossing);
    if (!reach) return;
    if (t_.is_scene_place(p) && (!on_boundary || body_edges_)) report(p);
    // The cone on the left of the ray straight up belongs to the other half-plane; a flat corner has none.
    const bool alone = (above && !right_free) || corner_.kind == Corner::Kind::flat;
    if (every_ ? t_.is_knot(p) || t_.is_wall(h) || alone : !t_.is_scene_place(p)) follow_beyond(p);
}

// Marks what lies on the boundary from h on, straight, as reported: body_edges = false.
void GraphRows::exclude_boundary(HalfEdge h) {
    if (t_.is_free(h) == t_.is_free(t_.twin(h))) return;
    RayWalk walk(t_, v_, t_.target(h));
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
    report(p);
}

}  // namespace sightline::detail
