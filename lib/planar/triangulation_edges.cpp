// SPDX-License-Identifier: GPL-3.0-or-later
// The constraint step: scene edges enter the triangulation by flipping what they cross (Sloan 1993),
// walls that cross are split at an exactly constructed place; then triangles are labelled.
#include <deque>
#include <utility>

#include "planar/triangulation_builder.hpp"

namespace sightline::detail {

void TriangulationBuilder::insert_edges() {
    found_.reserve(scene_.edge_count());
    for (const Edge2& e : scene_.edges()) {
        const bool wall = e.kind == EdgeKind2::wall;
        t_.has_walls_ |= wall;
        const Place a = t_.place_of(e.source);
        const Place b = t_.place_of(e.target);
        const std::uint8_t kind = wall ? Triangulation::wall_bit : Triangulation::boundary_bit;
        const HalfEdge h = find(a, b);
        found_.push_back(h);
        if (h != no_index)
            set_kind(h, kind);
        else
            insert_edge(a, b, kind);
    }
}

void TriangulationBuilder::insert_edge(Place a, Place b, std::uint8_t kind) {
    while (a != b) a = insert_edge_piece(a, b, kind);
}

// The half-edge a→b, or no_index.
HalfEdge TriangulationBuilder::find(Place a, Place b) const {
    const HalfEdge start = t_.leaving_[a];
    HalfEdge h = start;
    do {
        if (t_.origin_[next(h)] == b) return h;
        h = t_.twin_[prev(h)];
    } while (h != start && h != no_index);
    // A corner of the frame has no full turn: go on clockwise from the start.
    for (h = h == start ? no_index : t_.twin_[start]; h != no_index; h = t_.twin_[next(h)])
        if (t_.origin_[next(next(h))] == b) return next(h);
    return no_index;
}

void TriangulationBuilder::set_kind(HalfEdge h, std::uint8_t kind) {
    t_.kind_[h] |= kind;
    t_.kind_[t_.twin_[h]] |= kind;
}

// The half-edge opposite a that the ray a→b crosses; or no_index and the first place on the ray.
HalfEdge TriangulationBuilder::first_crossed(Place a, Place b, Place& on_edge) const {
    HalfEdge h = t_.leaving_[a];
    while (true) {
        const Place p = t_.origin_[next(h)];
        const Sign at_p = t_.orientation(a, b, p);
        if (at_p == Sign::zero && t_.compare(a, p) == t_.compare(a, b)) {
            on_edge = p;
            return no_index;
        }
        if (at_p == Sign::negative && t_.orientation(a, b, t_.origin_[prev(h)]) == Sign::positive)
            return next(h);
        h = t_.twin_[prev(h)];
    }
}

// Makes the first piece of a→b an edge; returns where it ends.
Place TriangulationBuilder::insert_edge_piece(Place a, Place b, std::uint8_t kind) {
    if (const HalfEdge h = find(a, b); h != no_index) {
        set_kind(h, kind);
        return b;
    }
    Place end = no_index;
    HalfEdge h = first_crossed(a, b, end);
    if (h == no_index) {
        set_kind(find(a, end), kind);
        return end;
    }
    std::vector<std::pair<Place, Place>> crossed;
    while (end == no_index) {
        if (t_.kind_[h] != 0) {
            end = split_crossing(a, b, h);
            break;
        }
        crossed.emplace_back(t_.origin_[h], t_.origin_[next(h)]);
        const HalfEdge g = t_.twin_[h];
        const Place apex = t_.origin_[prev(g)];
        const Sign s = apex == b ? Sign::zero : t_.orientation(a, b, apex);
        if (s == Sign::zero) end = apex;
        // Seen along a→b the crossed edge runs from right to left: g from left to right.
        h = s == Sign::positive ? next(g) : prev(g);
    }
    flip_away(a, end, std::move(crossed), kind);
    return end;
}

// Two walls cross: their common point becomes a place, known by its exact coordinates.
Place TriangulationBuilder::split_crossing(Place a, Place b, HalfEdge crossed) {
    const RationalPoint2 p = t_.exact_position(a);
    const RationalPoint2 q = t_.exact_position(b);
    const RationalPoint2 r = t_.exact_position(t_.origin_[crossed]);
    const RationalPoint2 s = t_.exact_position(t_.origin_[next(crossed)]);
    const Rational dx = q.x - p.x, dy = q.y - p.y;
    const Rational ex = s.x - r.x, ey = s.y - r.y;
    const Rational along = ((r.x - p.x) * ey - (r.y - p.y) * ex) / (dx * ey - dy * ex);
    const RationalPoint2 meeting{p.x + along * dx, p.y + along * dy};
    const auto place = static_cast<Place>(t_.position_.size());
    t_.constructed_.push_back(meeting);
    t_.position_.push_back(approx_point(meeting));
    t_.leaving_.push_back(no_index);
    const std::size_t before = t_.origin_.size();
    const HalfEdge g = t_.twin_[crossed];
    delaunay_.insert_on_edge(place, crossed);  // the in-circle filter would need double coordinates
    for (const HalfEdge base :
         {crossed & ~3U, g & ~3U, static_cast<HalfEdge>(before), static_cast<HalfEdge>(before + 4)})
        for (HalfEdge h = base; h < base + 3; ++h) t_.leaving_[t_.origin_[h]] = h;
    return place;
}

bool TriangulationBuilder::is_flippable(HalfEdge h) const {
    const HalfEdge g = t_.twin_[h];
    const Place p = t_.origin_[prev(h)];
    const Place o = t_.origin_[prev(g)];
    return t_.orientation(p, t_.origin_[h], o) == Sign::positive &&
           t_.orientation(o, t_.origin_[g], p) == Sign::positive;
}

// Flips the crossed edges until a→b is an edge. An edge whose quadrilateral is not strictly convex
// waits for its neighbours' turn.
void TriangulationBuilder::flip_away(Place a, Place b, std::vector<std::pair<Place, Place>> crossed,
                                     std::uint8_t kind) {
    std::deque<std::pair<Place, Place>> queue(crossed.begin(), crossed.end());
    std::vector<std::pair<Place, Place>> made;
    while (!queue.empty()) {
        const auto [p, q] = queue.front();
        queue.pop_front();
        const HalfEdge h = find(p, q);
        if (!is_flippable(h)) {
            queue.emplace_back(p, q);
            continue;
        }
        const HalfEdge g = t_.twin_[h];
        delaunay_.flip(h);
        t_.leaving_[t_.origin_[h]] = h;
        t_.leaving_[t_.origin_[g]] = g;
        const HalfEdge diagonal = next(h);
        const Place u = t_.origin_[diagonal];
        const Place v = t_.origin_[next(diagonal)];
        const bool meets_end = u == a || u == b || v == a || v == b;
        if (!meets_end && t_.orientation(a, b, u) != t_.orientation(a, b, v))
            queue.emplace_back(u, v);
        else
            made.emplace_back(u, v);
    }
    set_kind(find(a, b), kind);
    improve(made);
}

void TriangulationBuilder::improve(const std::vector<std::pair<Place, Place>>& edges) {
    if (t_.has_constructed()) return;
    for (const auto& [u, v] : edges)
        if (const HalfEdge h = find(u, v); h != no_index) delaunay_.restore({h});
}

void TriangulationBuilder::label() {
    t_.scene_edge_.assign(t_.origin_.size(), EdgeId::none());
    t_.solid_.assign(t_.origin_.size() / 4, 0);
    pending_.clear();
    for (std::uint32_t e = 0; e < scene_.edge_count(); ++e) label_edge(EdgeId{e});
    found_ = {};
    flood_solid();
    find_pinches();
}

void TriangulationBuilder::label_edge(EdgeId id) {
    const Edge2& edge = scene_[id];
    const Place b = t_.place_of(edge.target);
    for (Place a = t_.place_of(edge.source); a != b;) {
        // Where it was when it entered, unless a later edge's flips moved it.
        HalfEdge h = found_[id.index()];
        if (h == no_index || t_.origin_[h] != a || t_.origin_[next(h)] != b) h = find(a, b);
        Place end = b;
        if (h == no_index) {
            static_cast<void>(first_crossed(a, b, end));
            h = find(a, end);
        }
        const HalfEdge g = t_.twin_[h];
        if (edge.kind == EdgeKind2::wall) {
            if (t_.scene_edge_[h].is_none()) t_.scene_edge_[h] = id;
            if (t_.scene_edge_[g].is_none()) t_.scene_edge_[g] = id;
        } else {
            boundary_.push_back(h);
            t_.scene_edge_[h] = id;
            EdgeId& outside = t_.scene_edge_[g];
            if (outside.is_none() || scene_[outside].kind == EdgeKind2::wall) outside = id;
            if (t_.solid_[h >> 2U] == 0) pending_.push_back(h);
            t_.solid_[h >> 2U] = 1;
        }
        a = end;
    }
}

void TriangulationBuilder::flood_solid() {
    while (!pending_.empty()) {
        const HalfEdge base = pending_.back() & ~3U;
        pending_.pop_back();
        for (HalfEdge h = base; h < base + 3; ++h) {
            const HalfEdge g = t_.twin_[h];
            if (g == no_index || (t_.kind_[h] & Triangulation::boundary_bit) != 0) continue;
            if (t_.solid_[g >> 2U] != 0) continue;
            t_.solid_[g >> 2U] = 1;
            pending_.push_back(g);
        }
    }
}

void TriangulationBuilder::find_pinches() {
    std::vector<std::uint8_t> sectors(t_.position_.size(), 0);
    t_.pinch_.assign(t_.position_.size(), 0);
    for (const HalfEdge h : boundary_) {  // where a sector of B begins
        if (t_.solid_[t_.twin_[h] >> 2U] != 0) continue;
        if (++sectors[t_.origin_[h]] >= 2) t_.pinch_[t_.origin_[h]] = Triangulation::pinch_bit;
    }
    if (!t_.has_walls_) return;
    for (HalfEdge h = 0; h < t_.origin_.size(); ++h)
        if ((h & 3U) != 3U && t_.is_wall(h) && ++sectors[t_.origin_[h]] >= 3)
            t_.pinch_[t_.origin_[h]] |= Triangulation::knot_bit;
}

}  // namespace sightline::detail
