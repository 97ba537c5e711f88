// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/point_locator.hpp"

#include <algorithm>
#include <cmath>

#include "geom/orientation_tiers.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

// Side of edges for one point, counting the calls.
class EdgeSide {
public:
    EdgeSide(const Triangulation& t, const Viewpoint& p) : t_(t), p_(p) {}

    Sign operator()(HalfEdge h) {
        const Place a = t_.origin(h);
        const Place b = t_.target(h);
        const bool constructed = t_.has_constructed() && std::max(a, b) >= t_.first_constructed();
        CertifiedSign s;
        if (!constructed && p_.exact == nullptr)
            s = detail::orientation(t_.position(a), t_.position(b), p_.position);
        else if (!constructed)
            s = orientation_to(Arithmetic::filtered, t_.position(a), t_.position(b), *p_.exact);
        else
            s = {sightline::orientation(t_.exact_position(a), t_.exact_position(b),
                                        p_.exact != nullptr ? *p_.exact : to_rational(p_.position)),
                 Tier::exact};
        counts_.add(Predicate::point_location2, s.decided_by);
        return s.sign;
    }
    [[nodiscard]] const Tally& counts() const noexcept { return counts_; }

private:
    const Triangulation& t_;
    const Viewpoint& p_;
    Tally counts_;
};

}  // namespace

PointLocator::PointLocator(const Triangulation& t) : t_(&t), low_(t.position(0)) {
    const Point2& high = t.position(2);
    side_ =
        static_cast<std::uint32_t>(std::max(1.0, std::sqrt(static_cast<double>(t.place_count()))));
    // Cell sizes, not extents: the extent of a frame is finite, its inverse may not be.
    scale_x_ = (high.x - low_.x) / side_;
    scale_y_ = (high.y - low_.y) / side_;
    start_.assign(std::size_t{side_} * side_, no_index);
    // Any triangle with a corner in the cell will do; empty cells take over a neighbour's.
    for (Place p = 0; p < t.place_count(); ++p) {
        const Point2& q = t.position(p);
        const auto cell = [&](double v, double low, double size) {
            return std::min(static_cast<std::uint32_t>((v - low) / size), side_ - 1);
        };
        start_[std::size_t{cell(q.y, low_.y, scale_y_)} * side_ + cell(q.x, low_.x, scale_x_)] =
            t.leaving(p);
    }
    HalfEdge last = t.leaving(0);
    for (std::size_t i = 0; i < start_.size(); ++i) {
        // Boustrophedon, so that the last one is a neighbour.
        const std::size_t row = i / side_;
        const std::size_t column = row % 2 == 0 ? i % side_ : side_ - 1 - i % side_;
        HalfEdge& start = start_[row * side_ + column];
        if (start == no_index) start = last;
        last = start;
    }
}

HalfEdge PointLocator::start_near(const Point2& p) const {
    const auto cell = [&](double v, double low, double size) {
        return static_cast<std::uint32_t>(std::clamp((v - low) / size, 0.0, side_ - 1.0));
    };
    return start_[std::size_t{cell(p.y, low_.y, scale_y_)} * side_ + cell(p.x, low_.x, scale_x_)];
}

namespace {

// Where in the triangle of h, boundary included, a point is: by its sides of h and of the two that follow.
Location location_in(HalfEdge h, Sign at_h, Sign at_next, Sign at_prev) {
    using enum Location::Kind;
    if (at_h == Sign::zero && at_prev == Sign::zero) return {place, h};
    if (at_h == Sign::zero && at_next == Sign::zero) return {place, next(h)};
    if (at_next == Sign::zero && at_prev == Sign::zero) return {place, prev(h)};
    if (at_h == Sign::zero) return {edge, h};
    if (at_next == Sign::zero) return {edge, next(h)};
    if (at_prev == Sign::zero) return {edge, prev(h)};
    return {triangle, h};
}

}  // namespace

// Visibility walk with the tests in pseudo-random order, which ends in any triangulation.
Location PointLocator::locate(const Viewpoint& point, Tally* tally) const {
    EdgeSide side(*t_, point);
    HalfEdge h = start_near(point.position);
    Sign at_h = side(h);
    if (at_h == Sign::negative) {
        h = t_->twin(h);
        at_h = Sign::positive;
    }
    std::uint32_t turn = 1;
    Location found;
    while (true) {
        turn = turn * 1664525U + 1013904223U;
        const bool swap = (turn & 0x80000000U) != 0;
        const HalfEdge first = swap ? prev(h) : next(h);
        const HalfEdge second = swap ? next(h) : prev(h);
        const Sign at_first = side(first);
        const Sign at_second = at_first == Sign::negative ? Sign::zero : side(second);
        if (at_first != Sign::negative && at_second != Sign::negative) {
            found = swap ? location_in(h, at_h, at_second, at_first)
                         : location_in(h, at_h, at_first, at_second);
            break;
        }
        h = t_->twin(at_first == Sign::negative ? first : second);
        at_h = Sign::positive;
    }
    if (tally != nullptr) *tally += side.counts();
    return found;
}

}  // namespace sightline::detail
