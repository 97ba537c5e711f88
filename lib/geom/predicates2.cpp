// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/predicates2.hpp"

#include <algorithm>
#include <ostream>

#include "geom/kernel2.hpp"

namespace sightline {

namespace {

using Filtered = detail::Kernel2<Arithmetic::filtered>;
using detail::EnclosedPoint2;

detail::RunTimeKernel2 kernel_of(const Predicates2& predicates) {
    return {predicates.arithmetic(), predicates.tally()};
}

// A rational point that is a double point is cheaper as one.
template <typename Function>
auto with_cheapest(const RationalPoint2& p, Function&& function) {
    const EnclosedPoint2 enclosed(p);
    return enclosed.is_input() ? function(enclosed.input()) : function(enclosed);
}

}  // namespace

namespace detail {

CertifiedSign orientation_after_filter(const Point2& a, const Point2& b, const Point2& c) {
    return sign_after_filter(orientation_polynomial<double>(a, b, c));
}

SegmentCrossing collinear_crossing(const Segment2& s, const Segment2& t) {
    const auto [s_low, s_high] = std::minmax(s.source, s.target);
    const auto [t_low, t_high] = std::minmax(t.source, t.target);
    const Point2& low = std::max(s_low, t_low);
    const Point2& high = std::min(s_high, t_high);
    if (high < low) return SegmentCrossing::none;
    if (low < high) return SegmentCrossing::overlap;
    const bool ends_s = low == s_low || low == s_high;
    const bool ends_t = low == t_low || low == t_high;
    if (ends_s && ends_t) return SegmentCrossing::end_to_end;
    return ends_s ? SegmentCrossing::first_ends_inside_second
                  : SegmentCrossing::second_ends_inside_first;
}

CertifiedSign orientation_to(Arithmetic arithmetic, const Point2& a, const Point2& b,
                             const RationalPoint2& c) {
    const EnclosedPoint2 point(c);
    return polynomial_sign(arithmetic, [&]<typename Number>() -> Number {
        return homogeneous_orientation<Number>(a, b, point);
    });
}

}  // namespace detail

Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
    return detail::orientation(a, b, c).sign;
}

Sign orientation(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
    return detail::orientation_polynomial<Rational>(a, b, c).value().sign();
}

Sign orientation(const Point2& a, const Point2& b, const RationalPoint2& c) {
    return Predicates2{}.orientation(a, b, c);
}

Sign orientation(const Point2& a, const Point2& b, const ImplicitPoint2& c) {
    return detail::orientation_in(Filtered{}, a, b, c);
}

Sign orientation(const Point2& a, const ImplicitPoint2& b, const ImplicitPoint2& c) {
    return detail::orientation_in(Filtered{}, a, b, c);
}

Sign orientation(const ImplicitPoint2& a, const ImplicitPoint2& b, const ImplicitPoint2& c) {
    return detail::orientation_in(Filtered{}, a, b, c);
}

Sign order_along(const Point2& a, const Point2& b, const Point2& p, const Point2& q) {
    return detail::order_along_in(Filtered{}, a, b, p, q);
}

Sign order_along(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& p,
                 const RationalPoint2& q) {
    return detail::dot_polynomial<Rational>(a, b, q, p).value().sign();
}

Sign order_along(const Point2& a, const Point2& b, const Point2& p, const ImplicitPoint2& q) {
    return detail::order_along_in(Filtered{}, a, b, p, q);
}

Sign order_along(const Point2& a, const Point2& b, const ImplicitPoint2& p,
                 const ImplicitPoint2& q) {
    return detail::order_along_in(Filtered{}, a, b, p, q);
}

Sign order_of_directions(const Point2& center, const Point2& reference, const Point2& p,
                         const Point2& q) {
    return detail::order_of_directions_in(Filtered{}, center, reference, p, q);
}

Sign order_of_directions(const RationalPoint2& center, const Point2& reference, const Point2& p,
                         const Point2& q) {
    return Predicates2{}.order_of_directions(center, reference, p, q);
}

ConePosition cone_position(const Point2& apex, const Point2& first, const Point2& second,
                           const Point2& p) {
    return detail::cone_position_in(Filtered{}, apex, first, second, p);
}

ConePosition cone_position(const RationalPoint2& apex, const Point2& first, const Point2& second,
                           const Point2& p) {
    return Predicates2{}.cone_position(apex, first, second, p);
}

bool is_in_cone(const Point2& apex, const Point2& first, const Point2& second, const Point2& p) {
    return cone_position(apex, first, second, p) == ConePosition::inside;
}

SegmentCrossing crossing(const Segment2& s, const Segment2& t) {
    return detail::crossing_in(Filtered{}, s, t);
}

bool is_on(const Segment2& s, const Point2& p) { return detail::is_on_in(Filtered{}, s, p); }

