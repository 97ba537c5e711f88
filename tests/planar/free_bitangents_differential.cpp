// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/free_bitangents.hpp"
#include "sightline/reference/bitangents.hpp"
#include "support/arbitrary.hpp"
#include "support/bitangents.hpp"
#include "support/corpus.hpp"
#include "support/exhaustive.hpp"

namespace sightline {
namespace {

::testing::AssertionResult agrees(const Scene2& scene) {
    for (const bool one_body : {false, true}) {
        const FreeBitangentOptions options{.one_body = one_body};
        const auto result = testing::same_bitangents(free_bitangents(scene, options),
                                                     reference::free_bitangents(scene, options));
        if (!result) return result;
    }
    return ::testing::AssertionSuccess();
}

TEST(FreeBitangentsDifferential, AgreeOnTheCorpus) {
    for (const auto& [name, text] : testing::degenerate_scenes())
        EXPECT_TRUE(agrees(testing::scene2(text))) << name;
}

TEST(FreeBitangentsDifferential, AgreeOnRandomScenes) {
    for (std::uint64_t seed = 0; seed < 2500 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        EXPECT_TRUE(agrees(*Scene2::make(input))) << "seed " << seed << "\n"
                                                  << testing::to_text(input);
    }
}

TEST(FreeBitangentsExhaustive, AgreeOnAllPairsOfTrianglesOnAGrid) {
    const auto scenes = testing::scenes_of_two_triangles(true);
    EXPECT_GT(scenes.size(), 50U);
    for (const SceneInput2& input : scenes)
        EXPECT_TRUE(agrees(*Scene2::make(input))) << testing::to_text(input);
}

}  // namespace
}  // namespace sightline
