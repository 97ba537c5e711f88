// SPDX-License-Identifier: GPL-3.0-or-later
// Points kept as the lines that define them behave like their exact coordinates.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "points.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/geom/vector.hpp"

namespace sightline {
namespace {

ImplicitPoint2 meeting_of(const rc::Gen<Point2>& points) {
    const auto p = *rc::gen::suchThat(
        rc::gen::container<std::vector<Point2>>(4, points), [](const std::vector<Point2>& q) {
            return intersection({q[0], q[1]}, {q[2], q[3]}).has_value();
        });
    return *intersection({p[0], p[1]}, {p[2], p[3]});
}

ImplicitPoint2 some_meeting() { return meeting_of(rc::gen::arbitrary<Point2>()); }

// On a small grid coincidences are frequent.
ImplicitPoint2 some_grid_meeting() { return meeting_of(testing::grid_points(2)); }

Sign order(const RationalPoint2& p, const RationalPoint2& q) {
    return p < q ? Sign::negative : p == q ? Sign::zero : Sign::positive;
}

RC_GTEST_PROP(ImplicitPointLaw, LiesOnBothItsLines, ()) {
    const ImplicitPoint2 p = some_meeting();
    RC_ASSERT(orientation(p.first().source, p.first().target, p) == Sign::zero);
    RC_ASSERT(orientation(p.second().source, p.second().target, p) == Sign::zero);
    RC_ASSERT(turn(p.first(), p.second()) == Sign::positive);
}

RC_GTEST_PROP(ImplicitPointLaw, LinesMeetUnlessParallel, (Point2 a, Point2 b, Point2 c, Point2 d)) {
    const auto determinant =
        cross(to_rational(b) - to_rational(a), to_rational(d) - to_rational(c));
    RC_ASSERT(intersection({a, b}, {c, d}).has_value() == (determinant.sign() != Sign::zero));
    RC_ASSERT(turn({a, b}, {c, d}) == determinant.sign());
}

RC_GTEST_PROP(ImplicitPointLaw, OrientationIsThatOfTheCoordinates, (Point2 a, Point2 b)) {
    const ImplicitPoint2 p = some_meeting(), q = some_meeting(), r = some_meeting();
    const RationalPoint2 rp = to_rational(p), rq = to_rational(q), rr = to_rational(r);
    RC_ASSERT(orientation(a, b, p) == orientation(to_rational(a), to_rational(b), rp));
    RC_ASSERT(orientation(a, p, q) == orientation(to_rational(a), rp, rq));
    RC_ASSERT(orientation(p, q, r) == orientation(rp, rq, rr));
}

RC_GTEST_PROP(ImplicitPointLaw, OrderIsThatOfTheCoordinates, (Point2 a)) {
    const ImplicitPoint2 p = some_meeting(), q = some_meeting();
    RC_ASSERT(compare_xy(p, q) == order(to_rational(p), to_rational(q)));
    RC_ASSERT(compare_xy(p, a) == order(to_rational(p), to_rational(a)));
}

RC_GTEST_PROP(ImplicitPointLaw, CoincidencesAreSeen, ()) {
    const ImplicitPoint2 p = some_grid_meeting(), q = some_grid_meeting(), r = some_grid_meeting();
    RC_ASSERT(compare_xy(p, q) == order(to_rational(p), to_rational(q)));
    RC_ASSERT(orientation(p, q, r) == orientation(to_rational(p), to_rational(q), to_rational(r)));
}

RC_GTEST_PROP(ImplicitPointLaw, OrderAlongIsThatOfTheCoordinates, (Point2 a, Point2 b, Point2 c)) {
    const ImplicitPoint2 p = some_meeting(), q = some_meeting();
    const RationalPoint2 ra = to_rational(a), rb = to_rational(b);
    RC_ASSERT(order_along(a, b, p, q) == order_along(ra, rb, to_rational(p), to_rational(q)));
    RC_ASSERT(order_along(a, b, c, q) == order_along(ra, rb, to_rational(c), to_rational(q)));
}

RC_GTEST_PROP(ImplicitPointLaw, ExactArithmeticAgrees, (Point2 a, Point2 b)) {
    const ImplicitPoint2 p = some_meeting(), q = some_meeting();
    const Predicates2 exact(Arithmetic::exact);
    RC_ASSERT(exact.orientation(a, b, p) == orientation(a, b, p));
    RC_ASSERT(exact.orientation(a, p, q) == orientation(a, p, q));
    RC_ASSERT(exact.orientation(p, q, p) == Sign::zero);
    RC_ASSERT(exact.order_along(a, b, p, q) == order_along(a, b, p, q));
    RC_ASSERT(exact.order_along(a, b, a, q) == order_along(a, b, a, q));
    RC_ASSERT(exact.compare_xy(p, q) == compare_xy(p, q));
    RC_ASSERT(exact.compare_xy(p, a) == compare_xy(p, a));
}

TEST(ImplicitPoint, HasExactCoordinatesOnRequest) {
    const auto p = intersection({{0, 0}, {3, 1}}, {{1, 0}, {1, 9}});
    ASSERT_TRUE(p);
    EXPECT_EQ(to_rational(*p), (RationalPoint2{1, Rational(1) / Rational(3)}));
    EXPECT_EQ(approx_point(*p), (Point2{1, 1.0 / 3}));
}

TEST(ImplicitPoint, ParallelOrPointlikeLinesDoNotMeet) {
    EXPECT_FALSE(intersection({{0, 0}, {1, 1}}, {{0, 1}, {2, 3}}));
    EXPECT_FALSE(intersection({{0, 0}, {1, 1}}, {{2, 2}, {5, 5}}));
    EXPECT_FALSE(intersection({{0, 0}, {0, 0}}, {{2, 2}, {5, 7}}));
}

TEST(ImplicitPoint, TheSamePlaceFromOtherLinesIsEqualThere) {
    const auto p = intersection({{0, 0}, {3, 1}}, {{1, 0}, {1, 9}});
    const auto q = intersection({{6, 2}, {-3, -1}}, {{0, 1}, {2, -1.0 / 3}});
    const auto r = intersection({{6, 2}, {-3, -1}}, {{1, -4}, {1, -9}});
    EXPECT_EQ(compare_xy(*p, *r), Sign::zero);
    EXPECT_EQ(compare_xy(*p, *q), Sign::negative) << "the double next to -1/3 is greater";
    EXPECT_NE(*p, *r) << "equality is that of the generators";
}

TEST(ImplicitPoint, CountsAreThoseOfConstructedOrder) {
    Tally tally;
    const auto p = intersection({{0, 0}, {3, 1}}, {{1, 0}, {1, 9}});
    EXPECT_EQ(Predicates2(Arithmetic::filtered, &tally).compare_xy(*p, Point2{5, 0}),
              Sign::negative);
    EXPECT_EQ(tally[Predicate::constructed_order2], (TierCounts{.calls = 1, .filter = 1}));
}

TEST(Line, IsTheSameFromAnyOfItsPoints) {
    const Line2 l{{0, 0}, {1, 2}};
    EXPECT_TRUE(is_same_line(l, {{5, 10}, {-1, -2}}));
    EXPECT_FALSE(is_same_line(l, {{5, 10}, {-1, -1}}));
    EXPECT_EQ(reversed(l), (Line2{{1, 2}, {0, 0}}));
}

}  // namespace
}  // namespace sightline
