// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/place.hpp"

#include <cmath>

#include "sightline/scene/result.hpp"

namespace sightline::reference {
namespace {

std::strong_ordering compare_doubles(double a, double b) {
    return a < b   ? std::strong_ordering::less
           : b < a ? std::strong_ordering::greater
                   : std::strong_ordering::equal;
}

bool is_exactly(const Rational& x, double d) { return std::isfinite(d) && Rational(d) == x; }

// Headings are split into two half-turns so that orientation orders each of them: those that go up
// in lexicographic order come first.
bool is_second_half(const Place& x, const Heading& h) { return (h.tip < x) != h.reversed; }

}  // namespace

Place::Place(const RationalPoint2& p) : double_(approx_point(p)) {
    if (!is_exactly(p.x, double_.x) || !is_exactly(p.y, double_.y)) exact_ = p;
}

std::strong_ordering operator<=>(const Place& a, const Place& b) {
    if (a.is_double() && b.is_double()) {
        const auto by_x = compare_doubles(a.double_.x, b.double_.x);
        return by_x != 0 ? by_x : compare_doubles(a.double_.y, b.double_.y);
    }
    return a.rational() <=> b.rational();
}

Sign side(const Place& a, const Place& b, const Place& c) {
    if (a.is_double() && b.is_double() && c.is_double()) {
        return orientation(a.as_double(), b.as_double(), c.as_double());
    }
    const RationalPoint2 p = a.rational();
    const RationalPoint2 q = b.rational();
    const RationalPoint2 r = c.rational();
    return sign_of((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}

std::strong_ordering compare_y(const Place& a, const Place& b) {
    if (a.is_double() && b.is_double()) return compare_doubles(a.as_double().y, b.as_double().y);
    return a.rational().y <=> b.rational().y;
}

Place crossing(const Place& a, const Place& b, const Place& c, const Place& d) {
    const RationalPoint2 p = a.rational();
    const RationalPoint2 q = b.rational();
    const RationalPoint2 r = c.rational();
    const RationalPoint2 s = d.rational();
    const Rational ux = q.x - p.x;
    const Rational uy = q.y - p.y;
    const Rational vx = s.x - r.x;
    const Rational vy = s.y - r.y;
    const Rational t = ((r.x - p.x) * vy - (r.y - p.y) * vx) / (ux * vy - uy * vx);
    return RationalPoint2{p.x + t * ux, p.y + t * uy};
}

bool is_between(const Place& a, const Place& b, const Place& x) {
    return a < b ? a <= x && x <= b : b <= x && x <= a;
}

std::strong_ordering order_round(const Place& x, const Heading& a, const Heading& b) {
    SIGHTLINE_EXPECT(a.tip != x && b.tip != x);
    const bool a_second = is_second_half(x, a);
    const bool b_second = is_second_half(x, b);
    if (a_second != b_second) {
        return a_second ? std::strong_ordering::greater : std::strong_ordering::less;
    }
    Sign turn = side(x, a.tip, b.tip);
    if (a.reversed != b.reversed) turn = -turn;
    return 0 <=> static_cast<int>(turn);
}

}  // namespace sightline::reference
