// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "support/graphs.hpp"
#include "support/scenes.hpp"
#include "support/transforms.hpp"

namespace sightline {
namespace {

// The extension of a corner's edge is where its tangent directions begin; straight up is where the
// half-plane of greater vertices ends. Both at once, inside a triangle of the triangulation.
TEST(TangentGraphDegenerate, SeesAlongTheUpwardExtensionOfAnEdge) {
    const SceneInput2 input = testing::scene_input(
        "polygon 4 1, 5 1, 5 2, 4 2; point 4.5 3, 5.5 3, 5 6, 5 7, 4.5 0, 5.5 0, 5 -4");
    for (const bool every : {false, true}) {
        const VisibilityGraphOptions options{
            .collinear = every ? Collinear::every_vertex : Collinear::nearest_only,
            .tangent_only = true};
        const Scene2 scene = *Scene2::make(input);
        const VisibilityGraph graph = visibility_graph(scene, options);
        EXPECT_TRUE(graph.has_edge({2}, {6})) << "from the corner to the point above";
        EXPECT_EQ(graph.has_edge({2}, {7}), every);
        for (const auto& map : testing::exact_maps()) {
            const Scene2 moved = *Scene2::make(testing::mapped(input, map));
            EXPECT_TRUE(testing::same_graph(visibility_graph(moved, options),
                                            reference::visibility_graph(moved, options)));
        }
    }
}

}  // namespace
}  // namespace sightline
