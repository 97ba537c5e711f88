// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/delaunay.hpp"

#include <cfloat>
#include <cmath>

namespace sightline::detail {

HalfEdge Delaunay::add_triangle() {
    if (slot_ != no_index) {
        slot_ += 4;
        return slot_ - 4;
    }
    const std::size_t h = t_.origin_.size();
    t_.origin_.resize(h + 4, no_index);
    t_.twin_.resize(h + 4, no_index);
    t_.kind_.resize(h + 4, 0);
    return static_cast<HalfEdge>(h);
}

void Delaunay::insert(Place begin, Place end, HalfEdge start) {
    for (Place p = begin; p < end; ++p) start = insert(p, start);
}

// A half-edge whose triangle contains p in its closure. Visibility walk; the order of the two tests
// alternates pseudo-randomly, which ends the walk in any triangulation with probability 1.
HalfEdge Delaunay::locate(Place p, HalfEdge start) {
    HalfEdge h = start;
    if (side(h, p) == Sign::negative) h = t_.twin_[h];
    while (true) {
        turn_ = turn_ * 1664525U + 1013904223U;
        const bool swap = (turn_ & 0x80000000U) != 0;
        const HalfEdge first = swap ? prev(h) : next(h);
        const HalfEdge second = swap ? next(h) : prev(h);
        if (side(first, p) == Sign::negative)
            h = t_.twin_[first];
        else if (side(second, p) == Sign::negative)
            h = t_.twin_[second];
        else
            return h;
    }
}

HalfEdge Delaunay::insert(Place p, HalfEdge start) {
    const HalfEdge h = locate(p, start);
    for (const HalfEdge e : {h, next(h), prev(h)}) {
        if (side(e, p) != Sign::zero) continue;
        insert_on_edge(p, e);
        restore_star();
        return e;
    }
    insert_in_triangle(p, h);
    restore_star();
    return h;
}

void Delaunay::insert_in_triangle(Place p, HalfEdge h) {
    const HalfEdge n = next(h);
    const HalfEdge v = prev(h);
    const Place a = t_.origin_[h];
    const Place b = t_.origin_[n];
    const Place c = t_.origin_[v];
    const HalfEdge twin_n = t_.twin_[n];
    const HalfEdge twin_v = t_.twin_[v];
    const HalfEdge s = add_triangle();  // b c p
    const HalfEdge u = add_triangle();  // c a p
    t_.origin_[s] = b;
    t_.origin_[s + 1] = c;
    t_.origin_[s + 2] = p;
    t_.origin_[u] = c;
    t_.origin_[u + 1] = a;
    t_.origin_[u + 2] = p;
    t_.origin_[v] = p;  // h: a b p
    link(s, twin_n);
    link(u, twin_v);
    link(n, s + 2);
    link(s + 1, u + 2);
    link(u + 1, v);
    pending_.insert(pending_.end(), {h, s, u});
}

// p lies on the edge of h; both triangles are halved, kinds of the two halves of the edge are kept.
void Delaunay::insert_on_edge(Place p, HalfEdge h) {
    const HalfEdge g = t_.twin_[h];
    const HalfEdge hn = next(h);
    const HalfEdge gp = prev(g);
    const Place b = t_.origin_[hn];
    const Place c = t_.origin_[prev(h)];
    const Place d = t_.origin_[gp];
    const HalfEdge twin_hn = t_.twin_[hn];
    const HalfEdge twin_gp = t_.twin_[gp];
    const HalfEdge s = add_triangle();  // p b c
    const HalfEdge u = add_triangle();  // b p d
    t_.origin_[s] = p;
    t_.origin_[s + 1] = b;
    t_.origin_[s + 2] = c;
    t_.origin_[u] = b;
    t_.origin_[u + 1] = p;
    t_.origin_[u + 2] = d;
    t_.kind_[s] = t_.kind_[u] = t_.kind_[h];
    t_.kind_[s + 1] = t_.kind_[hn];
    t_.kind_[u + 2] = t_.kind_[gp];
    t_.kind_[hn] = t_.kind_[gp] = 0;
    t_.origin_[hn] = p;  // h: a p c
    t_.origin_[g] = p;   // g: p a d
    link(s, u);
    link(s + 1, twin_hn);
    link(s + 2, hn);
    link(u + 2, twin_gp);
    link(u + 1, gp);
    pending_.insert(pending_.end(), {prev(h), s + 1, u + 2, next(g)});
}

void Delaunay::restore_star() {
    while (!pending_.empty()) {
        const HalfEdge e = pending_.back();
        pending_.pop_back();
        const HalfEdge g = t_.twin_[e];
        if (g == no_index || !is_certainly_in_circle(e)) continue;
        flip(e);
        pending_.push_back(e);
        pending_.push_back(prev(g));
    }
}

// Before: e = a→b with apex p, its twin g = b→a with apex o. After: e = a→o and prev(g) = o→b both
// have apex p.
void Delaunay::flip(HalfEdge e) {
    const HalfEdge g = t_.twin_[e];
    const HalfEdge en = next(e);
    const HalfEdge gn = next(g);
    const HalfEdge x = t_.twin_[gn];
    const HalfEdge y = t_.twin_[en];
    t_.origin_[en] = t_.origin_[prev(g)];
    t_.origin_[gn] = t_.origin_[prev(e)];
    t_.kind_[e] = t_.kind_[gn];
    t_.kind_[g] = t_.kind_[en];
    t_.kind_[en] = t_.kind_[gn] = 0;
    link(e, x);
    link(g, y);
    link(en, gn);
}

// Whether the apex beyond e lies inside the circle of e's triangle, beyond doubt. The bound is
// Shewchuk's for this formula ("Adaptive precision floating-point arithmetic", 1997, section 4.4).
// It knows no underflow: that is off by 2^-1075 a product, so by less than DBL_MIN times the other
// factors, and by less than 2^-53 · 2^-900 in the last three products.
bool Delaunay::is_certainly_in_circle(HalfEdge e) const {
    constexpr double u = DBL_EPSILON / 2;
    constexpr double bound = (10 + 96 * u) * u;
    const Point2& d = t_.position_[t_.origin_[prev(t_.twin_[e])]];
    const Point2& a = t_.position_[t_.origin_[e]];
    const Point2& b = t_.position_[t_.origin_[next(e)]];
    const Point2& c = t_.position_[t_.origin_[prev(e)]];
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;
    const double bc = bx * cy, cb = cx * by;
    const double ca = cx * ay, ac = ax * cy;
    const double ab = ax * by, ba = bx * ay;
    const double al = ax * ax + ay * ay;
    const double bl = bx * bx + by * by;
    const double cl = cx * cx + cy * cy;
    const double det = al * (bc - cb) + bl * (ca - ac) + cl * (ab - ba);
    const double size = (std::fabs(bc) + std::fabs(cb)) * al +
                        (std::fabs(ca) + std::fabs(ac)) * bl + (std::fabs(ab) + std::fabs(ba)) * cl;
    if (!(det > bound * size && det < DBL_MAX && size > 0x1p-900)) return false;
    const double minors = std::fabs(bc) + std::fabs(cb) + std::fabs(ca) + std::fabs(ac) +
                          std::fabs(ab) + std::fabs(ba);
    return det > bound * size + DBL_MIN * (al + bl + cl + minors);
}

void Delaunay::restore(const std::vector<HalfEdge>& edges) {
    pending_ = edges;
    while (!pending_.empty()) {
        const HalfEdge e = pending_.back();
        pending_.pop_back();
        const HalfEdge g = t_.twin_[e];
        if (g == no_index || t_.kind_[e] != 0 || !is_certainly_in_circle(e)) continue;
        flip(e);
        for (const HalfEdge h : {e, prev(e), g, prev(g)}) {
            t_.leaving_[t_.origin_[h]] = h;
            pending_.push_back(h);
        }
    }
}

}  // namespace sightline::detail
