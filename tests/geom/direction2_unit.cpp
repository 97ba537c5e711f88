// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/direction2.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "points.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

Vector2 vector(int x, int y) { return {x, y}; }

TEST(Direction2, ForgetsLength) {
    EXPECT_EQ(Direction2(vector(2, 4)), Direction2(vector(5, 10)));
    EXPECT_EQ(Direction2(vector(2, 4)).vector(), vector(1, 2));
    EXPECT_EQ(Direction2(vector(0, -7)).vector(), vector(0, -1));
    EXPECT_EQ(Direction2({Rational(1) / Rational(6), Rational(-1) / Rational(4)}).vector(),
              vector(2, -3));
    EXPECT_NE(Direction2(vector(2, 4)), Direction2(vector(-2, -4)));
    EXPECT_EQ(std::hash<Direction2>{}(Direction2(vector(2, 4))),
              std::hash<Direction2>{}(Direction2(vector(3, 6))));
}

TEST(Direction2, ZeroHasNone) {
    EXPECT_THROW((void)Direction2(vector(0, 0)), std::domain_error);
    EXPECT_THROW((void)Direction2(Point2{1, 2}, Point2{1, 2}), std::domain_error);
}

TEST(Direction2, IsOrderedCounterClockwiseFromThePositiveXAxis) {
    const std::vector<Direction2> turn{Direction2(vector(1, 0)),  Direction2(vector(3, 1)),
                                       Direction2(vector(0, 1)),  Direction2(vector(-1, 1)),
                                       Direction2(vector(-1, 0)), Direction2(vector(-1, -3)),
                                       Direction2(vector(0, -1)), Direction2(vector(1, -100))};
    EXPECT_TRUE(std::ranges::is_sorted(turn));
    EXPECT_EQ(std::ranges::adjacent_find(turn), turn.end());
}

TEST(Direction2, TurnsAndReverses) {
    EXPECT_EQ(turned_left(Direction2(vector(3, 1))), Direction2(vector(-1, 3)));
    EXPECT_EQ(reversed(Direction2(vector(3, 1))), Direction2(vector(-3, -1)));
    EXPECT_EQ(side_of(Direction2(vector(1, 0)), Direction2(vector(1, 1))), Sign::positive);
    EXPECT_EQ(side_of(Direction2(vector(1, 1)), Direction2(vector(-1, -1))), Sign::zero);
}

TEST(Direction2, PrintsItsCoprimeIntegers) {
    std::ostringstream out;
    out << Direction2(vector(-4, 6)) << ' ' << vector(1, 2);
    EXPECT_EQ(out.str(), "<-2, 3> (1, 2)");
}

RC_GTEST_PROP(Direction2Law, OrderIsThatOfDirectionsRoundAPoint, (Point2 c, Point2 p, Point2 q)) {
    RC_PRE(c != p && c != q);
    RC_PRE(std::abs(c.x) <= 4);
    const Point2 east{c.x + 1024, c.y};
    const auto order = Direction2(c, p) <=> Direction2(c, q);
    RC_ASSERT(order_of_directions(c, east, p, q) == (order < 0   ? Sign::negative
                                                     : order > 0 ? Sign::positive
                                                                 : Sign::zero));
}

TEST(Vector2, AddsAndMultiplies) {
    const RationalPoint2 p{1, 2}, q{4, 6};
    EXPECT_EQ(q - p, vector(3, 4));
    EXPECT_EQ(p + (q - p), q);
    EXPECT_EQ(squared_length(q - p), Rational(25));
    EXPECT_EQ(dot(vector(1, 2), vector(3, 4)), Rational(11));
    EXPECT_EQ(cross(vector(1, 2), vector(3, 4)), Rational(-2));
    EXPECT_EQ(Rational(1) / Rational(2) * vector(3, 4) - vector(1, 1) + -vector(1, 0),
              (Vector2{Rational(-1) / Rational(2), 1}));
}

}  // namespace
}  // namespace sightline
