// SPDX-License-Identifier: GPL-3.0-or-later
// Views against the reference algorithm, on random scenes on small grids: everything degenerate is common there.
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

TEST(View3Differential, AgreesWithTheReferenceOnRandomScenes) {
    EXPECT_GT(compare_on(0, 40, 2), 50);
}

}  // namespace
}  // namespace sightline::testing
