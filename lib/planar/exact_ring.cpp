// SPDX-License-Identifier: GPL-3.0-or-later
// Exact coordinates of visibility polygons, and the canonical form of their rings.
#include <algorithm>

#include "planar/exact_ring.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline {
namespace {

using Kind = ViewVertex::Kind;

RationalPoint2 minus(const RationalPoint2& a, const RationalPoint2& b) {
    return {a.x - b.x, a.y - b.y};
}
Rational cross(const RationalPoint2& a, const RationalPoint2& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const RationalPoint2& a, const RationalPoint2& b) { return a.x * b.x + a.y * b.y; }

// Where the line from p in direction d meets the line of an edge.
RationalPoint2 meet(const Scene2& scene, const RationalPoint2& p, const RationalPoint2& d,
                    EdgeId e) {
    const RationalPoint2 a = to_rational(scene[scene[e].source]);
    const RationalPoint2 along = minus(to_rational(scene[scene[e].target]), a);
    const Rational s = cross(minus(a, p), along) / cross(d, along);
    return {p.x + s * d.x, p.y + s * d.y};
}

ViewPoint infinite(const RationalPoint2& direction) {
    const Rational size = std::max(abs(direction.x), abs(direction.y));
    return {{direction.x / size, direction.y / size}, true};
}

ViewPoint axis_direction(unsigned axis) {
    constexpr int x[] = {1, 0, -1, 0};
    constexpr int y[] = {0, 1, 0, -1};
    return {{Rational(x[axis % 4]), Rational(y[axis % 4])}, true};
}

// Whether the turn at b can be left out: b lies strictly between its neighbours.
bool is_straight(const ViewPoint& a, const ViewPoint& b, const ViewPoint& c) {
    if (b.at_infinity || (a.at_infinity && c.at_infinity)) return false;
    const RationalPoint2 in = a.at_infinity ? RationalPoint2{-a.coordinates.x, -a.coordinates.y}
                                            : minus(b.coordinates, a.coordinates);
    const RationalPoint2 out = c.at_infinity ? c.coordinates : minus(c.coordinates, b.coordinates);
    return cross(in, out).sign() == Sign::zero && dot(in, out).sign() == Sign::positive;
}

// Between the first and the last direction of an unbounded range of 180° or more: the axes inside it.
void add_axes(std::vector<ViewPoint>& ring, const ViewPoint& first, const ViewPoint& last) {
    const RationalPoint2& d = first.coordinates;
    const RationalPoint2& e = last.coordinates;
    const Sign turn = cross(d, e).sign();
    if (turn == Sign::positive || (turn == Sign::zero && dot(d, e).sign() == Sign::positive))
        return;
    // Axes in counter-clockwise order from the first one strictly after d.
    const auto is_after = [&](const ViewPoint& axis) {
        const Sign from_first = cross(d, axis.coordinates).sign();
        const Sign to_last = cross(axis.coordinates, e).sign();
        if (from_first == Sign::zero && dot(d, axis.coordinates).sign() == Sign::positive)
            return false;
        return from_first == Sign::positive || to_last == Sign::positive;
    };
    unsigned start = 0;
    while (!(cross(d, axis_direction(start).coordinates).sign() == Sign::positive &&
             cross(d, axis_direction(start + 3U).coordinates).sign() != Sign::positive))
        ++start;
    for (unsigned i = 0; i < 4 && is_after(axis_direction(start + i)); ++i)
        ring.push_back(axis_direction(start + i));
}

// Inserts axes into unbounded ranges; the ring is returned from its first finite vertex on.
std::vector<ViewPoint> with_axes(const std::vector<ViewPoint>& ring) {
    const std::size_t n = ring.size();
    const auto finite =
        std::find_if(ring.begin(), ring.end(), [](const auto& p) { return !p.at_infinity; });
    if (finite == ring.end()) return ring;
    const auto start = static_cast<std::size_t>(finite - ring.begin());
    std::vector<ViewPoint> out;
    for (std::size_t i = 0; i < n; ++i) {
        const ViewPoint& p = ring[(start + i) % n];
        if (p.at_infinity && !out.empty() && out.back().at_infinity)
            add_axes(out, ViewPoint(out.back()), p);
        out.push_back(p);
    }
    return out;
}

void drop_repeats_and_straight(std::vector<ViewPoint>& ring) {
    bool changed = true;
    while (changed && ring.size() > 2) {
        changed = false;
        std::vector<ViewPoint> kept;
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i) {
            const ViewPoint& before = kept.empty() ? ring[n - 1] : kept.back();
            const ViewPoint& p = ring[i];
            const ViewPoint& after = ring[(i + 1) % n];
            if (p == before || is_straight(before, p, after))
                changed = true;
            else
                kept.push_back(p);
        }
        ring = std::move(kept);
    }
}

bool is_before(const ViewPoint& a, const ViewPoint& b) {
    if (a.at_infinity != b.at_infinity) return b.at_infinity;
    return a.coordinates < b.coordinates;
}

}  // namespace

ViewPoint exact_point(const Scene2& scene, const RationalPoint2& from, const ViewVertex& v) {
    switch (v.kind) {
        case Kind::vertex:
            return {to_rational(scene[v.vertex]), false};
        case Kind::on_edge:
            return {meet(scene, from, minus(to_rational(scene[v.vertex]), from), v.edge), false};
        case Kind::crossing: {
            const RationalPoint2 a = to_rational(scene[scene[v.other].source]);
            return {meet(scene, a, minus(to_rational(scene[scene[v.other].target]), a), v.edge),
                    false};
        }
        case Kind::infinity:
            return infinite(minus(to_rational(scene[v.vertex]), from));
        case Kind::direction:
            return axis_direction(v.axis);
        case Kind::from:
            break;
    }
    return {from, false};
}

std::vector<ViewPoint> detail::canonical_form(std::vector<ViewPoint> ring) {
    drop_repeats_and_straight(ring);
    if (ring.empty()) return ring;
    const auto n = static_cast<std::ptrdiff_t>(ring.size());
    std::vector<ViewPoint> best;
    const auto least = *std::min_element(ring.begin(), ring.end(), is_before);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        if (ring[static_cast<std::size_t>(i)] != least) continue;
        std::vector<ViewPoint> turned(ring.begin() + i, ring.end());
        turned.insert(turned.end(), ring.begin(), ring.begin() + i);
        if (best.empty() || std::lexicographical_compare(turned.begin(), turned.end(), best.begin(),
                                                         best.end(), is_before))
            best = std::move(turned);
    }
    return best;
}

std::vector<ViewPoint> exact_ring(const Scene2& scene, const VisibilityPolygon& polygon) {
    std::vector<ViewPoint> ring;
    ring.reserve(polygon.ring.size());
    for (const ViewVertex& v : polygon.ring) ring.push_back(exact_point(scene, polygon.from, v));
    return detail::canonical_form(with_axes(ring));
}

}  // namespace sightline
