// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletons whose size can be counted by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

VisibilitySkeleton skeleton_of(const std::string& text) {
    return reference::visibility_skeleton(testing::scene3(text));
}

std::ptrdiff_t count(const VisibilitySkeleton& skeleton, NodeType type) {
    return std::ranges::count(skeleton.nodes(), type, &SkeletonNode::type);
}
std::ptrdiff_t count(const VisibilitySkeleton& skeleton, ArcType type) {
    return std::ranges::count(skeleton.arcs(), type, &SkeletonArc::type);
}
std::size_t sum_of_degrees(const VisibilitySkeleton& skeleton) {
    std::size_t sum = 0;
    for (std::uint32_t n = 0; n < skeleton.nodes().size(); ++n) {
        sum += skeleton.arcs_at(NodeId{n}).size();
    }
    return sum;
}

// A line touches a convex body in a point, or in a piece of a face. So nodes are edges and diagonals of faces,
// and arcs lie in faces: lines through a corner that meet an edge opposite. A face of m corners gives
// m (m - 3) / 2 diagonals and m (m - 2) arcs.
TEST(ReferenceSkeletonGolden, ConvexBodiesHaveEdgesAndDiagonalsOfFaces) {
    struct Case {
        const char* scene;
        std::size_t nodes;
        std::size_t arcs;
    };
    for (const auto& [scene, nodes, arcs] :
         {Case{"family tetrahedron", 6, 4 * 3}, Case{"family octahedron", 12, 8 * 3},
          Case{"family cube", 12 + 6 * 2, 6 * 8},
          Case{"hull 0 0 0, 4 0 0, 4 4 0, 0 4 0, 1 2 3", 8 + 2, 8 + 4 * 3},
          Case{"sheet 0 0 0, 4 0 0, 4 4 0, 1 5 0, 0 4 0", 5 + 5, 15}}) {
        const auto skeleton = skeleton_of(scene);
        EXPECT_EQ(skeleton.nodes().size(), nodes) << scene;
        EXPECT_EQ(count(skeleton, NodeType::vv), static_cast<std::ptrdiff_t>(nodes)) << scene;
        EXPECT_EQ(skeleton.arcs().size(), arcs) << scene;
        EXPECT_EQ(count(skeleton, ArcType::fv), static_cast<std::ptrdiff_t>(arcs)) << scene;
        EXPECT_EQ(sum_of_degrees(skeleton), 2 * arcs) << scene;
    }
}

// From within, all corners see each other, and each corner sees the nine edges that don't end there: six in
// its three faces.
TEST(ReferenceSkeletonGolden, AnEmptyRoom) {
    const auto skeleton = skeleton_of("world; box 0 0 0, 2 3 4");
    EXPECT_EQ(skeleton.nodes().size(), 8U * 7 / 2);
    EXPECT_EQ(count(skeleton, ArcType::fv), 8 * 6);
    EXPECT_EQ(count(skeleton, ArcType::ev), 8 * 3);
}

// Twice 8 edges across and 4 diagonals of end faces; 4 edge lines along both; in each of the four planes of
// both, 4 diagonals and 8 lines from a corner of one to a corner of the other, of unequal heights; and between
// the faces that see each other 4 diagonals in space. A corner there sees two edges there that don't share a
// plane of faces with it.
TEST(ReferenceSkeletonGolden, TwoBoxesInARow) {
    const auto skeleton = skeleton_of("box 0 0 0, 1 1 1; box 2 0 0, 3 1 1");
    EXPECT_EQ(count(skeleton, NodeType::vv), 2 * (8 + 4) + 4 + 4 * (4 + 8) + 4);
    EXPECT_EQ(skeleton.nodes().size(), 80U);
    EXPECT_EQ(count(skeleton, ArcType::ev), 8 * 2);
    EXPECT_EQ(count(skeleton, ArcType::fv), 160);
}

// 4 lines along the upright edges of both, 4 edges each at bottom, seam and top, 2 diagonals at bottom and top,
// and in each side 6 lines askew between its six corners. The diagonals of the seam are sealed.
TEST(ReferenceSkeletonGolden, TwoCubesInAStack) {
    const auto skeleton = skeleton_of("box 0 0 0, 1 1 1; box 0 0 1, 1 1 2");
    EXPECT_EQ(skeleton.nodes().size(), 4U + 3 * 4 + 2 * 2 + 4 * 6);
    // At each corner of the seam, lines in its plane that end there between the cubes.
    const auto between = std::ranges::count_if(skeleton.arcs(), [](const SkeletonArc& arc) {
        return arc.label.support.vertices.size() == 2 && arc.label.support.edges.empty() &&
               arc.label.ends[1].size() == 6;
    });
    EXPECT_EQ(between, 4);
}

