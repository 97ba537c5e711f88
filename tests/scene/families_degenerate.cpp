// SPDX-License-Identifier: GPL-3.0-or-later
// The degenerate families are as degenerate as they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "scene/families2_detail.hpp"
#include "scene/families_support.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/families.hpp"

namespace sightline {
namespace {

using families_test::points_of;

std::size_t collinear_triples(const std::vector<Point2>& points) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                count += orientation(points[i], points[j], points[k]) == Sign::zero ? 1 : 0;
            }
        }
    }
    return count;
}

bool has_axis_parallel_edge(const SceneInput2& scene) {
    for (const SceneElement2& element : scene.elements) {
        const Ring2& ring = std::get<Polygon2>(element).outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2& p = ring[i];
            const Point2& q = ring[(i + 1) % ring.size()];
            if (p.x == q.x || p.y == q.y) return true;
        }
    }
    return false;
}

/// How many vertices lie at each place.
std::map<std::pair<double, double>, int> places(const SceneInput2& scene) {
    std::map<std::pair<double, double>, int> result;
    for (const Point2& p : points_of(scene)) ++result[{p.x, p.y}];
    return result;
}

std::size_t shared_places(const SceneInput2& scene) {
    const auto all = places(scene);
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](const auto& place) { return place.second > 1; }));
}

TEST(RotatedGrid, HasExactlyTheCollinearTriplesOfTheGrid) {
    const std::size_t straight = collinear_triples(points_of(families::grid({3, 4})));
    EXPECT_EQ(straight, 780U);
    for (const auto& [a, b] : {std::pair{3, 4}, {5, 12}, {8, 15}, {1, 7}}) {
        const SceneInput2 scene = families::rotated_grid({3, 4, a, b});
        EXPECT_EQ(collinear_triples(points_of(scene)), straight);
        EXPECT_FALSE(has_axis_parallel_edge(scene));
    }
}

TEST(Checkerboard, HasTwoVerticesAtEachInnerCorner) {
    const SceneInput2 scene = families::checkerboard({4, 4});
    EXPECT_EQ(scene.elements.size(), 8U);
    EXPECT_EQ(shared_places(scene), 9U);
}

TEST(TouchingChain, CornersShareOnePlaceALink) {
    const SceneInput2 scene = families::touching_chain({10, families::ChainKind::corners}, 3);
    EXPECT_EQ(scene.elements.size(), 10U);
    EXPECT_EQ(shared_places(scene), 9U);
}

TEST(TouchingChain, EdgesShareAPieceAndNoVertex) {
    const SceneInput2 scene = families::touching_chain({50, families::ChainKind::edges}, 3);
    EXPECT_EQ(shared_places(scene), 0U);
    for (std::size_t i = 1; i < scene.elements.size(); ++i) {
        const Ring2& left = std::get<Polygon2>(scene.elements[i - 1]).outer;
        const Ring2& right = std::get<Polygon2>(scene.elements[i]).outer;
        EXPECT_EQ(left[1].x, right[0].x);
        EXPECT_GT(std::min(left[2].y, right[3].y), std::max(left[1].y, right[0].y));
    }
}

TEST(TouchingChain, EachLinkTouchesTheNext) {
    for (const auto kind : {families::ChainKind::mixed, families::ChainKind::corners}) {
        const SceneInput2 scene = families::touching_chain({60, kind}, 8);
        families::detail::IntRing last;
        for (const SceneElement2& element : scene.elements) {
            families::detail::IntRing ring;
            for (const Point2& p : std::get<Polygon2>(element).outer) {
                ring.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)});
            }
            EXPECT_TRUE(families::detail::turns_left_everywhere(ring));
            if (!last.empty()) {
                EXPECT_FALSE(families::detail::are_disjoint(last, ring));
            }
            last = ring;
        }
    }
}

TEST(TouchingChain, RingIsAFrameOfUnitBoxes) {
    const SceneInput2 scene = families::touching_chain({13, families::ChainKind::ring}, 0);
    EXPECT_EQ(scene.elements.size(), 16U);  // round a square of 3 × 3
    std::map<std::pair<double, double>, int> corners;
    for (const SceneElement2& element : scene.elements) {
        const Point2& low = std::get<Polygon2>(element).outer.front();
        ++corners[{low.x, low.y}];
    }
    EXPECT_EQ(corners.size(), 16U);
    for (const auto& [corner, count] : corners) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(corner.first == 0 || corner.first == 4 || corner.second == 0 ||
                    corner.second == 4);
    }
}

TEST(Pinched, PassesThroughItsJointsTwice) {
    const SceneInput2 scene = families::pinched({5}, 1);
    const auto& polygon = std::get<Polygon2>(scene.elements.front());
    SceneInput2 ring_only;
    ring_only.elements.emplace_back(Polygon2{polygon.outer, {}});
    EXPECT_EQ(shared_places(ring_only), 4U);
    EXPECT_EQ(polygon.holes.size(), 5U);
}

double ulps_between(double a, double b) {
    const double next = std::nextafter(a, b);
    return a == b ? 0 : next == b ? 1 : 2;
}

