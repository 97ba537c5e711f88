// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/event/bitangents.hpp"
#include "sightline/planar/free_bitangents.hpp"
#include "sightline/reference/free_segment.hpp"
#include "sightline/scene/families.hpp"
#include "support/arbitrary.hpp"
#include "support/bitangents.hpp"
#include "support/transforms.hpp"

namespace sightline {
namespace {

std::vector<FreeBitangent> all_of(const SceneInput2& input) {
    return free_bitangents(*Scene2::make(input));
}

TEST(FreeBitangentsLaws, AreBitangentsWithAFreeSegmentInBothDirections) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const Scene2 scene = *Scene2::make(testing::random_scene(seed));
        const auto all = bitangents(scene, {.one_body = true});
        const auto free = free_bitangents(scene);
        testing::expect_both_directions(free);
        EXPECT_TRUE(std::includes(all.begin(), all.end(), free.begin(), free.end()));
        for (const Bitangent& b : free)
            EXPECT_TRUE(reference::is_free(scene, b.source, b.target)) << b;
    }
}

TEST(FreeBitangentsLaws, MotionsChangeNothingAndMirrorsExchangeTheSides) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const auto all = all_of(input);
        const auto maps = testing::exact_maps();
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const bool mirror = i == 3 || i == 4;
            EXPECT_TRUE(testing::same_bitangents(all_of(testing::mapped(input, maps[i])),
                                                 mirror ? testing::mirrored(all) : all))
                << "map " << i << "\n"
                << testing::to_text(input);
        }
    }
}

TEST(FreeBitangentsLaws, ThreadsChangeNothing) {
    const Scene2 scene = *Scene2::make(families::grid({.columns = 6, .rows = 6}));
    EXPECT_TRUE(
        testing::same_bitangents(free_bitangents(scene, {.threads = 2}), free_bitangents(scene)));
}

// Alone in the plane, two convex bodies hide nothing of each other's bitangents.
TEST(FreeBitangentsLaws, TwoConvexBodiesAloneHaveAllFourFree) {
    std::size_t tried = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Scene2 scene =
            *Scene2::make(families::random_convex({.vertices = 12, .world = false}, seed));
        if (scene.body_count() != 2) continue;
        ++tried;
        EXPECT_EQ(free_bitangents(scene, {.one_body = false}), bitangents(scene));
        EXPECT_EQ(bitangents(scene).size(), 8U);
    }
    EXPECT_GT(tried, 20U);
}

}  // namespace
}  // namespace sightline
