// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the skeleton, on scenes too large for brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sightline/scene/families3.hpp"
#include "sightline/skeleton/build.hpp"
#include "support/arbitrary3.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

VisibilitySkeleton swept(const Scene3& scene) { return visibility_skeleton(scene); }

class LargerSkeleton : public ::testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] static SceneInput3 input() { return testing::scene_input3(GetParam()); }
};

TEST_P(LargerSkeleton, IsCanonical) { testing::expect_canonical(swept(testing::scene3(input()))); }

TEST_P(LargerSkeleton, MotionsChangeNothing) {
    testing::expect_motions_change_nothing(input(), swept);
}

TEST_P(LargerSkeleton, OrderChangesNamesOnly) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        testing::expect_order_changes_names_only(input(), seed, swept);
    }
}

TEST_P(LargerSkeleton, FilteredAndThreadedEqualExact) {
    const Scene3 scene = testing::scene3(input());
    SkeletonOptions exact;
    exact.arithmetic = Arithmetic::exact;
    EXPECT_TRUE(testing::same_skeleton(swept(scene), visibility_skeleton(scene, exact)));
    SkeletonOptions threaded;
    threaded.threads = 4;
    EXPECT_TRUE(testing::same_skeleton(visibility_skeleton(scene, threaded), swept(scene)));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LargerSkeleton,
    ::testing::Values("family tetrahedra 6", "family boxes 4", "family stack 4",
                      "family grid3 2 2 2", "family checkerboard3 2 2 2", "family chain3 5",
                      "family touching-box-on-table",
                      "family u-shape; box 5 0 0, 6 2 1; sheet 3 3 3, 5 4 3, 4 5 6"),
    [](const auto& test) { return "Scene" + std::to_string(test.index); });

/// Every coordinate up or down by one unit in the last place, or kept.
SceneInput3 nudged(SceneInput3 input, std::uint64_t seed) {
    std::mt19937_64 bits(seed);
    const auto nudge = [&](double& x) {
        const std::uint64_t choice = bits() % 3;
        const double infinity = std::numeric_limits<double>::infinity();
        x += 1;  // next to 0 all is denormal
        if (choice == 1) x = std::nextafter(x, infinity);
        if (choice == 2) x = std::nextafter(x, -infinity);
    };
    for (MeshInput3& mesh : input.meshes) {
        for (Point3& p : mesh.vertices) {
            nudge(p.x);
            nudge(p.y);
            nudge(p.z);
        }
    }
    return input;
}

/// Tetrahedra of a grid, moved by one unit in the last place: signs that the filter cannot know, and no degeneracy
/// left.
TEST(VisibilitySkeletonLaws, NearDegenerateScenesEqualTheReference) {
    int valid = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        testing::Scene3Recipe recipe{.grid = 3, .bodies = 2, .touching = false};
        const auto input = nudged(testing::Scene3Lottery(seed, recipe).draw(), seed);
        const auto scene = Scene3::make(input);
        if (!scene) continue;
        ++valid;
        EXPECT_TRUE(testing::equals_reference(*scene, swept)) << testing::to_text(input);
    }
    EXPECT_GT(valid, 25);
}

}  // namespace
}  // namespace sightline
