// SPDX-License-Identifier: GPL-3.0-or-later
// What each family promises beyond validity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/families2_detail.hpp"
#include "scene/families_support.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/families.hpp"

namespace sightline {
namespace {

using families::detail::IntPoint;
using families::detail::IntRing;
using families_test::points_of;

IntRing to_int(const Ring2& ring) {
    IntRing result;
    for (const Point2& p : ring) {
        result.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)});
        EXPECT_EQ(families::detail::to_point(result.back()), p) << "not an integer";
    }
    return result;
}

double twice_area(const Ring2& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2& p = ring[i];
        const Point2& q = ring[(i + 1) % ring.size()];
        sum += p.x * q.y - p.y * q.x;
    }
    return std::abs(sum);
}

std::vector<IntRing> outer_rings(const SceneInput2& scene) {
    std::vector<IntRing> rings;
    for (const SceneElement2& element : scene.elements) {
        if (const auto* polygon = std::get_if<Polygon2>(&element))
            rings.push_back(to_int(polygon->outer));
    }
    return rings;
}

TEST(RandomConvex, HasTheVerticesAskedForAndFourOfTheWorld) {
    for (const auto density :
         {families::Density::sparse, families::Density::dense, families::Density::packed}) {
        for (std::size_t n = 3; n < 60; ++n) {
            EXPECT_EQ(points_of(families::random_convex({n, density, true}, n)).size(), n + 4);
            EXPECT_EQ(points_of(families::random_convex({n, density, false}, n)).size(), n);
        }
    }
}

TEST(RandomConvex, BodiesAreStrictlyConvexAndHaveNoPointInCommon) {
    for (const auto density :
         {families::Density::sparse, families::Density::dense, families::Density::packed}) {
        const std::vector<IntRing> rings =
            outer_rings(families::random_convex({400, density, false}, 5));
        for (std::size_t i = 0; i < rings.size(); ++i) {
            EXPECT_TRUE(families::detail::turns_left_everywhere(rings[i]));
            EXPECT_LE(rings[i].size(), 8U);
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_TRUE(families::detail::are_disjoint(rings[i], rings[j])) << i << ' ' << j;
            }
        }
    }
}

TEST(RandomConvex, DensityIsTheShareOfTheSquareThatBodiesCover) {
    const auto cover = [](families::Density density) {
        const SceneInput2 scene = families::random_convex({5000, density, true}, 11);
        const auto& world = std::get<Polygon2>(scene.elements.front());
        double bodies = 0;
        for (const Ring2& hole : world.holes) bodies += twice_area(hole);
        return bodies / twice_area(world.outer);
    };
    EXPECT_GT(cover(families::Density::sparse), 0.004);
    EXPECT_LT(cover(families::Density::sparse), 0.02);
    EXPECT_GT(cover(families::Density::dense), 0.08);
    EXPECT_LT(cover(families::Density::dense), 0.16);
    EXPECT_GT(cover(families::Density::packed), 0.5);
}

TEST(RandomConvex, SeedsGiveDifferentScenes) {
    EXPECT_NE(points_of(families::random_convex({}, 1)), points_of(families::random_convex({}, 2)));
}

TEST(RandomConvex, RefusesSizesOutOfRange) {
    EXPECT_THROW((void)families::random_convex({.vertices = 2}, 1), ContractViolation);
    EXPECT_THROW((void)families::grid({0, 3}), ContractViolation);
}

TEST(ScaledConvex, IsTheDenseSceneTimesAPowerOfTwo) {
    const std::vector<Point2> plain = points_of(families::random_convex({.vertices = 100}, 9));
    for (const int exponent : {478, -518, -1074}) {
        const std::vector<Point2> scaled = points_of(families::scaled_convex({100, exponent}, 9));
        ASSERT_EQ(scaled.size(), plain.size());
        double largest = 0;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            EXPECT_EQ(std::ldexp(scaled[i].x, -exponent), plain[i].x);
            EXPECT_EQ(std::ldexp(scaled[i].y, -exponent), plain[i].y);
            largest = std::max(largest, std::abs(scaled[i].x));
        }
        if (exponent == 478) {
            EXPECT_EQ(std::floor(std::log10(largest)), 149);
        }
        if (exponent == -1074) {
            EXPECT_LT(largest, std::numeric_limits<double>::min());
        }
    }
}

TEST(Needles, AreThousandsOfTimesLongerThanWide) {
    for (const IntRing& ring : outer_rings(families::needles({200}, 4))) {
        const IntPoint along = ring[1] - ring[0];
        const std::int64_t length_squared = along.x * along.x + along.y * along.y;
        // width = twice the area / length
        EXPECT_GT(length_squared, 1000 * families::detail::cross(ring[0], ring[1], ring[2]));
        EXPECT_GT(families::detail::cross(ring[0], ring[1], ring[2]), 0);
    }
}

TEST(PolygonsWithHoles, HasThatManyHolesInEachAndBodiesInSome) {
    const SceneInput2 scene = families::polygons_with_holes({3, 7}, 2);
    std::size_t with_holes = 0;
    for (const SceneElement2& element : scene.elements) {
        const auto& polygon = std::get<Polygon2>(element);
        if (polygon.holes.empty()) continue;
        EXPECT_EQ(polygon.holes.size(), 7U);
        ++with_holes;
    }
    EXPECT_EQ(with_holes, 3U);
    EXPECT_GT(scene.elements.size(), 2 * with_holes);
}

