// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "sightline/planar/visibility_graph.hpp"
#include "support/arbitrary.hpp"
#include "support/corpus.hpp"
#include "support/visibility_graph_laws.hpp"

namespace sightline {
namespace {

VisibilityGraph build(const Scene2& scene, const VisibilityGraphOptions& options) {
    return visibility_graph(scene, options);
}

TEST(VisibilityGraphLaws, hold_on_the_corpus) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        if (name == "thinnest_needle" || name == "one_ulp")
            continue;  // can be neither scaled nor moved
        SCOPED_TRACE(name);
        testing::expect_visibility_graph_laws(testing::scene_input(text), build);
    }
}

TEST(VisibilityGraphLaws, hold_on_random_scenes) {
    for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        SCOPED_TRACE(testing::to_text(input));
        testing::expect_visibility_graph_laws(input, build);
    }
}

}  // namespace
}  // namespace sightline
