// SPDX-License-Identifier: GPL-3.0-or-later
// The fast view against its brute-force twin: ring, needles and refusals.
#include <gtest/gtest.h>

#include <algorithm>

#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/reference/visibility_polygon.hpp"
#include "support/arbitrary.hpp"
#include "support/corpus.hpp"
#include "support/exhaustive.hpp"
#include "support/views.hpp"

namespace sightline {
namespace {

std::vector<reference::SeenSegment> exact_needles(const Scene2& scene,
                                                  const VisibilityPolygon& view) {
    std::vector<reference::SeenSegment> result;
    for (const Needle& needle : view.needles) {
        result.push_back({exact_point(scene, view.from, needle.near),
                          exact_point(scene, view.from, needle.far)});
    }
    std::sort(result.begin(), result.end());
    return result;
}

// Returns how many views were compared.
int expect_equals_reference(const Scene2& scene, const PointVisibility2& prepared,
                            const RationalPoint2& q) {
    const VisibilityPolygonOptions options{.needles = Needles::with_needles};
    const auto actual = prepared.from(q, options);
    const auto expected = reference::visibility_polygon(scene, q, options);
    EXPECT_EQ(actual.has_value(), expected.has_value());
    if (actual.has_value() != expected.has_value()) return 0;
    if (!actual) {
        EXPECT_EQ(actual.error().code, expected.error().code);
        return 0;
    }
    EXPECT_EQ(testing::to_string(exact_ring(scene, *actual)), testing::to_string(expected->ring));
    EXPECT_EQ(testing::to_string(exact_needles(scene, *actual)),
              testing::to_string(expected->needles));
    return 1;
}

// Points of the grid, between its lines, on edges, at vertices, and (for walls) at crossings.
std::vector<RationalPoint2> viewpoints(const Scene2& scene, std::uint64_t seed, int size) {
    std::mt19937_64 bits(seed);
    const auto below = [&bits](std::uint64_t n) { return static_cast<int>(bits() % n); };
    std::vector<RationalPoint2> points;
    for (int i = 0; i < 2; ++i) {
        points.push_back({Rational(below(size + 3U)) - 1, Rational(below(size + 3U)) - 1});
        points.push_back({Rational(below(2U * size + 3U), 2), Rational(below(2U * size + 3U), 2)});
        points.push_back({Rational(below(5U * size), 5), Rational(below(7U * size), 7)});
    }
    if (scene.edge_count() > 0) {
        const auto index = static_cast<std::uint32_t>(below(scene.edge_count()));
        const Edge2& e = scene[EdgeId{index}];
        const RationalPoint2 a = to_rational(scene[e.source]);
        const RationalPoint2 b = to_rational(scene[e.target]);
        points.push_back(a);
        points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
        points.push_back({(a.x + a.x + b.x) / 3, (a.y + a.y + b.y) / 3});
    }
    return points;
}

TEST(VisibilityPolygon, equals_the_reference_on_random_scenes) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 1500 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const Scene2 scene = *Scene2::make(input);
        const PointVisibility2 prepared(scene);
        for (const RationalPoint2& q : viewpoints(scene, seed, 2 + static_cast<int>(seed % 5))) {
            SCOPED_TRACE("from " + testing::to_string({q, false}) + "\n" + testing::to_text(input));
            compared += expect_equals_reference(scene, prepared, q);
        }
    }
    EXPECT_GT(compared, 5000);
}

TEST(VisibilityPolygon, equals_the_reference_on_degenerate_scenes) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        const Scene2 scene = testing::scene2(text);
        const PointVisibility2 prepared(scene);
        std::vector<RationalPoint2> points = viewpoints(scene, 1, 6);
        for (const Point2& v : scene.vertices()) points.push_back(to_rational(v));
        for (const RationalPoint2& q : points) {
            SCOPED_TRACE(name + " from " + testing::to_string({q, false}));
            expect_equals_reference(scene, prepared, q);
        }
    }
}

TEST(VisibilityPolygon, equals_the_reference_on_all_scenes_of_two_triangles) {
    for (const SceneInput2& input : testing::scenes_of_two_triangles(true)) {
        const Scene2 scene = *Scene2::make(input);
        const PointVisibility2 prepared(scene);
        for (int number = 0; number < 9; ++number) {
            const RationalPoint2 q = to_rational(testing::grid_point(number));
            SCOPED_TRACE("from " + testing::to_string({q, false}) + "\n" + testing::to_text(input));
            expect_equals_reference(scene, prepared, q);
        }
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace sightline
