// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/triangulate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace sightline::viz::detail {
namespace {

double area(const Position& a, const Position& b, const Position& c) {
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

double area(const Triangles& t) {
    double sum = 0;
    for (const auto& [a, b, c] : t.triangles) sum += area(t.points[a], t.points[b], t.points[c]);
    return sum;
}

bool covers(const Triangles& t, const Position& p) {
    return std::ranges::any_of(t.triangles, [&](const auto& corners) {
        const auto& [a, b, c] = corners;
        return area(t.points[a], t.points[b], p) >= 0 && area(t.points[b], t.points[c], p) >= 0 &&
               area(t.points[c], t.points[a], p) >= 0;
    });
}

TEST(Triangulate, ConcavePolygonKeepsItsNotch) {
    const Triangles t = triangulate({{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, {}, 0});
    EXPECT_EQ(t.triangles.size(), 3u);
    EXPECT_DOUBLE_EQ(area(t), 10);
    EXPECT_FALSE(covers(t, {2, 2}));
}

TEST(Triangulate, HolesStayEmptyInEitherDirection) {
    const std::vector<Position> hole{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    for (const auto& ring : {hole, std::vector<Position>(hole.rbegin(), hole.rend())}) {
        const Triangles t = triangulate({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {ring}, 0});
        EXPECT_DOUBLE_EQ(area(t), 12);
        EXPECT_FALSE(covers(t, {2, 2}));
        EXPECT_TRUE(covers(t, {0.5, 2}));
    }
}

TEST(Triangulate, HolesMayTouchTheOuterRingAndEachOther) {
    const Triangles t = triangulate({{{0, 0}, {6, 0}, {6, 4}, {0, 4}},
                                     {{{0, 0}, {2, 1}, {1, 2}}, {{2, 1}, {4, 1}, {3, 3}}},
                                     0});
    EXPECT_DOUBLE_EQ(area(t), 24 - 1.5 - 2);
}

TEST(Triangulate, EdgesRunThroughTwiceSeparateNothing) {
    // A square whose ring goes along a slit and back.
    const Triangles t =
        triangulate({{{0, 0}, {2, 0}, {2, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, {}, 0});
    EXPECT_DOUBLE_EQ(area(t), 16);
}

TEST(Triangulate, FlatRingsHaveNoInside) {
    EXPECT_TRUE(triangulate({{}, {}, 0}).triangles.empty());
    EXPECT_TRUE(triangulate({{{1, 1}}, {}, 0}).triangles.empty());
    EXPECT_TRUE(triangulate({{{0, 0}, {1, 1}, {2, 2}}, {}, 0}).triangles.empty());
}

TEST(Triangulate, SizesFarFromOneAreFine) {
    for (const double s : {1e-300, 1e-150, 1e150, 1e300}) {
        const Triangles t =
            triangulate({{{0, 0}, {4 * s, 0}, {4 * s, 4 * s}, {2 * s, 1 * s}, {0, 4 * s}}, {}, 0});
        EXPECT_EQ(t.triangles.size(), 3u) << s;
        EXPECT_EQ(t.points.size(), 5u) << s;
    }
}

RC_GTEST_PROP(TriangulateLaw, StarShapedPolygonsKeepTheirArea, ()) {
    const auto radii = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(1, 100));
    Polygon polygon;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double angle = 0.5 * static_cast<double>(i);
        polygon.outer.push_back({radii[i] * std::cos(angle), radii[i] * std::sin(angle)});
    }
    double wanted = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        wanted += area({0, 0}, polygon.outer[i], polygon.outer[(i + 1) % radii.size()]);
    }
    const Triangles t = triangulate(polygon);
    RC_ASSERT(t.triangles.size() == radii.size() - 2);
    RC_ASSERT(std::abs(area(t) - wanted) < 1e-6);
}

}  // namespace
}  // namespace sightline::viz::detail
