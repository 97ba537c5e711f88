// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/needles.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "planar/ray_walk.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

using Kind = ViewVertex::Kind;

ViewVertex at_place(const Triangulation& t, Place p) {
    return {.kind = Kind::vertex, .vertex = t.vertices_at(p).front()};
}

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
    if (h == no_index) return at_place(t, last);
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

}  // namespace

std::vector<Needle> find_needles(const Scene2& scene, const Triangulation& t, const Viewpoint& from,
                                 const Location& at, const VisibilityPolygon& polygon,
                                 const std::vector<Place>& followed) {
    std::vector<Needle> needles;
    const RationalPoint2& q = polygon.from;
    std::vector<ViewPoint> ring;
    for (const ViewVertex& v : polygon.ring) ring.push_back(exact_point(scene, q, v));
    std::vector<std::pair<ViewPoint, ViewPoint>> seen;
    for (const Place w : followed) {
        if (!t.is_scene_place(w)) continue;
        const RationalPoint2 target = t.exact_position(w);
        const RationalPoint2 direction{target.x - q.x, target.y - q.y};
        const ViewVertex far = end_of_ray(t, from, at, w);
        const ViewPoint far_point = exact_point(scene, q, far);
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
