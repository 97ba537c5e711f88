// SPDX-License-Identifier: GPL-3.0-or-later
// Views against the reference algorithm, on random scenes on small grids: everything degenerate is common there.
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

TEST(View3Differential, AgreesWithTheReferenceOnRandomScenes) {
    EXPECT_GT(compare_on(0, 40, 2), 50);
}

// Pieces of edges end where two bodies' edges cross in their contact, in the edges' sight plane.
TEST(View3Differential, AgreesWherePiecesEndAtCornersOfContacts) {
    for (const std::uint64_t seed : {1028, 2618, 3566, 7505}) {
        EXPECT_GT(compare_on(seed, seed + 1, 1), 0);
    }
}

}  // namespace
}  // namespace sightline::testing
