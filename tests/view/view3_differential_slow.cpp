// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand and more views against the reference algorithm, on random scenes on small grids: everything degenerate is common there.
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

TEST(View3DifferentialSlow, AgreesWithTheReferenceOnAThousandRandomScenes) {
    EXPECT_GT(compare_on(40, 1100, 2), 1500);
}

TEST(View3DifferentialSlow, AgreesWithTheReferenceOnLargerDegenerateScenes) {
    for (const auto& [name, text] : degenerate_scenes3()) {
        SCOPED_TRACE(name);
        const Scene3 scene = scene3(text);
        if (scene.edges().size() > 24) compare_degenerate(scene);
    }
}

}  // namespace
}  // namespace sightline::testing
