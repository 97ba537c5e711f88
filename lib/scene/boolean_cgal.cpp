// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <iterator>

#include "scene/boolean.hpp"

namespace sightline::detail {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;
using CgalSet = CGAL::Polygon_set_2<Kernel>;

CgalRing to_cgal(const Ring2& ring, bool counter_clockwise) {
    CgalRing result;
    for (const Point2& p : ring) result.push_back(Kernel::Point_2(p.x, p.y));
    // The area's sign: CGAL's own orientation wants rings that do not touch themselves.
    if ((result.area() > 0) != counter_clockwise) result.reverse_orientation();
    return result;
}

CgalPolygon to_cgal(const Polygon2& polygon) {
    CgalPolygon result(to_cgal(polygon.outer, true));
    for (const Ring2& hole : polygon.holes) result.add_hole(to_cgal(hole, false));
    return result;
}

/// The nearest double; counts in `inexact` when that is not the number itself.
double nearest(const Kernel::FT& x, bool& inexact) {
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
    std::vector<CgalPolygon> given;
    for (const Polygon2& polygon : polygons) given.push_back(to_cgal(polygon));
    CgalSet set;
    set.join(given.begin(), given.end());
    return from_cgal(set);
}

BooleanResult clip(const Polygon2& polygon, const Ring2& ring) {
    CgalSet set;
    set.insert(to_cgal(polygon));
    set.intersection(to_cgal(ring, true));
    return from_cgal(set);
}

}  // namespace sightline::detail
