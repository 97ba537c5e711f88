// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "sightline/arith/rational.hpp"
#include "sightline/arith/surd.hpp"
#include "sightline/scene/scene3.hpp"

/// Vectors, planes and the exact numbers of a 3D scene, for the reference algorithms.
namespace sightline::reference::detail {

template <typename T>
using Triple = std::array<T, 3>;
using RationalTriple = Triple<Rational>;
using SurdTriple = Triple<Surd>;

template <typename T>
[[nodiscard]] Triple<T> plus(const Triple<T>& a, const Triple<T>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <typename T>
[[nodiscard]] Triple<T> minus(const Triple<T>& a, const Triple<T>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
[[nodiscard]] Triple<T> times(const T& k, const Triple<T>& a) {
    return {k * a[0], k * a[1], k * a[2]};
}
template <typename T>
[[nodiscard]] T dot(const Triple<T>& a, const Triple<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename T>
[[nodiscard]] Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
[[nodiscard]] bool is_zero(const T& x) {
    return sign_of(x) == Sign::zero;
}
template <typename T>
[[nodiscard]] bool is_zero(const Triple<T>& a) {
    return is_zero(a[0]) && is_zero(a[1]) && is_zero(a[2]);
}
[[nodiscard]] inline SurdTriple to_surd(const RationalTriple& a) { return {a[0], a[1], a[2]}; }
[[nodiscard]] inline int to_int(Sign s) { return static_cast<int>(s); }

/// The points x with normal·x == offset; the first nonzero coordinate of the normal is 1, so that
/// equal planes are equal values. All zero: not a plane.
struct Plane {
    RationalTriple normal;
    Rational offset;

    friend auto operator<=>(const Plane&, const Plane&) = default;
    friend bool operator==(const Plane&, const Plane&) = default;
};

/// Through p, with the directions u and v; all zero when they are parallel.
[[nodiscard]] Plane plane_of(const RationalTriple& p, const RationalTriple& u,
                             const RationalTriple& v);
[[nodiscard]] inline Rational height(const Plane& plane, const RationalTriple& p) {
    return dot(plane.normal, p) - plane.offset;
}

/// A feature edge in exact numbers.
struct ExactEdge {
    RationalTriple source;
    RationalTriple target;
    RationalTriple direction;  ///< target - source
    RationalTriple moment;     ///< source × direction
};

[[nodiscard]] ExactEdge edge_between(const RationalTriple& source, const RationalTriple& target);
[[nodiscard]] bool parallel(const ExactEdge& a, const ExactEdge& b);
[[nodiscard]] bool coplanar(const ExactEdge& a, const ExactEdge& b);
[[nodiscard]] bool collinear(const ExactEdge& a, const ExactEdge& b);
/// The plane of two edges that are coplanar but not collinear.
[[nodiscard]] Plane plane_of(const ExactEdge& a, const ExactEdge& b);
/// The plane of p and an edge whose line does not pass through p; all zero when it does.
[[nodiscard]] Plane plane_of(const RationalTriple& p, const ExactEdge& e);
/// Where the edge's line pierces a plane that it is not parallel to.
[[nodiscard]] RationalTriple piercing_point(const Plane& plane, const ExactEdge& e);

/// A scene with what the reference needs of it, computed once.
struct ExactScene {
    explicit ExactScene(const Scene3& scene);

    const Scene3& scene;
    std::vector<RationalTriple> vertices;
    std::vector<ExactEdge> edges;
    /// Normal of each face as it is oriented, not scaled; and its plane.
    std::vector<RationalTriple> normals;
    std::vector<Plane> planes;
    /// Where features fix a point: the feature vertices, and the crossings of edges that touch.
    std::vector<RationalTriple> points;
};

}  // namespace sightline::reference::detail
