// SPDX-License-Identifier: GPL-3.0-or-later
// The numbered laws of sightline/geom/predicates2.hpp, one property a law.
#include "sightline/geom/predicates2.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "points.hpp"

namespace sightline {
namespace {

using testing::grid_points;

Point2 shifted(const Point2& p, const Point2& v) { return {p.x + v.x, p.y + v.y}; }
Point2 scaled(const Point2& p, int power) {
    return {std::ldexp(p.x, power), std::ldexp(p.y, power)};
}
Point2 mirrored(const Point2& p) { return {p.y, p.x}; }

RC_GTEST_PROP(OrientationLaw, RotatingThePointsChangesNothing, (Point2 a, Point2 b, Point2 c)) {
    RC_ASSERT(orientation(b, c, a) == orientation(a, b, c));
}

RC_GTEST_PROP(OrientationLaw, ExchangingTwoPointsFlipsTheSign, (Point2 a, Point2 b, Point2 c)) {
    RC_ASSERT(orientation(b, a, c) == -orientation(a, b, c));
}

RC_GTEST_PROP(OrientationLaw, ShiftingChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point2>>(3, grid_points());
    const Point2 v = *grid_points(1 << 20);
    RC_ASSERT(orientation(shifted(p[0], v), shifted(p[1], v), shifted(p[2], v)) ==
              orientation(p[0], p[1], p[2]));
}

RC_GTEST_PROP(OrientationLaw, ScalingByAPowerOfTwoChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point2>>(3, grid_points());
    const int power = *rc::gen::inRange(-1074, 1020);
    RC_ASSERT(orientation(scaled(p[0], power), scaled(p[1], power), scaled(p[2], power)) ==
              orientation(p[0], p[1], p[2]));
}

RC_GTEST_PROP(OrientationLaw, MirroringFlipsTheSign, (Point2 a, Point2 b, Point2 c)) {
    RC_ASSERT(orientation(mirrored(a), mirrored(b), mirrored(c)) == -orientation(a, b, c));
}

RC_GTEST_PROP(OrientationLaw, EqualPointsGiveZero, (Point2 a, Point2 b)) {
    RC_ASSERT(orientation(a, a, b) == Sign::zero);
    RC_ASSERT(orientation(a, b, a) == Sign::zero);
    RC_ASSERT(orientation(b, a, a) == Sign::zero);
}

RC_GTEST_PROP(OrientationLaw, AllKindsOfPointsAgree, (Point2 a, Point2 b, Point2 c)) {
    const Sign sign = orientation(a, b, c);
    RC_ASSERT(orientation(to_rational(a), to_rational(b), to_rational(c)) == sign);
    RC_ASSERT(orientation(a, b, to_rational(c)) == sign);
}

RC_GTEST_PROP(OrderAlongLaw, ExchangingPAndQFlipsTheSign,
              (Point2 a, Point2 b, Point2 p, Point2 q)) {
    RC_ASSERT(order_along(a, b, q, p) == -order_along(a, b, p, q));
}

RC_GTEST_PROP(OrderAlongLaw, ReversingTheDirectionFlipsTheSign,
              (Point2 a, Point2 b, Point2 p, Point2 q)) {
    RC_ASSERT(order_along(b, a, p, q) == -order_along(a, b, p, q));
}

RC_GTEST_PROP(OrderAlongLaw, ExchangingThePairsChangesNothing,
              (Point2 a, Point2 b, Point2 p, Point2 q)) {
    RC_ASSERT(order_along(p, q, a, b) == order_along(a, b, p, q));
}

RC_GTEST_PROP(OrderAlongLaw, AComesBeforeB, (Point2 a, Point2 b)) {
    RC_ASSERT(order_along(a, b, a, b) == (a == b ? Sign::zero : Sign::negative));
}

RC_GTEST_PROP(OrderAlongLaw, ShiftingAPairChangesNothing, ()) {
    const auto p = *rc::gen::container<std::vector<Point2>>(4, grid_points());
    const Point2 v = *grid_points(1 << 20);
    const Sign sign = order_along(p[0], p[1], p[2], p[3]);
    RC_ASSERT(order_along(shifted(p[0], v), shifted(p[1], v), p[2], p[3]) == sign);
    RC_ASSERT(order_along(p[0], p[1], shifted(p[2], v), shifted(p[3], v)) == sign);
}

RC_GTEST_PROP(OrderAlongLaw, RationalPointsAgree, (Point2 a, Point2 b, Point2 p, Point2 q)) {
    RC_ASSERT(order_along(to_rational(a), to_rational(b), to_rational(p), to_rational(q)) ==
              order_along(a, b, p, q));
}

RC_GTEST_PROP(OrderOfDirectionsLaw, ExchangingPAndQFlipsTheSign,
              (Point2 c, Point2 r, Point2 p, Point2 q)) {
    RC_PRE(c != r && c != p && c != q);
    RC_ASSERT(order_of_directions(c, r, q, p) == -order_of_directions(c, r, p, q));
}

RC_GTEST_PROP(OrderOfDirectionsLaw, ZeroMeansTheSameDirection,
              (Point2 c, Point2 r, Point2 p, Point2 q)) {
    RC_PRE(c != r && c != p && c != q);
    const bool same =
        orientation(c, p, q) == Sign::zero && order_along(c, p, c, q) == Sign::negative;
    RC_ASSERT((order_of_directions(c, r, p, q) == Sign::zero) == same);
}

RC_GTEST_PROP(OrderOfDirectionsLaw, NothingComesBeforeTheReference,
              (Point2 c, Point2 r, Point2 p)) {
    RC_PRE(c != r && c != p);
    RC_ASSERT(order_of_directions(c, r, r, p) != Sign::positive);
}

RC_GTEST_PROP(OrderOfDirectionsLaw, IsTransitive,
              (Point2 c, Point2 r, Point2 p, Point2 q, Point2 s)) {
    RC_PRE(c != r && c != p && c != q && c != s);
    if (order_of_directions(c, r, p, q) != Sign::positive &&
        order_of_directions(c, r, q, s) != Sign::positive) {
        RC_ASSERT(order_of_directions(c, r, p, s) != Sign::positive);
    }
}

RC_GTEST_PROP(OrderOfDirectionsLaw, LeftTurnsComeInOrderFromAnyOfThem, ()) {
    const Point2 c = *grid_points();
    Point2 p[3] = {*grid_points(), *grid_points(), {}};
    RC_PRE(orientation(c, p[0], p[1]) != Sign::zero);
    if (orientation(c, p[0], p[1]) == Sign::negative) std::swap(p[0], p[1]);
    const int m = *rc::gen::inRange(1, 5);
    const int n = *rc::gen::inRange(1, 5);
    // The third direction is opposite to something strictly between the first two.
    p[2] = {c.x - m * (p[0].x - c.x) - n * (p[1].x - c.x),
            c.y - m * (p[0].y - c.y) - n * (p[1].y - c.y)};
    RC_ASSERT(order_of_directions(c, p[0], p[1], p[2]) == Sign::negative);
    RC_ASSERT(order_of_directions(c, p[1], p[2], p[0]) == Sign::negative);
    RC_ASSERT(order_of_directions(c, p[2], p[0], p[1]) == Sign::negative);
}

RC_GTEST_PROP(OrderOfDirectionsLaw, RationalCentersAgree,
              (Point2 c, Point2 r, Point2 p, Point2 q)) {
    RC_PRE(c != r && c != p && c != q);
    RC_ASSERT(order_of_directions(to_rational(c), r, p, q) == order_of_directions(c, r, p, q));
}

ConePosition exchanged(ConePosition position) {
    switch (position) {
        case ConePosition::inside:
            return ConePosition::outside;
        case ConePosition::outside:
            return ConePosition::inside;
        case ConePosition::on_first:
            return ConePosition::on_second;
        case ConePosition::on_second:
            return ConePosition::on_first;
        case ConePosition::at_apex:
            break;
    }
    return ConePosition::at_apex;
}

RC_GTEST_PROP(ConeLaw, ExchangingTheSidesGivesTheComplement,
              (Point2 c, Point2 first, Point2 second, Point2 p)) {
    RC_PRE(c != first && c != second);
    RC_PRE(order_of_directions(c, first, first, second) != Sign::zero);
    RC_ASSERT(cone_position(c, second, first, p) == exchanged(cone_position(c, first, second, p)));
}

RC_GTEST_PROP(ConeLaw, TheBordersAreOnTheCone, (Point2 c, Point2 first, Point2 second)) {
    RC_PRE(c != first && c != second);
    RC_ASSERT(cone_position(c, first, second, first) == ConePosition::on_first);
    RC_ASSERT(cone_position(c, first, second, c) == ConePosition::at_apex);
    const bool full_turn = order_of_directions(c, first, first, second) == Sign::zero;
    RC_ASSERT(cone_position(c, first, second, second) ==
              (full_turn ? ConePosition::on_first : ConePosition::on_second));
}

RC_GTEST_PROP(ConeLaw, InsideAConvexConeIsBetweenItsSides,
              (Point2 c, Point2 first, Point2 second, Point2 p)) {
    RC_PRE(orientation(c, first, second) == Sign::positive);
    RC_ASSERT(is_in_cone(c, first, second, p) == (orientation(c, first, p) == Sign::positive &&
                                                  orientation(c, second, p) == Sign::negative));
}

SegmentCrossing exchanged(SegmentCrossing crossing) {
    switch (crossing) {
        case SegmentCrossing::first_ends_inside_second:
            return SegmentCrossing::second_ends_inside_first;
        case SegmentCrossing::second_ends_inside_first:
            return SegmentCrossing::first_ends_inside_second;
        default:
            return crossing;
    }
}

RC_GTEST_PROP(CrossingLaw, ExchangingTheSegmentsExchangesTheirRoles,
              (Point2 a, Point2 b, Point2 c, Point2 d)) {
    RC_ASSERT(crossing({c, d}, {a, b}) == exchanged(crossing({a, b}, {c, d})));
}

RC_GTEST_PROP(CrossingLaw, ReversingASegmentChangesNothing,
              (Point2 a, Point2 b, Point2 c, Point2 d)) {
    const SegmentCrossing expected = crossing({a, b}, {c, d});
    RC_ASSERT(crossing({b, a}, {c, d}) == expected);
    RC_ASSERT(crossing({a, b}, {d, c}) == expected);
}

RC_GTEST_PROP(CrossingLaw, ASegmentOverlapsItself, (Point2 a, Point2 b)) {
    RC_ASSERT(crossing({a, b}, {a, b}) ==
              (a == b ? SegmentCrossing::end_to_end : SegmentCrossing::overlap));
}

// Kinds of crossing by the definition: intersect, in exact coordinates.
SegmentCrossing crossing_by_definition(const Segment2& s, const Segment2& t) {
    const auto meeting = intersection({s.source, s.target}, {t.source, t.target});
    RC_PRE(meeting.has_value());
    const RationalPoint2 p = to_rational(*meeting);
    const auto holds = [&p](const Segment2& segment) {
        const auto [low, high] =
            std::minmax({to_rational(segment.source), to_rational(segment.target)});
        return low <= p && p <= high;
    };
    const auto ends = [&p](const Segment2& segment) {
        return p == to_rational(segment.source) || p == to_rational(segment.target);
    };
    if (!holds(s) || !holds(t)) return SegmentCrossing::none;
    if (ends(s) && ends(t)) return SegmentCrossing::end_to_end;
    if (ends(s)) return SegmentCrossing::first_ends_inside_second;
    return ends(t) ? SegmentCrossing::second_ends_inside_first : SegmentCrossing::proper;
}

RC_GTEST_PROP(CrossingLaw, AgreesWithTheExactMeetingPoint,
              (Point2 a, Point2 b, Point2 c, Point2 d)) {
    RC_ASSERT(crossing({a, b}, {c, d}) == crossing_by_definition({a, b}, {c, d}));
}

}  // namespace
}  // namespace sightline
