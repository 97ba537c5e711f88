// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A scene in rational numbers, and the plain tests of points against it that everything else can be held to.
/// Private.

#include <array>
#include <optional>
#include <vector>

#include "sightline/geom/vector3.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::detail {

struct ExactTriangle {
    std::array<Vector3, 3> corners;
    Vector3 normal;   ///< to the front
    Rational offset;  ///< normal · x for the points of its plane
    BodyId body;
    FaceId face;
    bool is_sheet = false;
};

/// A scene's triangles in rational numbers.
class ExactTriangles {
public:
    explicit ExactTriangles(const Scene3& scene) : scene_(scene) {
        for (const Triangle3& t : scene.triangles()) {
            ExactTriangle exact;
            for (std::size_t i = 0; i < 3; ++i) {
                exact.corners[i] = vector_to(scene[t.corners[i]]);
            }
            const auto& [a, b, c] = exact.corners;
            exact.normal = cross(b - a, c - a);
            exact.offset = dot(exact.normal, a);
            exact.face = t.face;
            exact.body = scene[t.face].body;
            exact.is_sheet = scene[exact.body].kind == SurfaceKind::sheet;
            triangles_.push_back(std::move(exact));
        }
    }

    [[nodiscard]] const Scene3& scene() const noexcept { return scene_; }
    [[nodiscard]] const std::vector<ExactTriangle>& triangles() const noexcept {
        return triangles_;
    }
    [[nodiscard]] static Vector3 vector_to(const Point3& p) {
        return {Rational(p.x), Rational(p.y), Rational(p.z)};
    }

private:
    const Scene3& scene_;
    std::vector<ExactTriangle> triangles_;
};

/// The same vector over another number type.
template <typename Number>
[[nodiscard]] BasicVector3<Number> over(const Vector3& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
}

/// n·x - offset: zero on the triangle's plane, positive in front of it.
template <typename Number>
[[nodiscard]] Number height(const ExactTriangle& t, const BasicVector3<Number>& x) {
    return dot(over<Number>(t.normal), x) - Number(t.offset);
}

/// How far x, or a direction when `from_corner` is false, leads to the inner side of the edge that
/// starts at corner i, times a positive number.
template <typename Number>
[[nodiscard]] Number inward(const ExactTriangle& t, std::size_t i, const BasicVector3<Number>& x,
                            bool from_corner = true) {
    const Vector3 edge = t.corners[(i + 1) % 3] - t.corners[i];
    const auto along = over<Number>(cross(t.normal, edge));
    return from_corner ? dot(along, x - over<Number>(t.corners[i])) : dot(along, x);
}

/// Whether x lies in the closed triangle.
template <typename Number>
[[nodiscard]] bool contains(const ExactTriangle& t, const BasicVector3<Number>& x) {
    if (sign_of(height(t, x)) != Sign::zero) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (sign_of(inward(t, i, x)) == Sign::negative) return false;
    }
    return true;
}

/// Whether a short step from x, in the triangle, along a direction of its plane stays in it.
template <typename Number>
[[nodiscard]] bool leads_into(const ExactTriangle& t, const BasicVector3<Number>& x,
                              const BasicVector3<Number>& direction) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (sign_of(inward(t, i, x)) == Sign::zero &&
            sign_of(inward(t, i, direction, false)) == Sign::negative) {
            return false;
        }
    }
    return true;
}

/// Whether the ray from y crosses the inside of the triangle; empty when it meets the border, or touches
/// the plane only.
template <typename Number>
[[nodiscard]] std::optional<bool> ray_crosses(const ExactTriangle& t, const BasicVector3<Number>& y,
                                              const BasicVector3<Number>& direction) {
    std::array<Sign, 3> sides;
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] = sign_of(determinant(direction, over<Number>(t.corners[i]) - y,
                                       over<Number>(t.corners[(i + 1) % 3]) - y));
        if (sides[i] == Sign::zero) return std::nullopt;
    }
    if (sides[0] != sides[1] || sides[1] != sides[2]) return false;
    return sign_of(height(t, y)) * sign_of(dot(over<Number>(t.normal), direction)) ==
           Sign::negative;
}

/// The solids, the world's outside included, that contain y, which lies on no face; ascending.
template <typename Number>
[[nodiscard]] std::vector<BodyId> solids_containing(const ExactTriangles& exact,
                                                    const BasicVector3<Number>& y) {
    const auto bodies = exact.scene().bodies();
    // Almost every direction avoids all edges; one that does not is given up for the next.
    for (int attempt = 1;; ++attempt) {
        const BasicVector3<Number> direction{Number(1009), Number(104 + 37 * attempt),
                                             Number(attempt * attempt + 11)};
        std::vector<bool> odd(bodies.size());
        bool decided = true;
        for (const ExactTriangle& t : exact.triangles()) {
            if (t.is_sheet) continue;
            const auto crosses = ray_crosses(t, y, direction);
            decided = crosses.has_value();
            if (!decided) break;
            if (*crosses) odd[t.body.index()] = !odd[t.body.index()];
        }
        if (!decided) continue;
        std::vector<BodyId> result;
        for (std::uint32_t b = 0; b < bodies.size(); ++b) {
            if (bodies[b].kind == SurfaceKind::solid && odd[b] != bodies[b].is_world) {
                result.push_back(BodyId{b});
            }
        }
        return result;
    }
}

/// The largest power of 1/2 that is at most 1 and by which `change` must be multiplied so that added to
/// `base`, of the opposite sign, it does not outweigh it.
template <typename Number>
void shrink(Number& factor, const Number& base, const Number& change) {
    const Number half = Number(1) / Number(2);
    while (sign_of(base + factor * change) != sign_of(base)) factor = factor * half;
}

/// The solids into which a direction leads from x, in which it lies in no plane of a triangle through x: by
/// looking at a point so near that no other plane is in between.
template <typename Number>
[[nodiscard]] std::vector<BodyId> solids_along(const ExactTriangles& exact,
                                               const BasicVector3<Number>& x,
                                               const BasicVector3<Number>& direction) {
    Number step(1);
    for (const ExactTriangle& t : exact.triangles()) {
        const Number at_x = height(t, x);
        const Number change = dot(over<Number>(t.normal), direction);
        if (sign_of(at_x) * sign_of(change) == Sign::negative) shrink(step, at_x, change);
    }
    return solids_containing(exact, x + step * direction);
}

}  // namespace sightline::detail