Sign compare_xy(const ImplicitPoint2& p, const ImplicitPoint2& q) {
    return detail::compare_xy_in(Filtered{}, p, q);
}

Sign compare_xy(const ImplicitPoint2& p, const Point2& q) {
    return detail::compare_xy_in(Filtered{}, p, q);
}

Sign Predicates2::orientation(const Point2& a, const Point2& b, const Point2& c) const {
    return detail::orientation_in(kernel_of(*this), a, b, c);
}

Sign Predicates2::orientation(const Point2& a, const Point2& b, const RationalPoint2& c) const {
    return with_cheapest(c, [&](const auto& point) {
        return detail::orientation_in(kernel_of(*this), a, b, point);
    });
}

Sign Predicates2::orientation(const Point2& a, const Point2& b, const ImplicitPoint2& c) const {
    return detail::orientation_in(kernel_of(*this), a, b, c);
}

Sign Predicates2::orientation(const Point2& a, const ImplicitPoint2& b,
                              const ImplicitPoint2& c) const {
    return detail::orientation_in(kernel_of(*this), a, b, c);
}

Sign Predicates2::orientation(const ImplicitPoint2& a, const ImplicitPoint2& b,
                              const ImplicitPoint2& c) const {
    return detail::orientation_in(kernel_of(*this), a, b, c);
}

Sign Predicates2::order_along(const Point2& a, const Point2& b, const Point2& p,
                              const Point2& q) const {
    return detail::order_along_in(kernel_of(*this), a, b, p, q);
}

Sign Predicates2::order_along(const Point2& a, const Point2& b, const Point2& p,
                              const ImplicitPoint2& q) const {
    return detail::order_along_in(kernel_of(*this), a, b, p, q);
}

Sign Predicates2::order_along(const Point2& a, const Point2& b, const ImplicitPoint2& p,
                              const ImplicitPoint2& q) const {
    return detail::order_along_in(kernel_of(*this), a, b, p, q);
}

Sign Predicates2::order_of_directions(const Point2& center, const Point2& reference,
                                      const Point2& p, const Point2& q) const {
    return detail::order_of_directions_in(kernel_of(*this), center, reference, p, q);
}

Sign Predicates2::order_of_directions(const RationalPoint2& center, const Point2& reference,
                                      const Point2& p, const Point2& q) const {
    return with_cheapest(center, [&](const auto& point) {
        return detail::order_of_directions_in(kernel_of(*this), point, reference, p, q);
    });
}

ConePosition Predicates2::cone_position(const Point2& apex, const Point2& first,
                                        const Point2& second, const Point2& p) const {
    return detail::cone_position_in(kernel_of(*this), apex, first, second, p);
}

ConePosition Predicates2::cone_position(const RationalPoint2& apex, const Point2& first,
                                        const Point2& second, const Point2& p) const {
    return with_cheapest(apex, [&](const auto& point) {
        return detail::cone_position_in(kernel_of(*this), point, first, second, p);
    });
}

SegmentCrossing Predicates2::crossing(const Segment2& s, const Segment2& t) const {
    return detail::crossing_in(kernel_of(*this), s, t);
}

bool Predicates2::is_on(const Segment2& s, const Point2& p) const {
    return detail::is_on_in(kernel_of(*this), s, p);
}

Sign Predicates2::compare_xy(const ImplicitPoint2& p, const ImplicitPoint2& q) const {
    return detail::compare_xy_in(kernel_of(*this), p, q);
}

Sign Predicates2::compare_xy(const ImplicitPoint2& p, const Point2& q) const {
    return detail::compare_xy_in(kernel_of(*this), p, q);
}

const char* name_of(ConePosition position) noexcept {
    switch (position) {
        case ConePosition::outside:
            return "outside";
        case ConePosition::on_first:
            return "on_first";
        case ConePosition::inside:
            return "inside";
        case ConePosition::on_second:
            return "on_second";
        case ConePosition::at_apex:
            return "at_apex";
    }
    return "unknown";
}

const char* name_of(SegmentCrossing crossing) noexcept {
    switch (crossing) {
        case SegmentCrossing::none:
            return "none";
        case SegmentCrossing::end_to_end:
            return "end_to_end";
        case SegmentCrossing::first_ends_inside_second:
            return "first_ends_inside_second";
        case SegmentCrossing::second_ends_inside_first:
            return "second_ends_inside_first";
        case SegmentCrossing::proper:
            return "proper";
        case SegmentCrossing::overlap:
            return "overlap";
    }
    return "unknown";
}

std::ostream& operator<<(std::ostream& out, ConePosition position) {
    return out << name_of(position);
}

std::ostream& operator<<(std::ostream& out, SegmentCrossing crossing) {
    return out << name_of(crossing);
}

}  // namespace sightline
