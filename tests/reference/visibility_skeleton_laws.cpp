// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

VisibilitySkeleton twin(const Scene3& scene) { return reference::visibility_skeleton(scene); }

class SmallSkeleton3 : public ::testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] static SceneInput3 input() {
        return testing::scene_input3(testing::degenerate_scenes3().at(GetParam()));
    }
};

TEST_P(SmallSkeleton3, IsCanonical) { testing::expect_canonical(twin(testing::scene3(input()))); }

TEST_P(SmallSkeleton3, MotionsChangeNothing) {
    testing::expect_motions_change_nothing(input(), twin);
}

TEST_P(SmallSkeleton3, OrderChangesNamesOnly) {
    testing::expect_order_changes_names_only(input(), 1, twin);
}

INSTANTIATE_TEST_SUITE_P(Corpus, SmallSkeleton3,
                         ::testing::Values("tetrahedron", "octahedron", "l_shape", "triangle",
                                           "two_parallel_triangles", "touching_face",
                                           "touching_edge", "touching_vertex_on_face",
                                           "touching_edge_crossing", "edges_on_a_line",
                                           "faces_in_a_plane"),
                         [](const auto& test) { return std::string(test.param); });

class RandomSkeleton3 : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomSkeleton3, MotionsChangeNothing) {
    testing::expect_motions_change_nothing(testing::random_scene3(GetParam()), twin);
}

TEST_P(RandomSkeleton3, OrderChangesNamesOnly) {
    testing::expect_order_changes_names_only(testing::random_scene3(GetParam()), GetParam(), twin);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSkeleton3,
                         ::testing::Values(3U, 10U, 11U, 13U, 17U, 24U, 28U, 31U, 38U));

}  // namespace
}  // namespace sightline
