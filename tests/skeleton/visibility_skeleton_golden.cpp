// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "sightline/scene/families3.hpp"
#include "sightline/skeleton/build.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

std::ptrdiff_t count(const VisibilitySkeleton& skeleton, NodeType type) {
    return std::ranges::count(skeleton.nodes(), type, &SkeletonNode::type);
}

TEST(VisibilitySkeletonGolden, ATetrahedronHasItsSixEdgeLines) {
    const auto skeleton =
        visibility_skeleton(testing::scene3(families::solid(families::SolidShape::tetrahedron)));
    EXPECT_EQ(skeleton.nodes().size(), 6u);
    EXPECT_EQ(count(skeleton, NodeType::vv), 6);
    EXPECT_EQ(skeleton.arcs().size(), 12u) << "in each face, the lines through each corner";
    for (std::uint32_t n = 0; n < 6; ++n) EXPECT_EQ(skeleton.arcs_at(NodeId{n}).size(), 4u);
}

TEST(VisibilitySkeletonGolden, ACubeHasTwelveEdgeLinesAndTwelveFaceDiagonals) {
    const auto skeleton =
        visibility_skeleton(testing::scene3(families::solid(families::SolidShape::cube)));
    EXPECT_EQ(skeleton.nodes().size(), 24u);
    EXPECT_EQ(skeleton.arcs().size(), 48u) << "each corner of each face and each edge opposite";
}

}  // namespace
}  // namespace sightline