/// Whether some point sees the whole polygon: then some crossing of two edges' lines lies left of all edges.
bool has_kernel(const IntRing& ccw) {
    const std::size_t n = ccw.size();
    const auto direction = [&](std::size_t i) { return ccw[(i + 1) % n] - ccw[i]; };
    using Wide = long double;  // 64-bit mantissa; the tests below have products under 2^60
    const auto left_of_all = [&](std::size_t i, std::size_t j) {
        const std::int64_t det = families::detail::cross(direction(i), direction(j));
        if (det == 0) return false;
        const std::int64_t part = families::detail::cross(ccw[j] - ccw[i], direction(j));
        const Wide t = static_cast<Wide>(part) / static_cast<Wide>(det);
        const Wide x = static_cast<Wide>(ccw[i].x) + t * static_cast<Wide>(direction(i).x);
        const Wide y = static_cast<Wide>(ccw[i].y) + t * static_cast<Wide>(direction(i).y);
        for (std::size_t k = 0; k < n; ++k) {
            const Wide side =
                static_cast<Wide>(direction(k).x) * (y - static_cast<Wide>(ccw[k].y)) -
                static_cast<Wide>(direction(k).y) * (x - static_cast<Wide>(ccw[k].x));
            // Generous, so that a polygon without a kernel by this test surely has none.
            if (side < -1000.0L) return false;
        }
        return true;
    };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (left_of_all(i, j)) return true;
        }
    }
    return false;
}

std::int64_t twice_signed_area(const IntRing& ring) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        sum += families::detail::cross(ring[i], ring[(i + 1) % ring.size()]);
    }
    return sum;
}

TEST(StarShaped, IsSeenFromTheOrigin) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const IntRing ring = outer_rings(families::star_shaped({30}, seed)).front();
        ASSERT_EQ(ring.size(), 30U);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            EXPECT_GT(families::detail::cross(ring[i], ring[(i + 1) % ring.size()]), 0);
        }
        EXPECT_TRUE(has_kernel(ring));
    }
}

TEST(SimplePolygon, IsAsARuleNotStarShaped) {
    int star_shaped = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const IntRing ring = outer_rings(families::simple_polygon({24}, seed)).front();
        ASSERT_EQ(ring.size(), 24U);
        EXPECT_GT(twice_signed_area(ring), 0);
        star_shaped += has_kernel(ring) ? 1 : 0;
    }
    EXPECT_LE(star_shaped, 3);
}

TEST(SimplePolygon, CopesWithManyCollinearPoints) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        families::detail::Rng rng(seed);
        const std::size_t n = 3 + seed % 10;
        const IntRing ring =
            families::detail::random_simple_ring(rng, n, 4);  // 25 lattice points in all
        SceneInput2 scene;
        scene.elements.emplace_back(families::detail::to_polygon(ring));
        const Result<Scene2> made = Scene2::make(scene);
        EXPECT_TRUE(made) << seed << ": " << made.error().message;
        EXPECT_EQ(ring.size(), n);
    }
}

TEST(OnCircle, IsExactAtQuarterTurnsAndWithinOneElsewhere) {
    constexpr std::int64_t r = 1'000'000;
    EXPECT_EQ(families::detail::on_circle(0, 7, r), (IntPoint{r, 0}));
    EXPECT_EQ(families::detail::on_circle(1, 4, r), (IntPoint{0, r}));
    EXPECT_EQ(families::detail::on_circle(2, 4, r), (IntPoint{-r, 0}));
    EXPECT_EQ(families::detail::on_circle(9, 12, r), (IntPoint{0, -r}));
    for (std::uint64_t k = 0; k < 1000; ++k) {
        const IntPoint p = families::detail::on_circle(k, 1000, r);
        const double angle = 2 * M_PI * static_cast<double>(k) / 1000;
        EXPECT_NEAR(static_cast<double>(p.x), r * std::cos(angle), 1);
        EXPECT_NEAR(static_cast<double>(p.y), r * std::sin(angle), 1);
    }
}

TEST(RandomIntegers, FillTheirRangeEvenly) {
    families::detail::Rng rng(1);
    std::vector<int> counts(10, 0);
    for (int i = 0; i < 10000; ++i) ++counts[static_cast<std::size_t>(rng.between(-3, 6) + 3)];
    for (const int count : counts) {
        EXPECT_GT(count, 850);
        EXPECT_LT(count, 1150);
    }
}

TEST(AreDisjoint, TellsTouchingFromApart) {
    using families::detail::are_disjoint;
    using families::detail::box;
    EXPECT_TRUE(are_disjoint(box(0, 0, 2, 2), box(3, 0, 4, 2)));
    EXPECT_FALSE(are_disjoint(box(0, 0, 2, 2), box(2, 2, 4, 4)));    // a corner
    EXPECT_FALSE(are_disjoint(box(0, 0, 9, 9), box(3, 3, 4, 4)));    // inside
    EXPECT_FALSE(are_disjoint({{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}));  // segments that cross
    EXPECT_TRUE(are_disjoint({{0, 0}, {4, 4}}, {{3, 2}, {4, 0}}));
    EXPECT_TRUE(are_disjoint(box(0, 0, 2, 2), {{3, 0}, {2, 3}}));
    EXPECT_FALSE(are_disjoint(box(0, 0, 2, 2), {{3, 1}, {1, 3}}));  // through the corner
}

}  // namespace
}  // namespace sightline
