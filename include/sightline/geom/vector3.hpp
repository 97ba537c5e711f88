// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <ostream>

#include "sightline/arith/rational.hpp"
#include "sightline/arith/surd.hpp"
#include "sightline/geom/point.hpp"

namespace sightline {

/// A displacement in space, over any number type. Ordered lexicographically.
template <typename Number>
struct BasicVector3 {
    Number x;
    Number y;
    Number z;

    [[nodiscard]] bool is_zero() const {
        return sign_of(x) == Sign::zero && sign_of(y) == Sign::zero && sign_of(z) == Sign::zero;
    }
    friend bool operator==(const BasicVector3&, const BasicVector3&) = default;
    friend auto operator<=>(const BasicVector3&, const BasicVector3&) = default;
    [[nodiscard]] friend BasicVector3 operator-(const BasicVector3& v) {
        return {-v.x, -v.y, -v.z};
    }
    [[nodiscard]] friend BasicVector3 operator+(const BasicVector3& v, const BasicVector3& w) {
        return {v.x + w.x, v.y + w.y, v.z + w.z};
    }
    [[nodiscard]] friend BasicVector3 operator-(const BasicVector3& v, const BasicVector3& w) {
        return {v.x - w.x, v.y - w.y, v.z - w.z};
    }
    [[nodiscard]] friend BasicVector3 operator*(const Number& k, const BasicVector3& v) {
        return {k * v.x, k * v.y, k * v.z};
    }
    friend std::ostream& operator<<(std::ostream& out, const BasicVector3& v) {
        return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    }
};

using Vector3 = BasicVector3<Rational>;
/// A displacement in a quadratic field.
using SurdVector3 = BasicVector3<Surd>;

template <typename Number>
[[nodiscard]] Number dot(const BasicVector3<Number>& v, const BasicVector3<Number>& w) {
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

/// The vector product.
template <typename Number>
[[nodiscard]] BasicVector3<Number> cross(const BasicVector3<Number>& v,
                                         const BasicVector3<Number>& w) {
    return {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

/// The triple product u·(v × w): positive when u, v, w are right-handed.
template <typename Number>
[[nodiscard]] Number determinant(const BasicVector3<Number>& u, const BasicVector3<Number>& v,
                                 const BasicVector3<Number>& w) {
    return dot(u, cross(v, w));
}

[[nodiscard]] inline Vector3 operator-(const RationalPoint3& to, const RationalPoint3& from) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

[[nodiscard]] inline RationalPoint3 operator+(const RationalPoint3& p, const Vector3& v) {
    return {p.x + v.x, p.y + v.y, p.z + v.z};
}

/// From the origin to p.
[[nodiscard]] inline Vector3 vector_to(const RationalPoint3& p) { return {p.x, p.y, p.z}; }

/// The same numbers as elements of a quadratic field.
[[nodiscard]] inline SurdVector3 to_surd(const Vector3& v) { return {v.x, v.y, v.z}; }

}  // namespace sightline
