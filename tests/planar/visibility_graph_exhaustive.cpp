// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "support/exhaustive.hpp"
#include "support/scenes.hpp"
#include "support/visibility_graph_laws.hpp"

namespace sightline {
namespace {

// All pairs of triangles: which corners and edges touch, and how, is all here.
TEST(VisibilityGraph, equals_the_reference_on_all_scenes_of_two_triangles) {
    const auto scenes = testing::scenes_of_two_triangles();
    EXPECT_GT(scenes.size(), 500U);
    for (const SceneInput2& input : scenes) {
        const Scene2 scene = *Scene2::make(input);
        for (const VisibilityGraphOptions& options : testing::graph_options()) {
            ASSERT_TRUE(testing::same_graph(visibility_graph(scene, options),
                                            reference::visibility_graph(scene, options)))
                << testing::to_string(options) << "\n"
                << testing::to_text(input);
        }
    }
}

}  // namespace
}  // namespace sightline
