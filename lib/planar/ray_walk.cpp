// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/ray_walk.hpp"

namespace sightline::detail {

Sign RayWalk::side(Place p) const {
    return p == from_ || p == toward_ ? Sign::zero : t_.orientation(from_, toward_, p);
}

// For p on the ray's line, other than the current place: before or behind it?
bool RayWalk::is_ahead(Place p) const { return t_.compare(at_, p) == t_.compare(from_, toward_); }

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
    if (at_ == from_) {  // a run that contains the segment's end does not block
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
    bool left = left_ && out_left && !s.wall_left && !s.solid_left;
    bool right = right_ && out_right && !s.wall_right && !s.solid_right;
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
    const Surroundings s = look();
    if (!pass(s)) return no_index;
    if (s.out_edge != no_index) {
        at_ = t_.target(s.out_edge);
        along_boundary_ = t_.is_constrained(s.out_edge) && !(t_.is_free(s.out_edge) && t_.twin(s.out_edge) != no_index && t_.is_free(t_.twin(s.out_edge)));
    } else {
        at_ = cross_triangles(next(s.out_triangle));
        along_boundary_ = false;
    }
    return at_;
}

void RayWalk::skip_to(Place w) {
    if (!t_.has_walls()) {
        at_ = w;
        return;
    }
    while (at_ != w && at_ != no_index) at_ = next_place();
    SIGHTLINE_EXPECT(at_ == w);
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
    return no_index;
}

}  // namespace sightline::detail
