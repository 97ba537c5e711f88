// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Vectors, planes and Plücker vectors over any number type, for polynomials that are written once
/// and evaluated by the filter and with integers. Private.
///
/// A line is (d, m) with m = p × d for each of its points p; a plane is n·x = k. Everything is
/// homogeneous: results are defined up to a positive factor.

#include <gmpxx.h>

#include <array>

#include "geom/error_bounded.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline::detail {

using Real = ErrorBounded;
using Integer = mpz_class;

template <typename N>
using Vec3 = std::array<N, 3>;

template <typename N>
[[nodiscard]] Vec3<N> operator+(const Vec3<N>& a, const Vec3<N>& b) {
    return {N(a[0] + b[0]), N(a[1] + b[1]), N(a[2] + b[2])};
}
template <typename N>
[[nodiscard]] Vec3<N> operator-(const Vec3<N>& a, const Vec3<N>& b) {
    return {N(a[0] - b[0]), N(a[1] - b[1]), N(a[2] - b[2])};
}
template <typename N>
[[nodiscard]] Vec3<N> operator-(const Vec3<N>& a) {
    return {N(-a[0]), N(-a[1]), N(-a[2])};
}
template <typename N>
[[nodiscard]] Vec3<N> operator*(const N& s, const Vec3<N>& a) {
    return {N(s * a[0]), N(s * a[1]), N(s * a[2])};
}
template <typename N>
[[nodiscard]] Vec3<N> cross(const Vec3<N>& a, const Vec3<N>& b) {
    return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]),
            N(a[0] * b[1] - a[1] * b[0])};
}
template <typename N>
[[nodiscard]] N dot(const Vec3<N>& a, const Vec3<N>& b) {
    return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <>
[[nodiscard]] inline Real dot<Real>(const Vec3<Real>& a, const Vec3<Real>& b) {
    return sum_of_products(a[0], b[0], a[1], b[1], a[2], b[2]);
}

// With integers the same sums, in place: a temporary costs more than a product.
inline void add_product(Integer& sum, const Integer& a, const Integer& b) {
    mpz_addmul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
inline void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
    mpz_submul(sum.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
[[nodiscard]] inline Integer product(const Integer& a, const Integer& b) {
    Integer result;
    mpz_mul(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    return result;
}

template <>
[[nodiscard]] inline Integer dot<Integer>(const Vec3<Integer>& a, const Vec3<Integer>& b) {
    Integer sum = product(a[0], b[0]);
    add_product(sum, a[1], b[1]);
    add_product(sum, a[2], b[2]);
    return sum;
}
template <>
[[nodiscard]] inline Vec3<Integer> cross<Integer>(const Vec3<Integer>& a, const Vec3<Integer>& b) {
    Vec3<Integer> result{product(a[1], b[2]), product(a[2], b[0]), product(a[0], b[1])};
    subtract_product(result[0], a[2], b[1]);
    subtract_product(result[1], a[0], b[2]);
    subtract_product(result[2], a[1], b[0]);
    return result;
}

template <typename N>
struct PluckerOf {
    Vec3<N> d{};
    Vec3<N> m{};
};

template <typename N>
[[nodiscard]] PluckerOf<N> operator+(const PluckerOf<N>& a, const PluckerOf<N>& b) {
    return {a.d + b.d, a.m + b.m};
}
template <typename N>
[[nodiscard]] PluckerOf<N> operator*(const N& s, const PluckerOf<N>& a) {
    return {s * a.d, s * a.m};
}

/// The bilinear form a ⊙ b; zero when the lines meet or are parallel.
template <typename N>
[[nodiscard]] N side(const PluckerOf<N>& a, const PluckerOf<N>& b) {
    return N(dot(a.d, b.m) + dot(a.m, b.d));
}

template <>
[[nodiscard]] inline Integer side<Integer>(const PluckerOf<Integer>& a,
                                           const PluckerOf<Integer>& b) {
    Integer sum = product(a.d[0], b.m[0]);
    add_product(sum, a.d[1], b.m[1]);
    add_product(sum, a.d[2], b.m[2]);
    for (std::size_t i = 0; i < 3; ++i) add_product(sum, a.m[i], b.d[i]);
    return sum;
}

template <typename N>
struct PlaneOf {
    Vec3<N> n{};
    N k{};
};

template <typename N>
[[nodiscard]] PluckerOf<N> line_through(const Vec3<N>& p, const Vec3<N>& q) {
    return {q - p, cross(p, q)};
}

template <typename N>
[[nodiscard]] PlaneOf<N> plane_through(const Vec3<N>& a, const Vec3<N>& b, const Vec3<N>& c) {
    const Vec3<N> n = cross<N>(b - a, c - a);
    return {n, dot(n, a)};
}

/// The line of two planes; zero when they are parallel.
template <typename N>
[[nodiscard]] PluckerOf<N> line_of(const PlaneOf<N>& a, const PlaneOf<N>& b) {
    return {cross(a.n, b.n), b.k * a.n - a.k * b.n};
}

/// m − v × d: normal of the plane of v and the line, zero exactly when v lies on it.
template <typename N>
[[nodiscard]] Vec3<N> normal_from(const PluckerOf<N>& line, const Vec3<N>& v) {
    return line.m - cross(v, line.d);
}
template <typename N>
[[nodiscard]] N normal_from(const PluckerOf<N>& line, const Vec3<N>& v, int axis) {
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    return N(line.m[axis] - (v[j] * line.d[k] - v[k] * line.d[j]));
}

template <>
[[nodiscard]] inline Integer normal_from<Integer>(const PluckerOf<Integer>& line,
                                                  const Vec3<Integer>& v, int axis) {
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    Integer result = line.m[axis];
    subtract_product(result, v[j], line.d[k]);
    add_product(result, v[k], line.d[j]);
    return result;
}

/// Sign of a + b·√c, c ≥ 0.
[[nodiscard]] Sign sign_of_surd(const Integer& a, const Integer& b, const Integer& c);

/// Sign of a + b·√c + e·√f, c, f ≥ 0.
[[nodiscard]] Sign sign_of_surds(const Integer& a, const Integer& b, const Integer& c,
                                 const Integer& e, const Integer& f);

[[nodiscard]] inline Sign sign_of_integer(const Integer& x) { return static_cast<Sign>(sgn(x)); }

}  // namespace sightline::detail
