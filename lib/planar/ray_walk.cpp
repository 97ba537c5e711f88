// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/ray_walk.hpp"

#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

RationalPoint2 RayWalk::exact(const Viewpoint& v) const {
    if (v.exact != nullptr) return *v.exact;
    return v.place != no_index ? t_.exact_position(v.place) : to_rational(v.position);
}

Sign RayWalk::side(Place p) const {
    if (p == toward_.place || p == from_.place) return Sign::zero;
    if (toward_.place == no_index)
        return orientation(exact(from_), exact(toward_), t_.exact_position(p));
    if (from_.place != no_index) return t_.orientation(from_.place, toward_.place, p);
    Limit ray;
    ray.place = toward_.place;
    return ConeSigns(t_, Arithmetic::filtered).side(from_, ray, p);
}

// For p on the ray's line, other than the current place: before or behind it?
bool RayWalk::is_ahead(Place p) const {
    if (from_.place != no_index && toward_.place != no_index)
        return t_.compare(at_, p) == t_.compare(from_.place, toward_.place);
    const bool up = exact(from_) < exact(toward_);
    const RationalPoint2 here = at_ == no_index ? exact(from_) : t_.exact_position(at_);
    return (here < t_.exact_position(p)) == up;
}

bool RayWalk::reaches_target() {
    const RationalPoint2 target = exact(toward_);
    const bool up = exact(from_) < target;
    for (Place p = next_place(); p != no_index; p = next_place()) {
        const RationalPoint2 here = t_.exact_position(p);
        if (here == target || (target < here) == up) return true;
    }
    // Between the last place and the edge that the ray ran into?
    if (stopped_by_ == no_index) return false;
    return orientation(t_.exact_position(t_.origin(stopped_by_)),
                       t_.exact_position(t_.target(stopped_by_)), target) != Sign::negative;
}

void RayWalk::look_at(HalfEdge h, Surroundings& s) const {
    const Place x = t_.target(h);
    const Place y = t_.apex(h);
    const Sign sx = side(x);
    const Sign sy = side(y);
    const bool wall = t_.is_wall(h);
    const bool solid = !t_.is_free(h);
    s.wall_here |= wall;
    if (sx == Sign::positive) s.wall_left |= wall;
    if (sx == Sign::negative) s.wall_right |= wall;
    if (solid && (sx == Sign::positive || sy == Sign::positive)) s.solid_left = true;
    if (solid && (sx == Sign::negative || sy == Sign::negative)) s.solid_right = true;
    if (sx == Sign::negative && sy == Sign::positive) s.out_triangle = h;
    if (sx != Sign::zero) return;
    if (is_ahead(x)) {
        s.out_edge = h;
    } else {  // the edge along which the ray came, seen from its end
        s.in_right_free = !solid;
        s.in_left_free = t_.twin(h) != no_index && t_.is_free(t_.twin(h));
    }
}

RayWalk::Surroundings RayWalk::look() const {
    Surroundings s;
    const HalfEdge start = t_.leaving(at_);
    HalfEdge h = start;
    do {
        look_at(h, s);
        h = t_.rotate_ccw(h);
    } while (h != start && h != no_index);
    return s;
}

bool RayWalk::pass(const Surroundings& s) {
    const HalfEdge out = s.out_edge;
    bool out_left = false;
    bool out_right = false;
    if (out != no_index) {
        out_left = t_.is_free(out);
        out_right = t_.twin(out) != no_index && t_.is_free(t_.twin(out));
    } else if (s.out_triangle != no_index) {
        out_left = out_right = t_.is_free(s.out_triangle);
    }
    if (!out_left && !out_right) return false;
    const bool out_wall = out != no_index && t_.is_wall(out);
    if (at_ == from_.place) {  // a run that contains the segment's end does not block
        in_wall_ = out_wall;
        came_ = false;
        left_ = right_ = left_of_solid_ = right_of_solid_ = true;
        return true;
    }
    if (!s.wall_here) {
        in_wall_ = false;
        return true;
    }
    if (!in_wall_) {
        came_ = true;
        left_ = left_of_solid_ = s.in_left_free;
        right_ = right_of_solid_ = s.in_right_free;
    }
    const bool either_of_solid = left_of_solid_ || right_of_solid_;
    const bool left = left_ && out_left && !s.wall_left && !s.solid_left;
    const bool right = right_ && out_right && !s.wall_right && !s.solid_right;
    const bool solid_left = either_of_solid && s.in_left_free && out_left && !s.solid_left;
    const bool solid_right = either_of_solid && s.in_right_free && out_right && !s.solid_right;
    left_ = left;
    right_ = right;
    left_of_solid_ = right_of_solid_ = solid_left || solid_right;
    in_wall_ = out_wall;
    return out_wall || !came_ || left || right || !left_of_solid_;
}

