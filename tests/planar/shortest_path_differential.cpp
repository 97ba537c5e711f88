// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths against the brute-force twin: equal length, exactly, and the same choice among equals.
#include <gtest/gtest.h>

#include "sightline/arith/square_roots.hpp"
#include "sightline/planar/shortest_path.hpp"
#include "sightline/reference/shortest_path.hpp"
#include "support/arbitrary.hpp"
#include "support/corpus.hpp"
#include "support/exhaustive.hpp"
#include "support/paths.hpp"

namespace sightline {
namespace {

// Returns how many paths were compared.
int expect_equals_reference(const Scene2& scene, const RationalPoint2& from,
                            const RationalPoint2& to) {
    const auto actual = shortest_path(scene, from, to);
    const auto expected = reference::shortest_path(scene, from, to);
    EXPECT_EQ(actual ? "path" : name_of(actual.error().code),
              std::string(expected ? "path" : name_of(expected.error().code)));
    if (!actual || !expected) return 0;
    testing::expect_valid_path(scene, *actual, from, to);
    EXPECT_EQ(testing::to_string(*actual), testing::to_string(*expected));
    EXPECT_EQ(compare_sums_of_square_roots(testing::squared_lengths(*actual),
                                           testing::squared_lengths(*expected))
                  .sign,
              Sign::zero);
    EXPECT_EQ(actual->length, expected->length);
    return 1;
}

TEST(ShortestPath, equals_the_reference_on_random_scenes) {
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 700 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const Scene2 scene = *Scene2::make(input);
        std::mt19937_64 bits(seed);
        const auto number = [&bits] { return Rational(static_cast<int>(bits() % 15) - 1, 2); };
        for (int i = 0; i < 2; ++i) {
            const RationalPoint2 from{number(), number()};
            const RationalPoint2 to{number(), number()};
            SCOPED_TRACE("from " + testing::to_string(ViewPoint{from, false}) + " to " +
                         testing::to_string(ViewPoint{to, false}) + "\n" + testing::to_text(input));
            compared += expect_equals_reference(scene, from, to);
        }
    }
    EXPECT_GT(compared, 400);
}

TEST(ShortestPath, equals_the_reference_on_degenerate_scenes) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        if (name == "comb") continue;  // too many vertices for the twin
        const Scene2 scene = testing::scene2(text);
        const std::size_t n = scene.vertex_count();
        for (std::uint32_t i = 0; i < n; i += 2) {
            const RationalPoint2 from = to_rational(scene[VertexId{i}]);
            const RationalPoint2 to =
                to_rational(scene[VertexId{static_cast<std::uint32_t>((i + n / 2) % n)}]);
            SCOPED_TRACE(name + " from " + testing::to_string(ViewPoint{from, false}) + " to " +
                         testing::to_string(ViewPoint{to, false}));
            expect_equals_reference(scene, from, to);
        }
    }
}

TEST(ShortestPath, equals_the_reference_on_all_scenes_of_two_triangles) {
    for (const SceneInput2& input : testing::scenes_of_two_triangles(true)) {
        const Scene2 scene = *Scene2::make(input);
        for (int i = 0; i < 4; ++i) {  // between opposite points of the grid
            const RationalPoint2 from = to_rational(testing::grid_point(i));
            const RationalPoint2 to = to_rational(testing::grid_point(8 - i));
            SCOPED_TRACE("from " + testing::to_string(ViewPoint{from, false}) + " to " +
                         testing::to_string(ViewPoint{to, false}) + "\n" + testing::to_text(input));
            expect_equals_reference(scene, from, to);
        }
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace sightline
