// SPDX-License-Identifier: GPL-3.0-or-later
// The reference view against an outside opinion, and against the law of free segments itself.
#include <gtest/gtest.h>

#include "sightline/reference/free_segment.hpp"
#include "sightline/reference/visibility_polygon.hpp"
#include "sightline/reference/visibility_polygon_cgal.hpp"
#include "support/arbitrary.hpp"
#include "support/views.hpp"

namespace sightline {
namespace {

// Boxes in the cells of a grid, some of them, with corners in line; nothing touches.
SceneInput2 world_of_boxes(std::uint64_t seed) {
    std::mt19937_64 bits(seed);
    SceneInput2 input;
    input.world = true;
    Polygon2 world{{{0, 0}, {16, 0}, {16, 16}, {0, 16}}, {}};
    for (int cell = 0; cell < 16; ++cell) {
        const double x = 4 * (cell % 4) + 1;
        const double y = 4 * (cell / 4) + 1;
        if (bits() % 2 == 0)
            world.holes.push_back({{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}});
        if (bits() % 4 == 0) world.outer = {{0, 0}, {16, 0}, {16, 16}, {3.5, 15.5}, {0, 16}};
    }
    input.elements.emplace_back(world);
    return input;
}

TEST(ReferenceView, agrees_with_triangular_expansion) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const SceneInput2 input = world_of_boxes(seed);
        const Scene2 scene = *Scene2::make(input);
        const auto x = static_cast<long>(seed % 16);
        const RationalPoint2 q{Rational(x) + *Rational::parse("1/3"),
                               Rational(4) * (x % 3) + Rational(1, 7)};
        const auto view = reference::visibility_polygon(scene, q);
        ASSERT_TRUE(view.has_value());
        EXPECT_EQ(testing::to_string(view->ring),
                  testing::to_string(reference::cgal_visibility_ring(scene, q)))
            << testing::to_text(input);
    }
}

// Even-odd test of a point against a bounded ring that does not pass through it.
bool is_in_ring(const std::vector<ViewPoint>& ring, const RationalPoint2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint2& a = ring[i].coordinates;
        const RationalPoint2& b = ring[(i + 1) % ring.size()].coordinates;
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const Rational x = a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
        if (p.x < x) inside = !inside;
    }
    return inside;
}

// A point off all lines of the scene is in the polygon exactly when the segment to it is free.
TEST(ReferenceView, holds_what_free_segments_reach) {
    std::uint64_t seen = 0;
    std::uint64_t hidden = 0;
    for (std::uint64_t seed = 0; seed < 300 && !HasFailure(); seed += 3) {
        const SceneInput2 input = testing::random_scene(seed);  // with a world
        const Scene2 scene = *Scene2::make(input);
        const RationalPoint2 q{Rational(static_cast<int>(seed % 3)),
                               Rational(static_cast<int>(seed % 5))};
        const auto view = reference::visibility_polygon(scene, q);
        if (!view) continue;
        for (int i = 0; i < 40; ++i) {
            const RationalPoint2 p{Rational(i % 7) + Rational(17, 1009),
                                   Rational(i % 6) + Rational(31, 997)};
            const bool is_free = reference::is_free(scene, q, p);
            EXPECT_EQ(is_in_ring(view->ring, p), is_free)
                << testing::to_text(input) << i << ": " << testing::to_string(view->ring);
            ++(is_free ? seen : hidden);
        }
    }
    EXPECT_GT(seen, 200U);
    EXPECT_GT(hidden, 200U);
}

}  // namespace
}  // namespace sightline
