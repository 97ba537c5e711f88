// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep against the definition by brute force, on more than a thousand random scenes of small integer
// coordinates, where most things that can coincide do.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "sightline/skeleton/build.hpp"
#include "support/arbitrary3.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

VisibilitySkeleton swept(const Scene3& scene) { return visibility_skeleton(scene); }

/// Seeds first … first + count - 1, on grids of 2 to 6.
void expect_same(testing::Scene3Recipe recipe, std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        recipe.grid = 2 + static_cast<int>(seed % 5);
        const SceneInput3 input = testing::Scene3Lottery(seed, recipe).draw();
        ASSERT_TRUE(testing::equals_reference(testing::scene3(input), swept))
            << "seed " << seed << '\n'
            << testing::to_text(input);
    }
}

TEST(VisibilitySkeletonDifferential, SingleBodies) {
    expect_same({.bodies = 1, .boxes = true}, 0, 350);
}

TEST(VisibilitySkeletonDifferential, TetrahedraApart) {
    expect_same({.bodies = 2, .touching = false}, 0, 130);
}

TEST(VisibilitySkeletonDifferential, TetrahedraThatMayTouch) { expect_same({.bodies = 2}, 0, 180); }

TEST(VisibilitySkeletonDifferential, BoxesThatMayTouch) {
    expect_same({.bodies = 2, .boxes = true}, 0, 40);
}

TEST(VisibilitySkeletonDifferential, TetrahedraAndTriangles) {
    expect_same({.bodies = 2, .sheets = true}, 0, 100);
}

TEST(VisibilitySkeletonDifferential, TrianglesApart) {
    expect_same({.bodies = 2, .solids = false}, 0, 200);
    expect_same({.bodies = 3, .solids = false}, 1000, 30);
}

TEST(VisibilitySkeletonDifferential, TrianglesThatJoinBodiesAndEachOther) {
    expect_same({.bodies = 2, .sheets = true, .joined = true}, 90, 20);
    expect_same({.bodies = 2, .joined = true, .solids = false}, 240, 40);
}

TEST(VisibilitySkeletonDifferential, TheMixture) {
    std::vector<std::uint64_t> seeds(18);
    std::iota(seeds.begin(), seeds.end(), std::uint64_t{0});
    // Where samples fall on a contact; where rarer contacts divide arcs.
    for (const std::uint64_t rare : {434U, 461U, 476U, 762U, 896U}) seeds.push_back(rare);
    for (const std::uint64_t seed : seeds) {
        const SceneInput3 input = testing::random_scene3(seed);
        ASSERT_TRUE(testing::equals_reference(testing::scene3(input), swept)) << "seed " << seed;
    }
}

}  // namespace
}  // namespace sightline
