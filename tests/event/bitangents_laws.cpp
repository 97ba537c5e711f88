// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "sightline/event/bitangents.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/families.hpp"
#include "support/arbitrary.hpp"
#include "support/bitangents.hpp"
#include "support/transforms.hpp"

namespace sightline {
namespace {

// Number 3 and 4 of exact_maps() are mirror images.
constexpr std::size_t first_mirror = 3;
constexpr std::size_t last_mirror = 4;

std::vector<Bitangent> all_of(const SceneInput2& input) {
    return bitangents(*Scene2::make(input), {.one_body = true});
}

RC_GTEST_PROP(BitangentsLaws, EachComesInBothDirections, (const SceneInput2& input)) {
    testing::expect_both_directions(all_of(input));
    RC_ASSERT(!::testing::Test::HasFailure());
}

RC_GTEST_PROP(BitangentsLaws, TheirTextsGiveThemBack, (const SceneInput2& input)) {
    for (const Bitangent& b : all_of(input)) RC_ASSERT(*bitangent_from_text(to_string(b)) == b);
}

TEST(BitangentsLaws, MotionsChangeNothingAndMirrorsExchangeTheSides) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const auto all = all_of(input);
        const auto maps = testing::exact_maps();
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const bool mirror = i >= first_mirror && i <= last_mirror;
            EXPECT_TRUE(testing::same_bitangents(all_of(testing::mapped(input, maps[i])),
                                                 mirror ? testing::mirrored(all) : all))
                << "map " << i << "\n"
                << testing::to_text(input);
        }
    }
}

TEST(BitangentsLaws, TheOrderOfTheElementsChangesNamesOnly) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        const auto renumbered = testing::with_elements_reversed(input);
        const Scene2 renamed = *Scene2::make(renumbered.input);
        std::vector<BodyId> body(renamed.vertex_count());
        for (const Edge2& e : renamed.edges()) body[e.source.index()] = e.body;
        auto expected = all_of(input);
        for (Bitangent& b : expected) {
            b.source = renumbered.image[b.source.index()];
            b.target = renumbered.image[b.target.index()];
            b.source_body = body[b.source.index()];
            b.target_body = body[b.target.index()];
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_TRUE(testing::same_bitangents(bitangents(renamed, {.one_body = true}), expected))
            << testing::to_text(input);
    }
}

// Any two disjoint convex bodies have an LL, an RR, an LR and an RL in each direction.
TEST(BitangentsLaws, DisjointConvexBodiesHaveFourAPair) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Scene2 scene =
            *Scene2::make(families::random_convex({.vertices = 120, .world = false}, seed));
        const auto all = bitangents(scene);
        const std::size_t n = scene.body_count();
        EXPECT_EQ(all.size(), 4 * n * (n - 1));
        std::map<std::pair<BodyId, BodyId>, std::multiset<std::string>> types;
        for (const Bitangent& b : all) types[{b.source_body, b.target_body}].insert(b.type());
        EXPECT_EQ(types.size(), n * (n - 1));
        for (const auto& [pair, set] : types)
            EXPECT_EQ(set, (std::multiset<std::string>{"LL", "LR", "RL", "RR"}));
    }
}

// What the sides promise: a convex body lies wholly on the side named.
TEST(BitangentsLaws, ConvexBodiesLieOnTheSideThatIsNamed) {
    const Scene2 scene =
        *Scene2::make(families::random_convex({.vertices = 60, .world = false}, 7));
    for (const Bitangent& b : bitangents(scene, {.one_body = true})) {
        for (const Edge2& e : scene.edges()) {
            const Sign side = orientation(scene[b.source], scene[b.target], scene[e.source]);
            const auto wrong = [](Side named) {
                return named == Side::left ? Sign::negative : Sign::positive;
            };
            if (e.body == b.source_body) {
                EXPECT_NE(side, wrong(b.source_side)) << b;
            }
            if (e.body == b.target_body) {
                EXPECT_NE(side, wrong(b.target_side)) << b;
            }
        }
    }
}

// A bitangent of two bodies supports the one, seen from its contact with the other.
TEST(BitangentsLaws, AreSupportingLinesFromTheirContacts) {
    const Scene2 scene =
        *Scene2::make(families::random_convex({.vertices = 40, .world = false}, 5));
    for (const Bitangent& b : bitangents(scene)) {
        const auto lines = supporting_lines(scene, b.target_body, scene[b.source]);
        EXPECT_EQ(lines.size(), 2U);
        const SupportingLine2 line{b.target, b.target_body, b.target_side, scene[b.source]};
        EXPECT_NE(std::find(lines.begin(), lines.end(), line), lines.end()) << b;
    }
}

}  // namespace
}  // namespace sightline
