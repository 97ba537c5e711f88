// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/winding3.hpp"

#include "geom/error_bounded.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

/// Turn of a, b, and p moved by (ε, ε²); zero only when a and b are at one place.
Sign moved_turn(const Point2& a, const Point2& b, const Point2& p) {
    const Sign sign = orientation(a, b, p);
    if (sign != Sign::zero) return sign;
    if (a.y != b.y) return b.y > a.y ? Sign::negative : Sign::positive;
    return a.x == b.x ? Sign::zero : b.x > a.x ? Sign::positive : Sign::negative;
}

template <typename Number>
Number volume_of(const Corners3& t, const Point3& origin) {
    const auto x = [&](std::size_t i) { return Number(t[i].x) - Number(origin.x); };
    const auto y = [&](std::size_t i) { return Number(t[i].y) - Number(origin.y); };
    const auto z = [&](std::size_t i) { return Number(t[i].z) - Number(origin.z); };
    return x(0) * (y(1) * z(2) - z(1) * y(2)) + y(0) * (z(1) * x(2) - x(1) * z(2)) +
           z(0) * (x(1) * y(2) - y(1) * x(2));
}

/// Halving keeps chains of additions short, as the error bound wants, and rational sums small.
template <typename Number>
Number volume_of(std::span<const Corners3> triangles, const Point3& origin) {
    if (triangles.size() == 1) return volume_of<Number>(triangles[0], origin);
    const std::size_t half = triangles.size() / 2;
    return volume_of<Number>(triangles.first(half), origin) +
           volume_of<Number>(triangles.subspan(half), origin);
}

template <typename P>
bool is_on_triangle(const std::array<P, 3>& t, const P& p) {
    if (p == t[0] || p == t[1] || p == t[2]) return true;
    if (orientation3(t[0], t[1], t[2], p) != Sign::zero) return false;
    for (int axis = 2; axis >= 0; --axis) {
        const auto turn = [&](const P& a, const P& b, const P& c) {
            return orientation(drop(a, axis), drop(b, axis), drop(c, axis));
        };
        const Sign facing = turn(t[0], t[1], t[2]);
        if (facing == Sign::zero) continue;
        return facing * turn(t[0], t[1], p) != Sign::negative &&
               facing * turn(t[1], t[2], p) != Sign::negative &&
               facing * turn(t[2], t[0], p) != Sign::negative;
    }
    return false;
}

}  // namespace

SceneBox3 box_of(const Corners3& corners) {
    SceneBox3 box = SceneBox3::of(corners[0]);
    box.include(SceneBox3::of(corners[1]));
    box.include(SceneBox3::of(corners[2]));
    return box;
}

int winding_step(const Corners3& t, const Point3& p) {
    const Point2 q = drop(p, 0);
    const Sign facing = moved_turn(drop(t[0], 0), drop(t[1], 0), q);
    if (facing == Sign::zero || moved_turn(drop(t[1], 0), drop(t[2], 0), q) != facing ||
        moved_turn(drop(t[2], 0), drop(t[0], 0), q) != facing)
        return 0;
    if (orientation3(t[0], t[1], t[2], p) != facing) return 0;
    return facing == Sign::positive ? -1 : 1;
}

Sign sign_of_volume(std::span<const Corners3> triangles) {
    if (triangles.empty()) return Sign::zero;
    const Point3& origin = triangles[0][0];
    if (const auto sign = volume_of<ErrorBounded>(triangles, origin).sign()) return *sign;
    return volume_of<Rational>(triangles, origin).sign();
}

bool is_on(const Corners3& triangle, const Point3& p) { return is_on_triangle(triangle, p); }

bool is_on(const Corners3& t, const RationalPoint3& p) {
    return is_on_triangle<RationalPoint3>({to_rational(t[0]), to_rational(t[1]), to_rational(t[2])},
                                          p);
}

}  // namespace sightline::detail
