// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/edge_events.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {
namespace {

using Kind = EdgeEvent::Kind;

// a / (a - b), for values of opposite signs, one of which may vanish.
Near ratio(const Near& a, const Near& b) {
    const double whole = a.value - b.value;
    const double error = a.error + b.error;
    const double left = std::abs(whole) - error;
    if (!(left > 0)) return {0.5, 1};
    const double t = a.value / whole;
    // Quotients first: products of small numbers would underflow.
    const double bound = (std::abs(b.value) + b.error) / std::abs(whole) * (a.error / left) +
                         (std::abs(a.value) + a.error) / std::abs(whole) * (b.error / left) +
                         0x1p-50;
    if (!(bound < 1)) return {0.5, 1};
    return {t, 2 * bound};
}

}  // namespace

EdgeEvent EdgeOrder::crossing(std::uint32_t a, std::uint32_t b, std::uint32_t edge) const {
    const SightPlane plane = image_.plane(a, b);
    return {.kind = Kind::edge,
            .a = std::min(a, b),
            .b = std::max(a, b),
            .edge = edge,
            .t = ratio(image_.near_side(plane, u_), image_.near_side(plane, w_))};
}

EdgeEvent EdgeOrder::vertex(std::uint32_t a) const {
    if (a == u_) return {.kind = Kind::vertex, .a = a, .t = {0, 0}};
    if (a == w_) return {.kind = Kind::vertex, .a = a, .t = {1, 0}};
    return {.kind = Kind::vertex,
            .a = a,
            .t = ratio(image_.near_minor(a, u_, axis_), image_.near_minor(a, w_, axis_))};
}

EdgeEvent EdgeOrder::plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return {.kind = Kind::plane,
            .a = a,
            .b = b,
            .c = c,
            .t = ratio(image_.near_height(a, b, c, u_), image_.near_height(a, b, c, w_))};
}

EdgeEvent EdgeOrder::fraction(const Rational& t) {
    EdgeEvent x;
    x.kind = Kind::fraction;
    x.t = {t.approx_double(), 0x1p-50};
    x.value = std::make_shared<const Rational>(t);
    return x;
}

Rational EdgeOrder::parameter(const EdgeEvent& x) {
    // Equal only where uncertain signs have led.
    const auto of = [](const Rational& a, const Rational& b) {
        return a == b ? Rational(1) / 2 : a / (a - b);
    };
    switch (x.kind) {
        case Kind::source:
            return 0;
        case Kind::target:
            return 1;
        case Kind::edge:
            return of(image_.exact_side(x.a, x.b, u_), image_.exact_side(x.a, x.b, w_));
        case Kind::vertex:
            return of(image_.exact_minor(x.a, u_, axis_), image_.exact_minor(x.a, w_, axis_));
        case Kind::plane:
            return of(image_.exact_height(x.a, x.b, x.c, u_),
                      image_.exact_height(x.a, x.b, x.c, w_));
        case Kind::fraction:
            break;
    }
    return *x.value;
}

const Rational& EdgeOrder::exact(EdgeEvent& x) {
    if (x.exact == no_edge) {
        Rational t = parameter(x);
        x.exact = static_cast<std::uint32_t>(table_.size());
        x.t = {t.approx_double(), t.is_integer() ? 0 : 0x1p-50};
        table_.push_back(std::move(t));
    }
    return table_[x.exact];
}

// Places made by one line, by points at one place, or by a line and a point on it.
bool EdgeOrder::certainly_equal(const EdgeEvent& x, const EdgeEvent& y) const {
    if (x.kind == Kind::vertex && y.kind == Kind::edge) return certainly_equal(y, x);
    if (x.kind == Kind::vertex && y.kind == Kind::vertex) return image_.certainly_equal(x.a, y.a);
    if (x.kind == Kind::edge && y.kind == Kind::vertex) {
        return image_.certainly_collinear(x.a, x.b, y.a);
    }
    if (x.kind == Kind::edge && y.kind == Kind::edge) {
        return image_.certainly_collinear(x.a, x.b, y.a) &&
               image_.certainly_collinear(x.a, x.b, y.b);
    }
    return false;
}

Sign EdgeOrder::compare(EdgeEvent& x, EdgeEvent& y) {
    constexpr auto predicate = Predicate::constructed_order3;
    if (x.kind == y.kind && x.a == y.a && x.b == y.b && x.c == y.c && x.kind != Kind::fraction) {
        return Sign::zero;
    }
    const double difference = x.t.value - y.t.value;
    const bool rounded = image_.arithmetic() == Arithmetic::double_;
    if (rounded || std::abs(difference) > x.t.error + y.t.error ||
        (x.t.error == 0 && y.t.error == 0)) {
        image_.count(predicate, Tier::filter);
        return sign_of(difference);
    }
    if (certainly_equal(x, y)) {
        image_.count(predicate, Tier::filter);
        return Sign::zero;
    }
    if (image_.arithmetic() == Arithmetic::interval) {
        image_.count(predicate, Tier::undecided);
        return Sign::zero;
    }
    image_.count(predicate, Tier::exact);
    const Rational at_x = exact(x);  // a copy: the table may grow
    const auto order = at_x <=> exact(y);
    return order < 0 ? Sign::negative : order > 0 ? Sign::positive : Sign::zero;
}

}  // namespace sightline::detail
