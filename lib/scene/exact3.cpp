// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/exact3.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/error_bounded.hpp"
#include "geom/polynomial_sign.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

namespace {

/// A double that knows whether it is the exact result of its operations. Most coordinates that people write have few
/// digits, and then doubles decide zeros at once.
class ExactDouble {
public:
    explicit ExactDouble(double value) : value_(value) {}

    [[nodiscard]] friend ExactDouble operator+(const ExactDouble& a, const ExactDouble& b) {
        const double sum = a.value_ + b.value_;
        const double other = sum - a.value_;
        const double error = (a.value_ - (sum - other)) + (b.value_ - other);
        return {sum, a.is_exact_ && b.is_exact_ && error == 0};
    }
    [[nodiscard]] friend ExactDouble operator-(const ExactDouble& a, const ExactDouble& b) {
        return a + ExactDouble(-b.value_, b.is_exact_);
    }
    [[nodiscard]] friend ExactDouble operator*(const ExactDouble& a, const ExactDouble& b) {
        const double product = a.value_ * b.value_;
        // Far from underflow, the rounding error is itself a double.
        const bool safe = std::abs(product) > 0x1p-900 || a.value_ == 0 || b.value_ == 0;
        return {product,
                a.is_exact_ && b.is_exact_ && safe && std::fma(a.value_, b.value_, -product) == 0};
    }
    [[nodiscard]] std::optional<Sign> sign() const {
        if (!is_exact_) return std::nullopt;  // infinite and undefined values are not exact
        return sign_of(value_);
    }

private:
    ExactDouble(double value, bool is_exact) : value_(value), is_exact_(is_exact) {}
    double value_;
    bool is_exact_ = true;
};

template <typename Number, typename Point>
Number orientation3_polynomial(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Number bx = Number(b.x) - Number(a.x);
    const Number by = Number(b.y) - Number(a.y);
    const Number bz = Number(b.z) - Number(a.z);
    const Number cx = Number(c.x) - Number(a.x);
    const Number cy = Number(c.y) - Number(a.y);
    const Number cz = Number(c.z) - Number(a.z);
    const Number dx = Number(d.x) - Number(a.x);
    const Number dy = Number(d.y) - Number(a.y);
    const Number dz = Number(d.z) - Number(a.z);
    return bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
}

template <typename Point>
bool collinear(const Point& a, const Point& b, const Point& c) {
    for (int axis = 0; axis < 3; ++axis)
        if (orientation(drop(a, axis), drop(b, axis), drop(c, axis)) != Sign::zero) return false;
    return true;
}

}  // namespace

Sign orientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    // Neighbours on a surface share points, and no filter sees that.
    if (a == b || a == c || a == d || b == c || b == d || c == d) return Sign::zero;
    if (const auto sign = orientation3_polynomial<ErrorBounded>(a, b, c, d).sign()) return *sign;
    if (const auto sign = orientation3_polynomial<ExactDouble>(a, b, c, d).sign()) return *sign;
    return polynomial_sign(Arithmetic::filtered,
                           [&]<typename Number>() -> Number {
                               return orientation3_polynomial<Number>(a, b, c, d);
                           })
        .sign;
}

Sign orientation3(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                  const RationalPoint3& d) {
    return orientation3_polynomial<Rational>(a, b, c, d).sign();
}

bool are_collinear(const Point3& a, const Point3& b, const Point3& c) { return collinear(a, b, c); }
bool are_collinear(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) {
    return collinear(a, b, c);
}

// Along a line coordinates are monotone, so that their order is the lexicographic order of points.
bool is_between(const Point3& a, const Point3& b, const Point3& c) {
    return ((a < b && b < c) || (c < b && b < a)) && are_collinear(a, b, c);
}
bool is_between(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c) {
    return ((a < b && b < c) || (c < b && b < a)) && are_collinear(a, b, c);
}

Plane3 Plane3::through(const Point3& a, const Point3& b, const Point3& c) {
    Plane3 plane{{a, b, c}};
    for (plane.axis = 2; plane.axis >= 0; --plane.axis) {
        const int axis = plane.axis;
        plane.facing = orientation(drop(a, axis), drop(b, axis), drop(c, axis));
        if (plane.facing != Sign::zero) break;
    }
    return plane;
}

Sign Plane3::turn(const Point3& a, const Point3& b, const Point3& c) const {
    return facing * orientation(drop(a, axis), drop(b, axis), drop(c, axis));
}

}  // namespace sightline::detail
