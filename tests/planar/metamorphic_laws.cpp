// SPDX-License-Identifier: GPL-3.0-or-later
// Moving, scaling, turning, mirroring or renumbering a scene moves, scales, … what is seen and walked.
#include <gtest/gtest.h>

#include "sightline/arith/square_roots.hpp"
#include "sightline/planar/shortest_path.hpp"
#include "sightline/reference/visibility_polygon.hpp"
#include "support/arbitrary.hpp"
#include "support/paths.hpp"
#include "support/transforms.hpp"
#include "support/views.hpp"

namespace sightline {
namespace {

// (x, y) -> (a x + b y + e, c x + d y + f); exact on small integers, and axes go to axes.
struct Motion {
    double a, b, c, d, e, f;

    [[nodiscard]] Point2 operator()(const Point2& p) const {
        return {a * p.x + b * p.y + e, c * p.x + d * p.y + f};
    }
    [[nodiscard]] RationalPoint2 linear(const RationalPoint2& p) const {
        return {Rational(a) * p.x + Rational(b) * p.y, Rational(c) * p.x + Rational(d) * p.y};
    }
    [[nodiscard]] RationalPoint2 operator()(const RationalPoint2& p) const {
        const RationalPoint2 q = linear(p);
        return {q.x + Rational(e), q.y + Rational(f)};
    }
    [[nodiscard]] bool mirrors() const { return a * d - b * c < 0; }
};

const Motion motions[] = {
    {1, 0, 0, 1, 1024, -512},              // translation
    {0x1p-40, 0, 0, 0x1p-40, 0, 0},        // smaller
    {0x1p+90, 0, 0, 0x1p+90, 0x1p+92, 0},  // larger, elsewhere
    {-1, 0, 0, 1, 0, 0},                   // mirror
    {0, -1, 1, 0, 0, 0},                   // quarter turn
    {0, 1, 1, 0, 3, 0},                    // mirror at the diagonal, and moved
};

std::vector<ViewPoint> moved(std::vector<ViewPoint> ring, const Motion& motion) {
    for (ViewPoint& p : ring)
        p = p.at_infinity ? reference::at_infinity(motion.linear(p.coordinates))
                          : ViewPoint{motion(p.coordinates), false};
    if (motion.mirrors()) std::reverse(ring.begin(), ring.end());
    return reference::canonical_ring(std::move(ring));
}

RationalPoint2 random_point(std::uint64_t seed) {
    return {Rational(static_cast<int>(seed * 7 % 23)) / Rational(3),
            Rational(static_cast<int>(seed * 5 % 19)) / Rational(2)};
}

TEST(VisibilityPolygonLaws, moves_with_the_scene) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const Scene2 scene = *Scene2::make(input);
        const RationalPoint2 q = random_point(seed);
        const auto view = visibility_polygon(scene, q);
        const Motion& motion = motions[seed % std::size(motions)];
        const Scene2 other =
            *Scene2::make(testing::mapped(input, [&](const Point2& p) { return motion(p); }));
        const auto other_view = visibility_polygon(other, motion(q));
        SCOPED_TRACE("from " + testing::to_string({q, false}) + "\n" + testing::to_text(input));
        ASSERT_EQ(view.has_value(), other_view.has_value());
        if (!view) {
            EXPECT_EQ(view.error().code, other_view.error().code);
            continue;
        }
        ++compared;
        EXPECT_EQ(testing::to_string(exact_ring(other, *other_view)),
                  testing::to_string(moved(exact_ring(scene, *view), motion)));
    }
    EXPECT_GT(compared, 150);
}

TEST(ShortestPathLaws, moves_with_the_scene) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const RationalPoint2 p = random_point(seed);
        const RationalPoint2 q = random_point(seed + 11);
        const auto path = shortest_path(*Scene2::make(input), p, q);
        const Motion& motion = motions[seed % std::size(motions)];
        const Scene2 other =
            *Scene2::make(testing::mapped(input, [&](const Point2& v) { return motion(v); }));
        const auto other_path = shortest_path(other, motion(p), motion(q));
        SCOPED_TRACE(testing::to_text(input));
        ASSERT_EQ(path.has_value(), other_path.has_value());
        if (!path) {
            EXPECT_EQ(path.error().code, other_path.error().code);
            continue;
        }
        ++compared;
        EXPECT_EQ(path->vertices, other_path->vertices);
        for (std::size_t i = 0; i < path->points.size(); ++i)
            EXPECT_EQ(motion(path->points[i]), other_path->points[i]);
    }
    EXPECT_GT(compared, 100);
}

TEST(ShortestPathLaws, is_as_long_backwards_and_renumbered) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 200 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const Scene2 scene = *Scene2::make(input);
        const RationalPoint2 p = random_point(seed);
        const RationalPoint2 q = random_point(seed + 11);
        const auto path = shortest_path(scene, p, q);
        const auto back = shortest_path(scene, q, p);
        const auto renumbered =
            shortest_path(*Scene2::make(testing::with_elements_reversed(input).input), p, q);
        SCOPED_TRACE(testing::to_text(input));
        ASSERT_EQ(path.has_value(), back.has_value());
        ASSERT_EQ(path.has_value(), renumbered.has_value());
        if (!path) continue;
        ++compared;
        const auto length = testing::squared_lengths(*path);
        EXPECT_EQ(compare_sums_of_square_roots(length, testing::squared_lengths(*back)).sign,
                  Sign::zero);
        EXPECT_EQ(compare_sums_of_square_roots(length, testing::squared_lengths(*renumbered)).sign,
                  Sign::zero);
    }
    EXPECT_GT(compared, 70);
}

}  // namespace
}  // namespace sightline
