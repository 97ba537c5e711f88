// SPDX-License-Identifier: GPL-3.0-or-later
// The fast graph against its brute-force twin.
#include <gtest/gtest.h>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "support/arbitrary.hpp"
#include "support/corpus.hpp"
#include "support/exhaustive.hpp"
#include "support/visibility_graph_laws.hpp"

namespace sightline {
namespace {

void expect_equals_reference(const SceneInput2& input, const VisibilityGraphOptions& options) {
    const Scene2 scene = *Scene2::make(input);
    EXPECT_TRUE(testing::same_graph(visibility_graph(scene, options),
                                    reference::visibility_graph(scene, options)))
        << testing::to_string(options) << "\n"
        << testing::to_text(input);
}

TEST(VisibilityGraph, equals_the_reference_on_random_scenes) {
    const auto options = testing::graph_options();
    for (std::uint64_t seed = 0; seed < 10000 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        expect_equals_reference(input, options[0]);
        expect_equals_reference(input, options[1 + seed % (options.size() - 1)]);
    }
}

TEST(VisibilityGraph, equals_the_reference_on_degenerate_scenes) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        SCOPED_TRACE(name);
        for (const auto& options : testing::graph_options()) {
            expect_equals_reference(testing::scene_input(text), options);
        }
    }
}

}  // namespace
}  // namespace sightline
