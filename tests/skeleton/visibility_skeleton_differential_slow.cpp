// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep against brute force on larger random scenes, and on many more.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "sightline/skeleton/build.hpp"
#include "support/arbitrary3.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

class VisibilitySkeletonMixture : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(VisibilitySkeletonMixture, EqualsTheReference) {
    for (std::uint64_t seed = GetParam(); seed < GetParam() + 50; ++seed) {
        const SceneInput3 input = testing::random_scene3(seed);
        ASSERT_TRUE(testing::equals_reference(
            testing::scene3(input), [](const Scene3& scene) { return visibility_skeleton(scene); }))
            << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, VisibilitySkeletonMixture,
                         ::testing::Range(std::uint64_t{20}, std::uint64_t{1020},
                                          std::uint64_t{50}));

// Where three sheets join, several free segments of an event's line may contain an arc's limit; the reference
// gives such scenes up by its own audit instead of choosing one.
TEST(VisibilitySkeletonJoined, EqualsTheReferenceWhereThatDecides) {
    std::vector<std::uint64_t> given_up;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const testing::Scene3Recipe recipe{
            .grid = 2 + static_cast<int>(seed % 5), .sheets = true, .joined = true};
        const SceneInput3 input = testing::Scene3Lottery(seed, recipe).draw();
        try {
            ASSERT_TRUE(testing::equals_reference(
                testing::scene3(input),
                [](const Scene3& scene) { return visibility_skeleton(scene); }))
                << "seed " << seed;
        } catch (const ContractViolation&) {
            given_up.push_back(seed);
        }
    }
    EXPECT_LE(given_up.size(), 8u) << "two in a hundred";
}

}  // namespace
}  // namespace sightline
