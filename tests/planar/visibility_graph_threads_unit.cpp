// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/families.hpp"

namespace sightline {
namespace {

// Few places with many edges each: all threads count and place edges at the same time, close to each other.
TEST(VisibilityGraphThreads, DoNotChangeAGraphOfManyEdges) {
    const Scene2 scene =
        Scene2::make(
            families::random_convex({.vertices = 3000, .density = families::Density::sparse}, 1))
            .value();
    for (const bool tangent_only : {false, true}) {
        const VisibilityGraph expected = visibility_graph(scene, {.tangent_only = tangent_only});
        for (unsigned i = 0; i < 8; ++i) {
            const VisibilityGraphOptions options{.tangent_only = tangent_only,
                                                 .threads = 2 + i % 3};
            ASSERT_TRUE(visibility_graph(scene, options) == expected)
                << "attempt " << i << ", " << options.threads << " threads";
        }
    }
}

}  // namespace
}  // namespace sightline