bool RayWalk::can_leave() {
    const RayWalk before = *this;
    const bool result = pass(look());
    in_wall_ = before.in_wall_;
    came_ = before.came_;
    left_ = before.left_;
    right_ = before.right_;
    left_of_solid_ = before.left_of_solid_;
    right_of_solid_ = before.right_of_solid_;
    return result;
}

Place RayWalk::next_place() {
    stopped_by_ = no_index;
    if (at_ == no_index) return at_ = first_place(start_);
    const Surroundings s = look();
    if (!pass(s)) return no_index;
    if (s.out_edge != no_index) {
        at_ = t_.target(s.out_edge);
        along_boundary_ = t_.is_constrained(s.out_edge) &&
                          !(t_.is_free(s.out_edge) && t_.twin(s.out_edge) != no_index &&
                            t_.is_free(t_.twin(s.out_edge)));
    } else {
        const Place reached = cross_triangles(next(s.out_triangle));
        along_boundary_ = false;
        if (reached == no_index) return no_index;
        at_ = reached;
    }
    return at_;
}

void RayWalk::skip_to(Place w) {
    if (!t_.has_walls()) {
        at_ = w;
        return;
    }
    while (at_ != w) {
        if (next_place() != no_index) continue;
        // The walk is exact, but whoever called it w visible may have computed in `double_` or `interval`.
        at_ = w;
        in_wall_ = false;
    }
}

// The ray leaves a triangle through h, which runs from its right to its left.
Place RayWalk::cross_triangles(HalfEdge h) {
    while (t_.is_open(h)) {
        const HalfEdge g = t_.twin(h);
        const Place apex = t_.apex(g);
        const Sign s = side(apex);
        if (s == Sign::zero) return apex;
        h = s == Sign::positive ? next(g) : prev(g);
    }
    stopped_by_ = h;
    return no_index;
}

// What the ray reaches that leaves a triangle by h or an end of h; nothing when it leaves by another edge.
std::optional<Place> RayWalk::leave_by(HalfEdge h) {
    for (const Place end : {t_.origin(h), t_.target(h)})
        if (side(end) == Sign::zero && is_ahead(end)) return end;
    if (side(t_.origin(h)) == Sign::negative && side(t_.target(h)) == Sign::positive)
        return cross_triangles(h);
    return std::nullopt;
}

// From a start that is no place: through its triangle, or along its edge.
Place RayWalk::first_place(const Location& start) {
    if (start.kind == Location::Kind::edge && side(t_.origin(start.half_edge)) == Sign::zero) {
        const bool to_target = is_ahead(t_.target(start.half_edge));
        const bool wall = t_.is_wall(start.half_edge);
        in_wall_ = wall;
        return to_target ? t_.target(start.half_edge) : t_.origin(start.half_edge);
    }
    for (const HalfEdge base : {start.half_edge, t_.twin(start.half_edge)}) {
        if (base == no_index || (base != start.half_edge && start.kind != Location::Kind::edge))
            continue;
        if (!t_.is_free(base)) continue;
        for (const HalfEdge h : {base, next(base), prev(base)}) {
            if (start.kind == Location::Kind::edge && h == base) continue;
            if (const std::optional<Place> reached = leave_by(h)) return *reached;
        }
    }
    return no_index;
}

}  // namespace sightline::detail
