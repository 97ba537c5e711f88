// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "scene/boolean.hpp"
#include "scene/box_tree.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;
using CgalSet = CGAL::Polygon_set_2<Kernel>;

CgalRing to_cgal(const Ring2& ring, bool counter_clockwise) {
    CgalRing result;
    for (const Point2& p : ring) result.push_back(Kernel::Point_2(p.x, p.y));
    if (result.is_counterclockwise_oriented() != counter_clockwise) result.reverse_orientation();
    return result;
}

CgalPolygon to_cgal(const Polygon2& polygon) {
    CgalPolygon result(to_cgal(polygon.outer, true));
    for (const Ring2& hole : polygon.holes) result.add_hole(to_cgal(hole, false));
    return result;
}

/// The ring with a vertex wherever one of its vertices lies on one of its edges.
Ring2 with_touching_vertices(const Ring2& ring) {
    std::vector<Box2> boxes;
    boxes.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
        boxes.push_back(Box2::of(ring[i], ring[(i + 1) % ring.size()]));
    std::vector<std::vector<Point2>> inside(ring.size());  // an edge
    const BoxTree tree(boxes);
    for (const Point2& p : ring)
        tree.query(
            Box2::of(p, p), [](const Box2&) { return true; },
            [&](std::uint32_t i) {
                const Segment2 edge{ring[i], ring[(i + 1) % ring.size()]};
                if (p != edge.source && p != edge.target && is_on(edge, p)) inside[i].push_back(p);
            });
    Ring2 result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        result.push_back(ring[i]);
        std::vector<Point2>& along = inside[i];
        std::sort(along.begin(), along.end());
        along.erase(std::unique(along.begin(), along.end()), along.end());
        if (ring[(i + 1) % ring.size()] < ring[i]) std::reverse(along.begin(), along.end());
        result.insert(result.end(), along.begin(), along.end());
    }
    return result;
}

/// Cuts a ring that touches itself into rings that do not. Each point is inside of an odd number of them
/// when it is inside of the ring.
std::vector<Ring2> simple_loops(const Ring2& ring) {
    std::vector<Ring2> loops;
    Ring2 open;
    std::map<Point2, std::size_t> at;  // where in `open` a point is
    for (const Point2& p : with_touching_vertices(ring)) {
        const auto [found, is_new] = at.try_emplace(p, open.size());
        if (!is_new) {
            const auto first = open.begin() + static_cast<std::ptrdiff_t>(found->second);
            loops.emplace_back(first, open.end());
            for (auto it = first + 1; it != open.end(); ++it) at.erase(*it);
            open.erase(first + 1, open.end());
            continue;
        }
        open.push_back(p);
    }
    loops.push_back(std::move(open));
    return loops;
}

/// A valid polygon as a set. CGAL wants rings that do not touch themselves.
CgalSet to_set(const Polygon2& polygon) {
    std::vector<std::vector<Ring2>> rings{simple_loops(polygon.outer)};
    for (const Ring2& hole : polygon.holes) rings.push_back(simple_loops(hole));
    CgalSet set;
    if (std::all_of(rings.begin(), rings.end(), [](const auto& r) { return r.size() == 1; })) {
        set.insert(to_cgal(polygon));
        return set;
    }
    std::vector<CgalRing> loops;
    for (const auto& ring : rings)
        for (const Ring2& loop : ring) loops.push_back(to_cgal(loop, true));
    set.symmetric_difference(loops.begin(), loops.end());
    return set;
}

/// The nearest double; counts in `inexact` when that is not the number itself.
double nearest(const Kernel::FT& x, bool& inexact) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): what GMP prints is a fraction
    const Rational exact = Rational::parse(CGAL::exact(x).get_str()).value();
    const double value = exact.approx_double();
    inexact = inexact || Rational(value) != exact;
    return value;
}

Ring2 from_cgal(const CgalRing& ring, std::size_t& rounded) {
    Ring2 result;
    for (const Kernel::Point_2& p : ring.vertices()) {
        bool inexact = false;
        result.push_back({nearest(p.x(), inexact), nearest(p.y(), inexact)});
        rounded += inexact ? 1 : 0;
    }
    return result;
}

BooleanResult from_cgal(const CgalSet& set) {
    std::vector<CgalPolygon> polygons;
    set.polygons_with_holes(std::back_inserter(polygons));
    BooleanResult result;
    for (const CgalPolygon& polygon : polygons) {
        Polygon2& p = result.polygons.emplace_back();
        p.outer = from_cgal(polygon.outer_boundary(), result.rounded_vertices);
        for (const CgalRing& hole : polygon.holes())
            p.holes.push_back(from_cgal(hole, result.rounded_vertices));
    }
    return result;
}

}  // namespace

BooleanResult unite(const std::vector<Polygon2>& polygons) {
    std::vector<CgalPolygon> parts;
    for (const Polygon2& polygon : polygons)
        to_set(polygon).polygons_with_holes(std::back_inserter(parts));
    CgalSet set;
    set.join(parts.begin(), parts.end());
    return from_cgal(set);
}

BooleanResult clip(const Polygon2& polygon, const Ring2& ring) {
    CgalSet set = to_set(polygon);
    set.intersection(to_set({ring, {}}));
    return from_cgal(set);
}

}  // namespace sightline::detail
