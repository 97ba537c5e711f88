// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/visibility_polygon_cgal.hpp"

#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>

#include <sstream>

#include "sightline/reference/visibility_polygon.hpp"

namespace sightline::reference {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
using Expansion = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;

Kernel::FT to_cgal(const Rational& x) {
    return Kernel::FT(Kernel::Exact_kernel::FT(mpq_class(x.mpq())));
}

Kernel::Point_2 to_cgal(const RationalPoint2& p) { return {to_cgal(p.x), to_cgal(p.y)}; }

Rational from_cgal(const Kernel::FT& x) {
    std::ostringstream text;
    text << CGAL::exact(x);
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): what GMP prints is a fraction
    return *Rational::parse(text.str());
}

}  // namespace

std::vector<ViewPoint> cgal_visibility_ring(const Scene2& scene, const RationalPoint2& q) {
    std::vector<Kernel::Segment_2> segments;
    for (const Edge2& e : scene.edges()) {
        segments.emplace_back(to_cgal(to_rational(scene[e.source])),
                              to_cgal(to_rational(scene[e.target])));
    }
    Arrangement arrangement;
    CGAL::insert_non_intersecting_curves(arrangement, segments.begin(), segments.end());
    const CGAL::Arr_naive_point_location<Arrangement> location(arrangement);
    const auto found = location.locate(to_cgal(q));
    const auto* face = boost::get<Arrangement::Face_const_handle>(&found);
    SIGHTLINE_EXPECT(face != nullptr && !(*face)->is_unbounded());
    Arrangement seen;
    const auto polygon = Expansion(arrangement).compute_visibility(to_cgal(q), *face, seen);
    std::vector<ViewPoint> ring;
    auto edge = polygon->outer_ccb();
    do {
        const auto& p = edge->target()->point();
        ring.push_back({{from_cgal(p.x()), from_cgal(p.y())}, false});
    } while (++edge != polygon->outer_ccb());
    return canonical_ring(std::move(ring));
}

}  // namespace sightline::reference
