// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <ostream>

#include "sightline/geom/plane3.hpp"
#include "sightline/geom/vector3.hpp"

/// Lines of space as Plücker vectors. Everything is a polynomial in the coordinates, without
/// divisions; only scaled() and what says so divides. \cite pottmann_wallner_2001

namespace sightline {

/// A directed line: direction d, and moment m = p × d for any of its points p.
///
/// A 6-vector is a line iff d·m = 0 and d ≠ 0 (is_line()). Positive multiples are the same directed
/// line, all multiples but zero the same line; == compares vectors, so compare scaled() lines.
template <typename Number>
struct BasicLine3 {
    BasicVector3<Number> d;
    BasicVector3<Number> m;

    [[nodiscard]] bool is_line() const { return !d.is_zero() && sign_of(dot(d, m)) == Sign::zero; }
    /// d, then m.
    [[nodiscard]] std::array<Number, 6> coordinates() const {
        return {d.x, d.y, d.z, m.x, m.y, m.z};
    }

    friend bool operator==(const BasicLine3&, const BasicLine3&) = default;
    friend auto operator<=>(const BasicLine3&, const BasicLine3&) = default;
    [[nodiscard]] friend BasicLine3 operator-(const BasicLine3& l) { return {-l.d, -l.m}; }
    friend std::ostream& operator<<(std::ostream& out, const BasicLine3& l) {
        return out << '[' << l.d << ", " << l.m << ']';
    }
};

/// A line with rational coordinates.
using RationalLine3 = BasicLine3<Rational>;
/// A line with coordinates in one quadratic field: one that meets four rational lines.
using SurdLine3 = BasicLine3<Surd>;

[[nodiscard]] inline SurdLine3 to_surd(const RationalLine3& l) {
    return {to_surd(l.d), to_surd(l.m)};
}

/// The line from p to q; its direction is q - p. Not a line when p == q.
[[nodiscard]] inline RationalLine3 line_through(const RationalPoint3& p, const RationalPoint3& q) {
    return {q - p, cross(vector_to(p), vector_to(q))};
}

/// The line through p with direction d.
[[nodiscard]] inline RationalLine3 line_along(const RationalPoint3& p, const Vector3& d) {
    return {d, cross(vector_to(p), d)};
}

/// l.d·k.m + l.m·k.d: how k passes l. The polynomial behind every predicate on lines.
///
/// Laws
///  (1) side(k, l) == side(l, k)
///  (2) side(-l, k) == -side(l, k)
///  (3) zero exactly when the lines meet or are parallel
///  (4) side(line_through(p, q), line_through(r, s)) is the determinant of q-p, r-p, s-p: positive
///      when r, s turn counter-clockwise round p→q seen from q
///  (5) adding one vector to all points changes nothing
template <typename Number>
[[nodiscard]] Number side(const BasicLine3<Number>& l, const BasicLine3<Number>& k) {
    return dot(l.d, k.m) + dot(l.m, k.d);
}

/// Whether p lies on l.
template <typename Number>
[[nodiscard]] bool is_on(const BasicLine3<Number>& l, const BasicVector3<Number>& p) {
    return cross(p, l.d) == l.m;
}
[[nodiscard]] inline bool is_on(const RationalLine3& l, const RationalPoint3& p) {
    return is_on(l, vector_to(p));
}

/// The plane through p and l; degenerate when p lies on l.
[[nodiscard]] inline Plane3 plane_through(const RationalPoint3& p, const RationalLine3& l) {
    const Vector3 normal = l.m - cross(vector_to(p), l.d);
    return {normal, dot(l.m, vector_to(p))};
}

/// The line in which two planes meet, along the product of their normals. Not a line when they are
/// parallel.
[[nodiscard]] inline RationalLine3 line_of(const Plane3& a, const Plane3& b) {
    return {cross(a.normal, b.normal), b.offset * a.normal - a.offset * b.normal};
}

/// The line through p that meets the lines l and k (a VEE line). Not a line when p lies on one of
/// them, or in one plane with both: then there is a pencil of them, or more.
[[nodiscard]] inline RationalLine3 line_through(const RationalPoint3& p, const RationalLine3& l,
                                                const RationalLine3& k) {
    return line_of(plane_through(p, l), plane_through(p, k));
}

/// A point times a weight: stands for the point p / w; at infinity when w is zero.
template <typename Number>
struct HomogeneousPoint3 {
    BasicVector3<Number> p;
    Number w;

    [[nodiscard]] bool is_finite() const { return sign_of(w) != Sign::zero; }
    /// p / w. Throws std::domain_error when it is at infinity.
    [[nodiscard]] BasicVector3<Number> divided() const { return {p.x / w, p.y / w, p.z / w}; }
};

/// Where l meets the plane normal·x == offset; w is normal·d, zero when they are parallel.
template <typename Number>
[[nodiscard]] HomogeneousPoint3<Number> meeting_point(const BasicLine3<Number>& l,
                                                      const BasicVector3<Number>& normal,
                                                      const Number& offset) {
    return {cross(normal, l.m) + offset * l.d, dot(normal, l.d)};
}
[[nodiscard]] inline HomogeneousPoint3<Rational> meeting_point(const RationalLine3& l,
                                                               const Plane3& plane) {
    return meeting_point(l, plane.normal, plane.offset);
}

/// Where two lines meet, for lines with side zero; at infinity when they are parallel (or one).
template <typename Number>
[[nodiscard]] HomogeneousPoint3<Number> meeting_point(const BasicLine3<Number>& l,
                                                      const BasicLine3<Number>& k) {
    // The plane through k at right angles to that of both lines.
    const BasicVector3<Number> e = cross(l.d, k.d);
    return meeting_point(l, cross(k.d, e), dot(e, k.m));
}

/// The foot of the perpendicular from the origin: a rational point of every rational line.
[[nodiscard]] inline RationalPoint3 foot_of_origin(const RationalLine3& l) {
    const Vector3 p = HomogeneousPoint3<Rational>{cross(l.d, l.m), dot(l.d, l.d)}.divided();
    return {p.x, p.y, p.z};
}

/// The one multiple whose first nonzero direction coordinate is 1: the same for all multiples, so
/// scaled lines are equal iff the undirected lines are. Contract: d ≠ 0, or std::domain_error.
template <typename Number>
[[nodiscard]] BasicLine3<Number> scaled(const BasicLine3<Number>& l) {
    const auto is_zero = [](const Number& x) { return sign_of(x) == Sign::zero; };
    const Number& by = !is_zero(l.d.x) ? l.d.x : !is_zero(l.d.y) ? l.d.y : l.d.z;
    return {{l.d.x / by, l.d.y / by, l.d.z / by}, {l.m.x / by, l.m.y / by, l.m.z / by}};
}

}  // namespace sightline
