// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/view_sweep.hpp"

namespace sightline::detail {

using Kind = ViewVertex::Kind;

// Where two walls cross: by any edge of each.
ViewVertex vertex_at(const Triangulation& t, Place p) {
    if (t.is_scene_place(p)) return {.kind = Kind::vertex, .vertex = t.vertices_at(p).front()};
    ViewVertex v{.kind = Kind::crossing};
    const HalfEdge start = t.leaving(p);
    HalfEdge h = start;
    do {
        const EdgeId e = t.scene_edge(h);
        if (!e.is_none()) {
            if (v.edge.is_none() || e == v.edge)
                v.edge = e;
            else if (v.other.is_none() || e < v.other)
                v.other = e;
        }
        h = t.rotate_ccw(h);
    } while (h != start);
    if (v.other < v.edge) std::swap(v.edge, v.other);
    return v;
}

ViewSweep::ViewSweep(const Triangulation& t, const Crossings& crossings, Arithmetic arithmetic)
    : t_(t), crossings_(crossings), signs_(t, arithmetic), expansion_(crossings, signs_, *this) {}

void ViewSweep::run(const Viewpoint& from, const Location& at, std::vector<ViewVertex>& ring) {
    from_ = from;
    ring_ = &ring;
    ring.clear();
    followed_.clear();
    has_piece_ = false;
    expansion_.look_from(from_);
    const HalfEdge h = at.half_edge;
    switch (at.kind) {
        case Location::Kind::triangle:
            for (const HalfEdge far_edge : {h, next(h), prev(h)}) look_into(far_edge);
            break;
        case Location::Kind::edge: {
            const HalfEdge g = t_.twin(h);
            const bool both = t_.is_free(h) && t_.is_free(g);
            for (const HalfEdge side : {h, g}) {
                if (!t_.is_free(side)) continue;
                look_into(next(side));
                look_into(prev(side));
            }
            if (!both) add_piece(EdgeId::none(), {.kind = Kind::from}, {.kind = Kind::from});
            break;
        }
        case Location::Kind::place:
            look_around(t_.origin(h));
            break;
    }
    close();
}

// All free triangles round v, counter-clockwise, each run of them closed by the viewpoint itself.
void ViewSweep::look_around(Place v) {
    HalfEdge start = t_.leaving(v);
    const HalfEdge first = start;
    // Start where a free run starts, if B is there at all.
    do {
        if (t_.is_free(start) && !t_.is_free(t_.twin(start))) break;
        start = t_.rotate_ccw(start);
    } while (start != first);
    HalfEdge h = start;
    bool in_run = false;
    do {
        if (t_.is_free(h)) {
            look_into(next(h));
            in_run = true;
        } else if (in_run) {
            add_piece(EdgeId::none(), {.kind = Kind::from}, {.kind = Kind::from});
            in_run = false;
        }
        h = t_.rotate_ccw(h);
    } while (h != start);
}

// The cone between the ends of an edge that the viewpoint sees through an empty triangle.
void ViewSweep::look_into(HalfEdge far_edge) {
    const auto towards = [&](Place p) {
        const Point2& q = t_.position(p);
        return Limit{q.x - from_.position.x,
                     q.y - from_.position.y,
                     p,
                     Limit::Kind::towards,
                     true,
                     t_.is_knot(p),
                     false};
    };
    const Cone cone{Crossings::beyond(t_, far_edge), towards(t_.target(far_edge)),
                    towards(t_.origin(far_edge))};
    if (cone.crossing == no_index) {
        blocked(far_edge, cone);
        if (cone.left.armed) follow(cone.left);
        if (cone.right.armed) follow(cone.right);
    } else {
        expansion_.expand(cone);
    }
}

// The end of a cone's piece of the edge `exit`, whose end on that side is the place `corner`.
ViewVertex ViewSweep::end(HalfEdge exit, const Limit& limit, Place corner) const {
    const bool infinite = t_.twin(exit) == no_index;
    if (limit.place < frame_places) return {.kind = Kind::direction};  // dropped
    if (limit.touches && !infinite) return vertex_at(t_, corner);
    const VertexId through = t_.vertices_at(limit.place).front();
    if (infinite) return {.kind = Kind::infinity, .vertex = through};
    return {.kind = Kind::on_edge, .vertex = through, .edge = t_.scene_edge(exit)};
}

void ViewSweep::blocked(HalfEdge exit, const Cone& cone) {
    const EdgeId carrier = t_.twin(exit) == no_index ? EdgeId::none() : t_.scene_edge(exit);
    add_piece(carrier, end(exit, cone.right, t_.origin(exit)),
              end(exit, cone.left, t_.target(exit)));
}

// A cone that was split by a vertex without effect gives two pieces of one carrier that meet: one.
void ViewSweep::add_piece(EdgeId carrier, const ViewVertex& right, const ViewVertex& left) {
    std::vector<ViewVertex>& ring = *ring_;
    const bool meets = has_piece_ && !ring.empty() && ring.back() == right;
    const bool goes_on =
        meets && carrier == carrier_ && right.kind != Kind::vertex && right.kind != Kind::crossing;
    if (goes_on)
        ring.pop_back();
    else if (right.kind != Kind::direction && !meets)
        ring.push_back(right);
    if (left.kind != Kind::direction && (goes_on || left != right)) ring.push_back(left);
    if (!has_piece_) first_carrier_ = carrier;
    carrier_ = carrier;
    has_piece_ = true;
}

void ViewSweep::close() {
    std::vector<ViewVertex>& ring = *ring_;
    if (ring.size() > 1 && ring.front() == ring.back()) {
        const bool straight = carrier_ == first_carrier_ && ring.front().kind != Kind::vertex &&
                              ring.front().kind != Kind::crossing &&
                              ring.front().kind != Kind::from;
        ring.pop_back();
        if (straight) ring.erase(ring.begin());
    }
    if (ring.empty())
        for (std::uint8_t axis = 0; axis < 4; ++axis)
            ring.push_back({.kind = Kind::direction, .axis = axis});
}

}  // namespace sightline::detail
