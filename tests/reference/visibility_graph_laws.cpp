// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "sightline/reference/visibility_graph.hpp"
#include "support/arbitrary.hpp"
#include "support/corpus.hpp"
#include "support/visibility_graph_laws.hpp"

namespace sightline {
namespace {

TEST(ReferenceVisibilityGraph, obeys_the_laws_on_the_corpus) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        if (name == "thinnest_needle" || name == "one_ulp")
            continue;  // can be neither scaled nor moved
        SCOPED_TRACE(name);
        testing::expect_visibility_graph_laws(testing::scene_input(text),
                                              reference::visibility_graph);
    }
}

TEST(ReferenceVisibilityGraph, obeys_the_laws_on_random_scenes) {
    for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        SCOPED_TRACE(testing::to_text(input));
        testing::expect_visibility_graph_laws(input, reference::visibility_graph);
    }
}

// Freedom does not depend on the direction, and a part of a free segment is free.
RC_GTEST_PROP(FreeSegment, is_symmetric_and_hereditary,
              (const SceneInput2& input, Point2 p, Point2 q)) {
    const Scene2 scene = *Scene2::make(input);
    const RationalPoint2 a = to_rational(p);
    const RationalPoint2 b = to_rational(q);
    const RationalPoint2 third{(a.x + a.x + b.x) / 3, (a.y + a.y + b.y) / 3};
    const bool is_free = reference::is_free(scene, a, b);
    RC_CLASSIFY(is_free);
    RC_ASSERT(is_free == reference::is_free(scene, b, a));
    if (is_free) {
        RC_ASSERT(reference::is_free(scene, a, third));
        RC_ASSERT(reference::is_free(scene, third, b));
    }
}

}  // namespace
}  // namespace sightline
