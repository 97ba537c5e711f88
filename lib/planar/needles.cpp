// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/needles.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "planar/ray_walk.hpp"
#include "planar/view_sweep.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

using Kind = ViewVertex::Kind;

// Where the ray through w ends.
ViewVertex end_of_ray(const Triangulation& t, const Viewpoint& from, const Location& at, Place w) {
    RayWalk walk(t, from, at, w);
    walk.skip_to(w);
    Place last = w;
    for (Place p = walk.next_place(); p != no_index; p = walk.next_place()) {
        if (p < frame_places) return {.kind = Kind::infinity, .vertex = t.vertices_at(w).front()};
        last = p;
    }
    const HalfEdge h = walk.stopped_by();
    if (h == no_index) return vertex_at(t, last);
    const VertexId through = t.vertices_at(w).front();
    if (t.twin(h) == no_index) return {.kind = Kind::infinity, .vertex = through};
    return {.kind = Kind::on_edge, .vertex = through, .edge = t.scene_edge(h)};
}

// Position on a ray, to be compared with others on the same ray: infinity is last.
struct Reach {
    bool infinite;
    Rational distance;  // along the larger coordinate of the ray's direction

    friend bool operator==(const Reach&, const Reach&) = default;
    friend std::strong_ordering operator<=>(const Reach&, const Reach&) = default;
};

Reach reach_of(const ViewPoint& p, const RationalPoint2& q, const RationalPoint2& direction) {
    if (p.at_infinity) return {true, Rational(0)};
    const bool by_x = abs(direction.x) >= abs(direction.y);
    const Rational step = by_x ? p.coordinates.x - q.x : p.coordinates.y - q.y;
    return {false, abs(step)};
}

// Whether p (a point, or a direction) lies on the ray from q in the direction.
bool is_on_ray(const ViewPoint& p, const RationalPoint2& q, const RationalPoint2& d) {
    const RationalPoint2 e = p.at_infinity
                                 ? p.coordinates
                                 : RationalPoint2{p.coordinates.x - q.x, p.coordinates.y - q.y};
    return (d.x * e.y - d.y * e.x).sign() == Sign::zero &&
           (d.x * e.x + d.y * e.y).sign() == Sign::positive;
}

Sign turn(const RationalPoint2& a, const RationalPoint2& b) {
    return (a.x * b.y - a.y * b.x).sign();
}

// Whether direction d lies strictly between those of two consecutive vertices of the ring: then the ray
// runs through the polygon's interior up to what bounds it there.
bool is_between(const ViewPoint& right, const ViewPoint& left, const RationalPoint2& q,
                const RationalPoint2& d) {
    const auto direction = [&](const ViewPoint& p) {
        return p.at_infinity ? p.coordinates
                             : RationalPoint2{p.coordinates.x - q.x, p.coordinates.y - q.y};
    };
    const RationalPoint2 r = direction(right);
    const RationalPoint2 l = direction(left);
    const bool after_right = turn(r, d) == Sign::positive;
    const bool before_left = turn(d, l) == Sign::positive;
    if (turn(r, l) == Sign::positive || !right.at_infinity || !left.at_infinity)
        return after_right && before_left;
    // 180° or more, which only an unbounded range can span.
    if (turn(r, l) == Sign::negative) return after_right || before_left;
    const bool opposite = (r.x * l.x + r.y * l.y).sign() == Sign::negative;
    return opposite ? after_right : turn(r, d) != Sign::zero || r.x * d.x + r.y * d.y < Rational(0);
}

// A scene place on the ray through p, to name the ray by.
Place vertex_on_ray(const Triangulation& t, const Viewpoint& from, const Location& at, Place p) {
    if (t.is_scene_place(p)) return p;
    RayWalk walk(t, from, at, p);
    Place w = walk.next_place();
    while (w != no_index && w >= frame_places && !t.is_scene_place(w)) w = walk.next_place();
    return w == no_index || w < frame_places ? no_index : w;
}

// Along a wall that the viewpoint lies on, no other wall blocks: those rays are followed, too.
std::vector<Place> with_walls(const Triangulation& t, const Viewpoint& from, const Location& at,
                              std::vector<Place> followed) {
    const HalfEdge h = at.half_edge;
    if (at.kind == Location::Kind::edge && t.is_wall(h)) {
        followed.push_back(t.origin(h));
        followed.push_back(t.target(h));
    }
    if (from.place == no_index) return followed;
    HalfEdge k = h;
    do {
        if (t.is_wall(k)) followed.push_back(t.target(k));
        k = t.rotate_ccw(k);
    } while (k != h);
    return followed;
}

}  // namespace

std::vector<Needle> find_needles(const Scene2& scene, const Triangulation& t, const Viewpoint& from,
                                 const Location& at, const VisibilityPolygon& polygon,
                                 const std::vector<Place>& followed) {
    std::vector<Needle> needles;
    const RationalPoint2& q = polygon.from;
    std::vector<ViewPoint> ring;
    ring.reserve(polygon.ring.size());
    for (const ViewVertex& v : polygon.ring) ring.push_back(exact_point(scene, q, v));
    std::vector<std::pair<ViewPoint, ViewPoint>> seen;
    for (const Place p : with_walls(t, from, at, followed)) {
        const Place w = vertex_on_ray(t, from, at, p);
        if (w == no_index) continue;
        const RationalPoint2 target = t.exact_position(w);
        const RationalPoint2 direction{target.x - q.x, target.y - q.y};
        const ViewVertex far = end_of_ray(t, from, at, w);
        const ViewPoint far_point = exact_point(scene, q, far);
        bool is_inside = false;
        for (std::size_t i = 0; i < ring.size() && !is_inside; ++i)
            is_inside = is_between(ring[i], ring[(i + 1) % ring.size()], q, direction);
        if (is_inside) continue;
        ViewVertex near = {.kind = Kind::from};
        Reach reach{false, Rational(0)};
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (!is_on_ray(ring[i], q, direction)) continue;
            const Reach here = reach_of(ring[i], q, direction);
            if (reach < here) {
                reach = here;
                near = polygon.ring[i];
            }
        }
        if (reach_of(far_point, q, direction) <= reach) continue;
        const std::pair<ViewPoint, ViewPoint> ends{exact_point(scene, q, near), far_point};
        if (std::find(seen.begin(), seen.end(), ends) != seen.end()) continue;
        seen.push_back(ends);
        needles.push_back({near, far});
    }
    std::sort(needles.begin(), needles.end());
    return needles;
}

}  // namespace sightline::detail
