// SPDX-License-Identifier: GPL-3.0-or-later
// What sightline/geom/plucker.hpp promises, on random lines of a small grid and by hand.
#include "sightline/geom/plucker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "points3.hpp"
#include "sightline/geom/predicates3.hpp"

namespace sightline {
namespace {

RationalPoint3 point(int x, int y, int z) { return {x, y, z}; }

RationalPoint3 any_point() { return to_rational(*testing::grid_points3(4)); }

RationalLine3 any_line() {
    const RationalPoint3 p = any_point();
    const RationalPoint3 q = *rc::gen::suchThat(
        rc::gen::map(testing::grid_points3(4), [](const Point3& x) { return to_rational(x); }),
        [&](const RationalPoint3& x) { return x != p; });
    return line_through(p, q);
}

RC_GTEST_PROP(PluckerLaw, LinesHoldTheirPoints, ()) {
    const RationalPoint3 p = any_point(), q = any_point();
    const RationalLine3 line = line_through(p, q);
    RC_ASSERT(line.is_line() == (p != q));
    RC_ASSERT(is_on(line, p) && is_on(line, q));
    if (p == q) return;
    RC_ASSERT(is_on(line, foot_of_origin(line)));
    RC_ASSERT(dot(vector_to(foot_of_origin(line)), line.d) == Rational(0));
    RC_ASSERT(line_along(p, q - p) == line);
    RC_ASSERT(scaled(line) == scaled(line_through(q, p)));
    const RationalPoint3 r = any_point();
    RC_ASSERT(is_on(line, r) == cross(q - p, r - p).is_zero());
}

RC_GTEST_PROP(SideLaw, IsSymmetricAndOdd, ()) {
    const RationalLine3 l = any_line(), k = any_line();
    RC_ASSERT(side(k, l) == side(l, k));
    RC_ASSERT(side(-l, k) == -side(l, k));
    RC_ASSERT(side(l, l) == Rational(0));
}

RC_GTEST_PROP(SideLaw, VanishesWhereLinesMeetOrAreParallel, ()) {
    const RationalLine3 l = any_line(), k = any_line();
    const bool parallel = cross(l.d, k.d).is_zero();
    const auto meeting = meeting_point(l, k);
    RC_ASSERT(meeting.is_finite() == !parallel);
    bool meet = false;
    if (!parallel) {
        const Vector3 x = meeting.divided();
        meet = is_on(l, x) && is_on(k, x);
    }
    RC_ASSERT((side(l, k) == Rational(0)) == (parallel || meet));
}

RC_GTEST_PROP(SideLaw, IsTheDeterminantOfFourPoints, ()) {
    const RationalPoint3 p = any_point(), q = any_point(), r = any_point(), s = any_point();
    RC_ASSERT(side(line_through(p, q), line_through(r, s)) == determinant(q - p, r - p, s - p));
    RC_ASSERT(side(line_through(p, q), line_through(r, s)).sign() == side_of_line(p, q, r, s));
    const Vector3 v = vector_to(any_point());
    RC_ASSERT(side(line_through(p + v, q + v), line_through(r + v, s + v)) ==
              side(line_through(p, q), line_through(r, s)));
}

RC_GTEST_PROP(PlaneLaw, HoldsWhatItIsMadeOf, ()) {
    const RationalPoint3 a = any_point(), b = any_point(), c = any_point();
    const Plane3 plane = plane_through(a, b, c);
    for (const RationalPoint3& p : {a, b, c}) RC_ASSERT(plane.height(p) == Rational(0));
    if (plane.is_degenerate()) RC_ASSERT(plane.height(any_point()) == Rational(0));
    const RationalPoint3 d = any_point();
    RC_ASSERT(plane.height(d).sign() == orientation(a, b, c, d));
    const RationalLine3 line = line_through(a, b);
    const Plane3 same = plane_through(c, line);
    RC_ASSERT(same.is_degenerate() == (a == b ? plane.is_degenerate() : is_on(line, c)));
    for (const RationalPoint3& p : {a, b, c}) RC_ASSERT(same.height(p) == Rational(0));
}

RC_GTEST_PROP(PlaneLaw, TwoMeetInTheLineInBoth, ()) {
    const Plane3 p = plane_through(any_point(), any_line());
    const Plane3 q = plane_through(any_point(), any_line());
    const RationalLine3 line = line_of(p, q);
    RC_ASSERT(line.is_line() == !cross(p.normal, q.normal).is_zero());
    if (!line.is_line()) return;
    const RationalPoint3 x = foot_of_origin(line);
    RC_ASSERT(is_on(line, x));
    RC_ASSERT(p.height(x) == Rational(0) && q.height(x) == Rational(0));
    RC_ASSERT(p.height(x + line.d) == Rational(0) && q.height(x + line.d) == Rational(0));
}

RC_GTEST_PROP(VeeLaw, TheLineThroughAPointMeetsBothLines, ()) {
    const RationalPoint3 p = any_point();
    const RationalLine3 l = any_line(), k = any_line();
    const RationalLine3 vee = line_through(p, l, k);
    RC_PRE(vee.is_line());
    RC_ASSERT(is_on(vee, p));
    RC_ASSERT(side(vee, l) == Rational(0) && side(vee, k) == Rational(0));
}

RC_GTEST_PROP(MeetingLaw, ALineMeetsAPlaneInAPointOfBoth, ()) {
    const RationalLine3 line = any_line();
    const Plane3 plane = plane_through(any_point(), any_point(), any_point());
    const auto meeting = meeting_point(line, plane);
    RC_ASSERT(meeting.w == dot(plane.normal, line.d));
    if (!meeting.is_finite()) return;
    const Vector3 x = meeting.divided();
    RC_ASSERT(is_on(line, x));
    RC_ASSERT(dot(plane.normal, x) == plane.offset);
}

RC_GTEST_PROP(ScaledLaw, AllMultiplesAreOne, ()) {
    const RationalLine3 line = any_line();
    const Rational k = *rc::gen::map(rc::gen::inRange(1, 9), [](int i) { return Rational(i); });
    const RationalLine3 multiple{-k * line.d, -k * line.m};
    RC_ASSERT(scaled(multiple) == scaled(line));
    RC_ASSERT(scaled(line).is_line());
    RC_ASSERT(scaled(to_surd(line)) == to_surd(scaled(line)));
}

// The two lines that meet the z axis, the lines y = ±1 parallel to x at heights ±1, and a fourth.
TEST(SurdLine3, IsALineOfItsField) {
    const Surd r = Surd::square_root(2);
    const SurdLine3 line{{r, Surd(1), Surd(0)}, {Surd(0), Surd(0), Surd(3) * r}};
    EXPECT_TRUE(line.is_line());
    EXPECT_EQ(scaled(line).d.y, Surd(0, 1, Rational(1) / 2));
    EXPECT_EQ(scaled(line).m.z, Surd(3));
    EXPECT_LT(scaled(line), scaled(SurdLine3{{r, Surd(2), Surd(0)}, line.m}));
    const auto meeting = meeting_point(line, to_surd(line_through(point(0, 0, 0), point(0, 1, 0))));
    EXPECT_EQ(meeting.divided(), (SurdVector3{0, -3, 0}));
    EXPECT_TRUE(is_on(line, meeting.divided()));
}

TEST(Plucker, PrintsItsCoordinates) {
    std::ostringstream out;
    out << line_through(point(1, 2, 3), point(2, 2, 3)) << ' '
        << plane_through(point(0, 0, 1), point(1, 0, 1), point(0, 1, 1));
    EXPECT_EQ(out.str(), "[(1, 0, 0), (0, 3, -2)] (0, 0, 1) . x = 1");
}

}  // namespace
}  // namespace sightline
