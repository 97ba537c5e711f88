// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/event/bitangents.hpp"
#include "sightline/reference/bitangents.hpp"
#include "sightline/scene/locate2.hpp"
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

// A point in free space that joins the scene has the supporting lines through it as bitangents.
TEST(SupportingLinesDifferential, AreBitangentsOfAPoint) {
    std::size_t lines = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Scene2 scene = *Scene2::make(testing::random_scene(seed));
        for (const Point2 p : {Point2{0.5, 1}, Point2{2, 1.5}, Point2{-1, 2}, Point2{1, 4}}) {
            const Location2 at = locate(scene, p);
            if (at.kind != PlaceKind2::free || !at.edge.is_none() || !at.vertex.is_none()) continue;
            const std::vector<Point2> added{p};
            const auto all = bitangents(*scene.with_points(added));
            const VertexId point{static_cast<std::uint32_t>(scene.vertex_count())};
            for (std::uint32_t body = 0; body < scene.body_count(); ++body) {
                std::vector<SupportingLine2> expected;
                for (const Bitangent& b : all) {
                    if (b.source == point && b.target_body == BodyId{body})
                        expected.push_back({b.target, b.target_body, b.target_side, p});
                }
                EXPECT_EQ(supporting_lines(scene, {body}, p), expected)
                    << p << " " << to_string(BodyId{body}) << "\n"
                    << testing::to_text(testing::random_scene(seed));
                lines += expected.size();
            }
        }
    }
    EXPECT_GT(lines, 500U);
}

}  // namespace
}  // namespace sightline
