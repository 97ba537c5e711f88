// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/direction2.hpp"

#include <ostream>
#include <stdexcept>

namespace sightline {

namespace {

// The slope in lowest terms is y : x without their common factor; the signs are put back.
Vector2 coprime(const Vector2& v) {
    if (v.is_zero()) throw std::domain_error("Direction2: the zero vector has no direction");
    const Rational x_sign(static_cast<int>(v.x.sign()));
    const Rational y_sign(static_cast<int>(v.y.sign()));
    if (v.x.sign() == Sign::zero || v.y.sign() == Sign::zero) return {x_sign, y_sign};
    const Rational slope = abs(v.y / v.x);
    return {x_sign * denominator_of(slope), y_sign * numerator_of(slope)};
}

// 0 on [0, π), 1 on [π, 2π).
int half_turn(const Direction2& d) {
    const Sign y = d.y().sign();
    if (y != Sign::zero) return y == Sign::positive ? 0 : 1;
    return d.x().sign() == Sign::positive ? 0 : 1;
}

}  // namespace

Direction2::Direction2(const Vector2& v) : v_(coprime(v)) {}

Direction2::Direction2(const Point2& from, const Point2& to)
    : Direction2(to_rational(to) - to_rational(from)) {}

Direction2::Direction2(const RationalPoint2& from, const RationalPoint2& to)
    : Direction2(to - from) {}

std::strong_ordering operator<=>(const Direction2& a, const Direction2& b) {
    if (const auto order = half_turn(a) <=> half_turn(b); order != 0) return order;
    return static_cast<int>(side_of(b, a)) <=> 0;
}

std::ostream& operator<<(std::ostream& out, const Direction2& d) {
    return out << '<' << d.x() << ", " << d.y() << '>';
}

Sign side_of(const Direction2& d, const Direction2& e) {
    return cross(d.vector(), e.vector()).sign();
}

}  // namespace sightline
