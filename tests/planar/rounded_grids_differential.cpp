// SPDX-License-Identifier: GPL-3.0-or-later
// Grids turned and rounded: rows of corners that are within an ulp of one line, where a filter whose
// bound is too small decides wrongly.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/transform2.hpp"
#include "support/visibility_graph_laws.hpp"

namespace sightline {
namespace {

TEST(VisibilityGraph, equals_the_reference_on_rounded_grids) {
    std::size_t wrong_in_doubles = 0;
    for (const double degrees : {30.0, 17.3, 45.0, 81.0}) {
        const std::vector<std::string> size{"6"};
        const SceneInput2 grid = *families::generate2("grid", size, 1);
        const auto turned = families::transformed(grid, families::ApproxRotation{degrees});
        ASSERT_TRUE(turned);
        const Scene2 scene = *Scene2::make(*turned);
        const VisibilityGraphOptions options{.collinear = Collinear::every_vertex};
        const VisibilityGraph expected = reference::visibility_graph(scene, options);
        EXPECT_TRUE(testing::same_graph(visibility_graph(scene, options), expected)) << degrees;
        const VisibilityGraph in_doubles = visibility_graph(
            scene, {.collinear = Collinear::every_vertex, .arithmetic = Arithmetic::double_});
        wrong_in_doubles += in_doubles != expected ? 1 : 0;
    }
    EXPECT_GT(wrong_in_doubles, 0U) << "else these scenes test no filter";
}

}  // namespace
}  // namespace sightline