TEST(NearCollinear, TipsAreWithinOneUlpOfTheLineAndNotAllOnIt) {
    const SceneInput2 scene = families::near_collinear({200}, 5);
    std::map<double, int> seen;
    for (const SceneElement2& element : scene.elements) {
        const auto* triangle = std::get_if<Polygon2>(&element);
        if (triangle == nullptr) continue;
        const Point2 tip = triangle->outer[2];
        const double ulps = ulps_between(tip.x / 3.0 + 1.0 / 7.0, tip.y);
        EXPECT_LE(ulps, 1);
        ++seen[ulps];
    }
    EXPECT_GT(seen[0], 20);
    EXPECT_GT(seen[1], 20);
    EXPECT_EQ(std::get<Polyline2>(scene.elements.back()).points.size(), 200U);
}

TEST(Slivers, AreOneUlpHigh) {
    for (const SceneElement2& element : families::slivers({100}, 5).elements) {
        const Ring2& ring = std::get<Polygon2>(element).outer;
        EXPECT_EQ(ring[0].y, ring[1].y);
        EXPECT_EQ(ulps_between(ring[0].y, ring[2].y), 1);
        EXPECT_EQ(orientation(ring[0], ring[1], ring[2]), Sign::positive);
    }
}

TEST(Collinear, AllIsOnOneLineThatIsNotParallelToAnAxis) {
    const Point2 a{0, 0};
    const Point2 b{7, 24};
    for (const SceneElement2& element : families::collinear_bodies({60}, 6).elements) {
        const Ring2& ring = std::get<Polygon2>(element).outer;
        EXPECT_EQ(orientation(a, b, ring[0]), Sign::zero);
        EXPECT_EQ(orientation(a, b, ring[1]), Sign::zero);
        EXPECT_NE(orientation(a, b, ring[2]), Sign::zero);
    }
    EXPECT_GT(shared_places(families::collinear_bodies({60}, 6)), 0U);
    for (const SceneInput2& scene :
         {families::collinear_points({60}, 6), families::collinear_walls({60}, 6)}) {
        for (const Point2& p : points_of(scene)) EXPECT_EQ(orientation(a, b, p), Sign::zero);
    }
    EXPECT_GT(shared_places(families::collinear_walls({60}, 6)), 0U);
    EXPECT_EQ(shared_places(families::collinear_points({60}, 6)), 0U);
}

TEST(Magnitudes, SpanFrom1em300To1e300) {
    const std::vector<Point2> points = points_of(families::magnitudes({1000}, 1));
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    EXPECT_LT(least->x, 1e-300);
    EXPECT_GT(least->x, 0);
    EXPECT_GT(greatest->x, 1e300);
}

/// Twice the area of the world less its holes.
double free_area(const Polygon2& world) {
    const auto area = [](const Ring2& ring) {
        double sum = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2& p = ring[i];
            const Point2& q = ring[(i + 1) % ring.size()];
            sum += p.x * q.y - p.y * q.x;
        }
        return sum;
    };
    double sum = std::abs(area(world.outer));
    for (const Ring2& hole : world.holes) sum -= std::abs(area(hole));
    return sum;
}

TEST(FloorPlan, HasOneRoomPerDivisionAndDoorsInAllWalls) {
    // A plan of one cell is one room of 7 × 7 within walls.
    const SceneInput2 closet = families::floor_plan({1, 1, true}, 1);
    const auto& room = std::get<Polygon2>(closet.elements.front());
    EXPECT_EQ(room.outer, (Ring2{{8, 1}, {8, 8}, {1, 8}, {1, 1}}));
    EXPECT_TRUE(room.holes.empty());
    // All rooms hang together: walls take 1 in 8 of the width, and nothing else was cut off as unreachable.
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const SceneInput2 plan = families::floor_plan({10, 10, true}, seed);
        const auto& world = std::get<Polygon2>(plan.elements.front());
        EXPECT_GE(free_area(world), 2 * 10 * 10 * 7 * 7);
        EXPECT_GT(world.outer.size() + world.holes.size(), 10U);
    }
}

TEST(FloorPlan, ThinWallsLeaveDoors) {
    const SceneInput2 plan = families::floor_plan({10, 10, false}, 4);
    EXPECT_TRUE(plan.world);
    EXPECT_EQ(std::get<Polygon2>(plan.elements.front()).outer.size(), 4U);
    EXPECT_GT(plan.elements.size(), 20U);
    for (std::size_t i = 1; i < plan.elements.size(); ++i) {
        const auto& wall = std::get<Polyline2>(plan.elements[i]).points;
        const Point2 step{wall[1].x - wall[0].x, wall[1].y - wall[0].y};
        EXPECT_TRUE((step.x == 0) != (step.y == 0));
        // Each wall ends at a door at one end at least: whole walls would be multiples of 8.
        EXPECT_NE(std::fmod(step.x + step.y, 8.0), 0.0);
    }
}

TEST(Cave, TurnsAtEveryVertexAndTouchesItselfSomewhere) {
    std::size_t touching = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const SceneInput2 scene = families::cave({40, 40}, seed);
        touching += shared_places(scene);
        const auto& world = std::get<Polygon2>(scene.elements.front());
        for (std::size_t i = 0; i < world.outer.size(); ++i) {
            const std::size_t n = world.outer.size();
            EXPECT_NE(
                orientation(world.outer[i], world.outer[(i + 1) % n], world.outer[(i + 2) % n]),
                Sign::zero);
        }
    }
    EXPECT_GT(touching, 0U);
}

}  // namespace
}  // namespace sightline
