// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/triangulation.hpp"

#include <cmath>

#include "geom/orientation_tiers.hpp"
#include "planar/triangulation_builder.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

Triangulation::Triangulation(const Scene2& scene, std::span<const Point2> within,
                             unsigned threads) {
    TriangulationBuilder(*this, scene, within).build(threads);
}

bool Triangulation::is_on_exact_grid(const Point2& p) const noexcept {
    return exact_grid_ && is_in_frame(p) && std::fmod(p.x, grid_step_) == 0 &&
           std::fmod(p.y, grid_step_) == 0;
}

RationalPoint2 Triangulation::exact_position(Place p) const {
    return p < first_constructed_ ? to_rational(position_[p])
                                  : constructed_[p - first_constructed_];
}

Sign Triangulation::orientation(Place a, Place b, Place c) const {
    if (has_constructed() &&
        (a >= first_constructed_ || b >= first_constructed_ || c >= first_constructed_))
        return sightline::orientation(exact_position(a), exact_position(b), exact_position(c));
    const Point2& p = position_[a];
    const Point2& q = position_[b];
    const Point2& r = position_[c];
    const double det = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (det > orientation_bound_) return Sign::positive;
    if (det < -orientation_bound_) return Sign::negative;
    if (exact_grid_) return Sign::zero;
    return sightline::orientation(p, q, r);
}

Sign Triangulation::compare(Place a, Place b) const {
    const auto order = [](const auto& p, const auto& q) {
        return p < q ? Sign::negative : q < p ? Sign::positive : Sign::zero;
    };
    if (has_constructed() && (a >= first_constructed_ || b >= first_constructed_))
        return order(exact_position(a), exact_position(b));
    return order(position_[a], position_[b]);
}

}  // namespace sightline::detail
