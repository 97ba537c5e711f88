// SPDX-License-Identifier: GPL-3.0-or-later
// The numbered laws of sightline/geom/predicates3.hpp, one property a law.
#include "sightline/geom/predicates3.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "points3.hpp"

namespace sightline {
namespace {

using testing::grid_points3;
using Kind = LineTriangle::Kind;

Point3 shifted(const Point3& p, const Point3& v) { return {p.x + v.x, p.y + v.y, p.z + v.z}; }
Point3 scaled(const Point3& p, int power) {
    return {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
}
Point3 mirrored(const Point3& p) { return {p.y, p.x, p.z}; }

bool is_triangle(const Point3& a, const Point3& b, const Point3& c) {
    return !cross(to_rational(b) - to_rational(a), to_rational(c) - to_rational(a)).is_zero();
}

RC_GTEST_PROP(Orientation3Law1, ExchangingTwoPointsFlipsTheSign,
              (Point3 a, Point3 b, Point3 c, Point3 d)) {
    const Sign sign = orientation(a, b, c, d);
    RC_ASSERT(orientation(b, a, c, d) == -sign);
    RC_ASSERT(orientation(c, b, a, d) == -sign);
    RC_ASSERT(orientation(d, b, c, a) == -sign);
    RC_ASSERT(orientation(a, c, b, d) == -sign);
    RC_ASSERT(orientation(a, d, c, b) == -sign);
    RC_ASSERT(orientation(a, b, d, c) == -sign);
}

RC_GTEST_PROP(Orientation3Law2, ShiftingChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point3>>(4, grid_points3());
    const Point3 v = *grid_points3(1 << 20);
    RC_ASSERT(orientation(shifted(p[0], v), shifted(p[1], v), shifted(p[2], v), shifted(p[3], v)) ==
              orientation(p[0], p[1], p[2], p[3]));
}

RC_GTEST_PROP(Orientation3Law3, ScalingByAPowerOfTwoChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point3>>(4, grid_points3());
    const int power = *rc::gen::inRange(-1074, 1020);
    RC_ASSERT(orientation(scaled(p[0], power), scaled(p[1], power), scaled(p[2], power),
                          scaled(p[3], power)) == orientation(p[0], p[1], p[2], p[3]));
}

RC_GTEST_PROP(Orientation3Law4, MirroringFlipsTheSign, (Point3 a, Point3 b, Point3 c, Point3 d)) {
    RC_ASSERT(orientation(mirrored(a), mirrored(b), mirrored(c), mirrored(d)) ==
              -orientation(a, b, c, d));
}

RC_GTEST_PROP(Orientation3Law5, EqualPointsGiveZero, (Point3 a, Point3 b, Point3 c)) {
    RC_ASSERT(orientation(a, a, b, c) == Sign::zero);
    RC_ASSERT(orientation(a, b, c, b) == Sign::zero);
    RC_ASSERT(orientation(a, b, c, c) == Sign::zero);
}

RC_GTEST_PROP(Orientation3Law, BothKindsOfPointsAgree, (Point3 a, Point3 b, Point3 c, Point3 d)) {
    RC_ASSERT(orientation(to_rational(a), to_rational(b), to_rational(c), to_rational(d)) ==
              orientation(a, b, c, d));
}

RC_GTEST_PROP(SideOfLineLaw1, ExchangingTheLinesChangesNothing,
              (Point3 p, Point3 q, Point3 r, Point3 s)) {
    RC_ASSERT(side_of_line(r, s, p, q) == side_of_line(p, q, r, s));
}

RC_GTEST_PROP(SideOfLineLaw2, ReversingALineFlipsTheSign,
              (Point3 p, Point3 q, Point3 r, Point3 s)) {
    RC_ASSERT(side_of_line(q, p, r, s) == -side_of_line(p, q, r, s));
    RC_ASSERT(side_of_line(p, q, s, r) == -side_of_line(p, q, r, s));
}

RC_GTEST_PROP(SideOfLineLaw3, IsTheOrientationOfTheFourPoints,
              (Point3 p, Point3 q, Point3 r, Point3 s)) {
    RC_ASSERT(side_of_line(p, q, r, s) == orientation(p, q, r, s));
    RC_ASSERT(side_of_line(to_rational(p), to_rational(q), to_rational(r), to_rational(s)) ==
              orientation(p, q, r, s));
}

RC_GTEST_PROP(SideOfLineLaw4, MovingAPointAlongItsLineChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point3>>(4, grid_points3());
    const double k = *rc::gen::inRange(2, 9);
    const auto along = [k](double from, double to) { return from + k * (to - from); };
    const Point3 further{along(p[0].x, p[1].x), along(p[0].y, p[1].y), along(p[0].z, p[1].z)};
    RC_ASSERT(side_of_line(p[0], further, p[2], p[3]) == side_of_line(p[0], p[1], p[2], p[3]));
}

RC_GTEST_PROP(LineTriangleLaw, HoldsAllFour, ()) {
    const auto p = *rc::gen::container<std::vector<Point3>>(5, grid_points3(2));
    RC_PRE(p[0] != p[1] && is_triangle(p[2], p[3], p[4]));
    const LineTriangle got = line_triangle(p[0], p[1], p[2], p[3], p[4]);

    LineTriangle expected = got;
    expected.direction = -got.direction;
    RC_ASSERT(line_triangle(p[1], p[0], p[2], p[3], p[4]) == expected);

    const bool has_index = got.kind == Kind::through_edge || got.kind == Kind::through_vertex;
    expected = got;
    if (has_index) expected.index = static_cast<std::uint8_t>((got.index + 2) % 3);
    RC_ASSERT(line_triangle(p[0], p[1], p[3], p[4], p[2]) == expected);

    expected = got;
    if (has_index && got.index < 2) expected.index = static_cast<std::uint8_t>(1 - got.index);
    expected.direction = -got.direction;
    RC_ASSERT(line_triangle(p[0], p[1], p[3], p[2], p[4]) == expected);

    const auto lies = [&](const Point3& q) {
        return orientation(p[2], p[3], p[4], q) == Sign::zero;
    };
    RC_ASSERT((got.kind == Kind::in_plane) == (lies(p[0]) && lies(p[1])));
}

RC_GTEST_PROP(LinePlaneLaw, HoldsAllThree, ()) {
    const auto p = *rc::gen::container<std::vector<Point3>>(5, grid_points3(2));
    RC_PRE(p[0] != p[1] && is_triangle(p[2], p[3], p[4]));
    const LinePlane got = line_plane(p[0], p[1], p[2], p[3], p[4]);
    const LinePlane turned = got == LinePlane::forward    ? LinePlane::backward
                             : got == LinePlane::backward ? LinePlane::forward
                                                          : got;
    RC_ASSERT(line_plane(p[1], p[0], p[2], p[3], p[4]) == turned);
    RC_ASSERT(line_plane(p[0], p[1], p[3], p[2], p[4]) == turned);
    const Sign from = orientation(p[2], p[3], p[4], p[0]), to = orientation(p[2], p[3], p[4], p[1]);
    RC_ASSERT((got == LinePlane::inside) == (from == Sign::zero && to == Sign::zero));
    if (from * to == Sign::negative) {
        RC_ASSERT(got == (to == Sign::positive ? LinePlane::forward : LinePlane::backward));
    }
    RC_ASSERT(line_plane(to_rational(p[0]), to_rational(p[1]), to_rational(p[2]), to_rational(p[3]),
                         to_rational(p[4])) == got);
}

}  // namespace
}  // namespace sightline
