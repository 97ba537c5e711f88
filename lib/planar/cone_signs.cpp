// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/cone_signs.hpp"

#include <limits>

#include "geom/orientation_tiers.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

// Which side of the ray from v in an axis direction q lies on.
template <typename Point>
Sign side_of_axis(Limit::Kind kind, const Point& v, const Point& q) {
    const auto order = [](const auto& a, const auto& b) {
        return a < b ? Sign::positive : b < a ? Sign::negative : Sign::zero;
    };
    switch (kind) {
        case Limit::Kind::up:
            return order(q.x, v.x);
        case Limit::Kind::down:
            return order(v.x, q.x);
        case Limit::Kind::right:
            return order(v.y, q.y);
        default:
            return order(q.y, v.y);
    }
}

}  // namespace

ConeSigns::ConeSigns(const Triangulation& t, Arithmetic arithmetic)
    : t_(t), arithmetic_(arithmetic) {}

double ConeSigns::bound(const Viewpoint& from) const {
    if (arithmetic_ == Arithmetic::double_) return 0;
    // The policies `exact` and `interval` decide nothing by the filter; constructed places have no
    // double coordinates that it could use.
    if (arithmetic_ != Arithmetic::filtered || t_.has_constructed())
        return std::numeric_limits<double>::infinity();
    if (from.place != no_index || (from.exact == nullptr && t_.is_on_exact_grid(from.position)))
        return t_.orientation_bound();
    return t_.rounded_point_bound();
}

RationalPoint2 ConeSigns::exact_position(const Viewpoint& from) const {
    if (from.exact != nullptr) return *from.exact;
    return from.place == no_index ? to_rational(from.position) : t_.exact_position(from.place);
}

CertifiedSign ConeSigns::by_tier(const Viewpoint& from, const Point2& b, const Point2& c) const {
    const Point2& a = from.position;
    if (arithmetic_ == Arithmetic::filtered && from.exact == nullptr && t_.is_on_exact_grid() &&
        (from.place != no_index || t_.is_on_exact_grid(a))) {
        const double det = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return {sign_of(det), Tier::filter};
    }
    return with_arithmetic(arithmetic_,
                           [&](auto policy) { return orientation_by<policy.value>(a, b, c); });
}

CertifiedSign ConeSigns::decide(const Viewpoint& from, const Limit& limit, Place p) const {
    const auto constructed = [&](Place q) { return q != no_index && q >= t_.first_constructed(); };
    const bool exact_only =
        arithmetic_ != Arithmetic::double_ && (from.exact != nullptr || constructed(from.place) ||
                                               constructed(limit.place) || constructed(p));
    if (limit.kind != Limit::Kind::towards && limit.kind != Limit::Kind::away_from) {
        if (exact_only)
            return {side_of_axis(limit.kind, exact_position(from), t_.exact_position(p)),
                    Tier::exact};
        return {side_of_axis(limit.kind, from.position, t_.position(p)), Tier::filter};
    }
    CertifiedSign s;
    if (limit.place == p)
        s = {Sign::zero, Tier::filter};
    else if (exact_only && from.exact != nullptr && !constructed(limit.place) && !constructed(p))
        s = orientation_to(arithmetic_, t_.position(limit.place), t_.position(p), *from.exact);
    else if (exact_only)
        s = {sightline::orientation(exact_position(from), t_.exact_position(limit.place),
                                    t_.exact_position(p)),
             Tier::exact};
    else
        s = by_tier(from, t_.position(limit.place), t_.position(p));
    if (limit.kind == Limit::Kind::away_from) s.sign = -s.sign;
    return s;
}

Sign ConeSigns::side(const Viewpoint& from, const Limit& limit, Place p) {
    const CertifiedSign s = decide(from, limit, p);
    Tier tier = s.decided_by;
    // What needs no arithmetic (an axis direction, the limit's own place) counts for the policy.
    if (tier == Tier::filter && arithmetic_ == Arithmetic::exact) tier = Tier::exact;
    if (tier == Tier::filter && arithmetic_ == Arithmetic::interval) tier = Tier::interval;
    late_.add(Predicate::orientation2, tier);
    return s.sign;
}

void ConeSigns::add_to(Tally& tally) const noexcept {
    const TierCounts& late = late_[Predicate::orientation2];
    TierCounts& counts = tally[Predicate::orientation2];
    counts += late;
    counts.calls += calls_ - late.calls;
    counts.filter += calls_ - late.calls;
}

}  // namespace sightline::detail
