// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/cone_signs.hpp"

#include <limits>

#include "geom/orientation_tiers.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

ConeSigns::ConeSigns(const Triangulation& t, Arithmetic arithmetic) : t_(t), arithmetic_(arithmetic) {
    // The policies `exact` and `interval` decide nothing by the filter; constructed places have no
    // double coordinates that a filter could use.
    const bool no_filter = arithmetic == Arithmetic::exact || arithmetic == Arithmetic::interval;
    if (no_filter || (t.has_constructed() && arithmetic == Arithmetic::filtered))
        bound_ = std::numeric_limits<double>::infinity();
    else
        bound_ = arithmetic == Arithmetic::double_ ? 0 : t.orientation_bound();
}

CertifiedSign ConeSigns::by_tier(const Point2& a, const Point2& b, const Point2& c) const {
    if (arithmetic_ == Arithmetic::filtered && t_.is_on_exact_grid()) {
        const double det = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return {sign_of(det), Tier::filter};
    }
    return with_arithmetic(arithmetic_, [&](auto policy) { return orientation_by<policy.value>(a, b, c); });
}

CertifiedSign ConeSigns::decide(const Viewpoint& from, const Limit& limit, Place p) const {
    const auto constructed = [&](Place q) { return q != no_index && q >= t_.first_constructed(); };
    const bool exact_only = t_.has_constructed() && arithmetic_ != Arithmetic::double_ &&
                            (constructed(from.place) || constructed(limit.place) || constructed(p));
    using enum Limit::Kind;
    if (limit.kind != towards && limit.kind != away_from) {
        const auto along = [&](const auto& v, const auto& q) {
            switch (limit.kind) {
                case up: return sign_of(v.x < q.x ? -1 : q.x < v.x ? 1 : 0);
                case down: return sign_of(q.x < v.x ? -1 : v.x < q.x ? 1 : 0);
                case right: return sign_of(q.y < v.y ? -1 : v.y < q.y ? 1 : 0);
                default: return sign_of(v.y < q.y ? -1 : q.y < v.y ? 1 : 0);
            }
        };
        if (exact_only)
            return {along(from.place == no_index ? to_rational(from.position) : t_.exact_position(from.place),
                          t_.exact_position(p)),
                    Tier::exact};
        return {along(from.position, t_.position(p)), Tier::filter};
    }
    CertifiedSign s;
    if (exact_only) {
        const RationalPoint2 v =
            from.place == no_index ? to_rational(from.position) : t_.exact_position(from.place);
        s = {sightline::orientation(v, t_.exact_position(limit.place), t_.exact_position(p)), Tier::exact};
    } else {
        s = by_tier(from.position, t_.position(limit.place), t_.position(p));
    }
    if (limit.kind == away_from) s.sign = -s.sign;
    return s;
}

Sign ConeSigns::side(const Viewpoint& from, const Limit& limit, Place p) {
    const CertifiedSign s = decide(from, limit, p);
    switch (s.decided_by) {
        case Tier::filter: ++late_.filter; break;
        case Tier::interval: ++late_.interval; break;
        case Tier::exact: ++late_.exact; break;
        case Tier::undecided: ++late_.undecided; break;
    }
    ++late_.calls;
    return s.sign;
}

void ConeSigns::add_to(Tally& tally) const noexcept {
    TierCounts& counts = tally[Predicate::orientation2];
    counts.calls += calls_;
    counts.filter += calls_ - (late_.calls - late_.filter);
    counts.interval += late_.interval;
    counts.exact += late_.exact;
    counts.undecided += late_.undecided;
}

}  // namespace sightline::detail