// The table's top is sealed under the box. FvE: lines in the plane of a side of the box through a corner of the
// box, as tangents or across that side, to an edge of the table.
TEST(ReferenceSkeletonGolden, ABoxOnATable) {
    const auto skeleton = skeleton_of("box 0 0 0, 4 4 1; box 1 1 1, 2 2 2");
    EXPECT_EQ(count(skeleton, NodeType::vv), 67);
    EXPECT_EQ(count(skeleton, NodeType::fve), 16);
    EXPECT_EQ(skeleton.nodes().size(), 83U);
    EXPECT_EQ(skeleton.arcs().size(), 183U);
}

TEST(ReferenceSkeletonGolden, TwoBoxesApart) {
    const auto skeleton = skeleton_of("box 0 0 0, 4 4 4; box 8 1 1, 12 6 7");
    EXPECT_EQ(count(skeleton, NodeType::vv), 80);
    EXPECT_EQ(count(skeleton, NodeType::fve), 40);
    EXPECT_EQ(count(skeleton, NodeType::ff), 2) << "the top plane of one and a side plane of the "
                                                   "other cut both";
    EXPECT_EQ(skeleton.nodes().size(), 122U);
    EXPECT_EQ(skeleton.arcs().size(), 258U);
}

/// Triangles that each have a long edge on a line of the hyperboloid x² + y² = z² + 1, of one ruling.
const std::string three_rulings =
    "sheet 1 -4 -4, 1 4 4, 1.25 4 4; sheet 4 1 -4, -4 1 4, -4 1.25 4; "
    "sheet -1 4 -4, -1 -4 4, -1.25 -4 4; ";

// A fourth line cuts the hyperboloid twice, and through each of the two points runs a line of the other
// ruling, which meets all four.
TEST(ReferenceSkeletonGolden, FourSkewEdgesHaveTwoLines) {
    const auto skeleton = skeleton_of(three_rulings + "sheet 3 3 0, -3 -2 0.5, -3 -2.25 0.5");
    const auto twin_of = [&](const SkeletonNode& node) {
        return std::ranges::count_if(skeleton.nodes(), [&](const SkeletonNode& other) {
            return other.label.support == node.label.support;
        });
    };
    std::size_t pairs = 0;
    for (const SkeletonNode& node : skeleton.nodes()) {
        if (node.type != NodeType::eeee || node.root != Root::first || twin_of(node) != 2) continue;
        EXPECT_EQ(node.label.support.edges.size(), 4U);
        ++pairs;
    }
    EXPECT_EQ(count(skeleton, NodeType::eeee), 28);
    EXPECT_EQ(pairs, 12U) << "of the others one line is blocked, or misses an edge";
}

// The fourth line lies in the plane 2x + y = 2z + 1, which touches the hyperboloid in (2, 1, 2): the line y = 1,
// x = z meets all four there, but counts twice.
TEST(ReferenceSkeletonGolden, ADoubleLineIsOneNode) {
    const auto skeleton = skeleton_of(three_rulings + "sheet 0 5 2, 4 -3 2, 4 -3 2.25");
    const std::vector long_edges{EdgeId{0}, EdgeId{3}, EdgeId{6}, EdgeId{9}};
    std::vector<SkeletonNode> nodes;
    for (const SkeletonNode& node : skeleton.nodes()) {
        if (node.label.support.edges == long_edges) nodes.push_back(node);
    }
    ASSERT_EQ(nodes.size(), 1U);
    EXPECT_EQ(nodes[0].type, NodeType::eeee);
    EXPECT_EQ(nodes[0].root, Root::only);
}

// Four edges on z = x y, which all meet the lines of the other ruling: one arc with all of them.
TEST(ReferenceSkeletonGolden, FourEdgesOfARegulusShareAnArc) {
    const auto skeleton = skeleton_of(
        "sheet 0 -2 0, 0 2 0, 0 2 1; sheet 1 -2 -2, 1 2 2, 1 2 3; "
        "sheet 2 -2 -4, 2 2 4, 2 2 5; sheet 3 -2 -6, 3 2 6, 3 2 7");
    const auto arc = std::ranges::find_if(skeleton.arcs(), [](const SkeletonArc& a) {
        return a.label.support.edges == std::vector{EdgeId{0}, EdgeId{3}, EdgeId{6}, EdgeId{9}};
    });
    ASSERT_NE(arc, skeleton.arcs().end());
    EXPECT_EQ(arc->type, ArcType::eee);
    for (const NodeId end : arc->nodes) EXPECT_EQ(skeleton[end].label.support.vertices.size(), 4U);
}

}  // namespace
}  // namespace sightline
