// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/event/bitangents.hpp"
#include "sightline/reference/bitangents.hpp"
#include "support/arbitrary.hpp"
#include "support/bitangents.hpp"
#include "support/corpus.hpp"
#include "support/exhaustive.hpp"

namespace sightline {
namespace {

::testing::AssertionResult agrees(const Scene2& scene) {
    for (const bool one_body : {false, true}) {
        const auto result =
            testing::same_bitangents(bitangents(scene, {.one_body = one_body}),
                                     reference::bitangents(scene, {.one_body = one_body}));
        if (!result) return result;
    }
    return ::testing::AssertionSuccess();
}

TEST(BitangentsDifferential, AgreeOnTheCorpus) {
    for (const auto& [name, text] : testing::degenerate_scenes())
        EXPECT_TRUE(agrees(testing::scene2(text))) << name;
}

TEST(BitangentsDifferential, AgreeOnRandomScenes) {
    for (std::uint64_t seed = 0; seed < 2500 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        EXPECT_TRUE(agrees(*Scene2::make(input))) << "seed " << seed << "\n"
                                                  << testing::to_text(input);
    }
}

TEST(BitangentsExhaustive, AgreeOnAllPairsOfTrianglesOnAGrid) {
    const auto scenes = testing::scenes_of_two_triangles(true);
    EXPECT_GT(scenes.size(), 50U);
    for (const SceneInput2& input : scenes) {
        const Scene2 scene = *Scene2::make(input);
        EXPECT_TRUE(agrees(scene)) << testing::to_text(input);
    }
}

}  // namespace
}  // namespace sightline
