// SPDX-License-Identifier: GPL-3.0-or-later
// Lines against triangles in small grids, against the definition: the crossing point itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "points3.hpp"
#include "sightline/geom/plucker.hpp"
#include "sightline/geom/predicates3.hpp"

namespace sightline {
namespace {

using Kind = LineTriangle::Kind;

// The definition, transcribed: where the line meets the plane, and that point's barycentric signs.
LineTriangle by_definition(const RationalPoint3& p, const RationalPoint3& q,
                           const std::array<RationalPoint3, 3>& t) {
    const Plane3 plane = plane_through(t[0], t[1], t[2]);
    const Sign slope = dot(plane.normal, q - p).sign();
    if (slope == Sign::zero) {
        return {plane.height(p).sign() == Sign::zero ? Kind::in_plane : Kind::misses, 0,
                Sign::zero};
    }
    const RationalPoint3 x = p + -plane.height(p) / dot(plane.normal, q - p) * (q - p);
    int zeros = 0;
    std::uint8_t zero = 0, other = 0;
    for (std::uint8_t i = 0; i < 3; ++i) {
        const auto& a = t[(i + 1) % 3];
        const auto& b = t[(i + 2) % 3];
        const Sign weight = dot(plane.normal, cross(b - a, x - a)).sign();
        if (weight == Sign::negative) return {};
        if (weight == Sign::zero) {
            ++zeros;
            zero = i;
        } else {
            other = i;
        }
    }
    if (zeros == 0) return {Kind::crosses_inside, 0, slope};
    if (zeros == 1) return {Kind::through_edge, zero, slope};
    return {Kind::through_vertex, other, slope};
}

TEST(LineTriangleExhaustive, LinesOfTheGridAgainstTrianglesOfAllShapes) {
    const std::array<std::array<Point3, 3>, 3> triangles{{{{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}},
                                                          {{{0, 0, 0}, {2, 1, 1}, {1, 2, 2}}},
                                                          {{{2, 2, 0}, {0, 0, 2}, {1, 0, 0}}}}};
    int found[5] = {};
    const auto grid = testing::grid3(3);
    for (const auto& t : triangles) {
        const std::array rational{to_rational(t[0]), to_rational(t[1]), to_rational(t[2])};
        for (const Point3& p : grid) {
            for (const Point3& q : grid) {
                if (p == q) continue;
                const LineTriangle expected =
                    by_definition(to_rational(p), to_rational(q), rational);
                ASSERT_EQ(line_triangle(p, q, t[0], t[1], t[2]), expected) << p << q;
                ASSERT_EQ(line_triangle(to_rational(p), to_rational(q), rational[0], rational[1],
                                        rational[2]),
                          expected);
                ++found[static_cast<int>(expected.kind)];
            }
        }
    }
    EXPECT_TRUE(std::ranges::all_of(found, [](int n) { return n > 20; }));
}

TEST(LineTriangleDegenerate, ALineThroughACornerOrAnEdgeSaysWhich) {
    const Point3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
    const auto upward = [&](double x, double y) {
        return line_triangle({x, y, -1}, {x, y, 1}, a, b, c);
    };
    EXPECT_EQ(upward(1, 1), (LineTriangle{Kind::crosses_inside, 0, Sign::positive}));
    EXPECT_EQ(upward(2, 2), (LineTriangle{Kind::through_edge, 0, Sign::positive}));
    EXPECT_EQ(upward(0, 2), (LineTriangle{Kind::through_edge, 1, Sign::positive}));
    EXPECT_EQ(upward(2, 0), (LineTriangle{Kind::through_edge, 2, Sign::positive}));
    EXPECT_EQ(upward(4, 0), (LineTriangle{Kind::through_vertex, 1, Sign::positive}));
    EXPECT_EQ(upward(3, 2), LineTriangle{});
    EXPECT_EQ(line_triangle({0, 0, 1}, {1, 0, 1}, a, b, c), LineTriangle{}) << "parallel";
    EXPECT_EQ(line_triangle(b, c, a, b, c).kind, Kind::in_plane) << "along an edge";
    EXPECT_EQ(line_triangle({9, 9, 0}, {9, 8, 0}, a, b, c).kind, Kind::in_plane)
        << "in the plane, also when it misses the triangle";
}

}  // namespace
}  // namespace sightline
