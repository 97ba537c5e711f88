// SPDX-License-Identifier: GPL-3.0-or-later
// One test a rule for degenerate segments, nodes and arcs.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

std::vector<std::string> segments(const std::string& scene, const RationalPoint3& p,
                                  const RationalPoint3& q) {
    std::vector<std::string> result;
    const Scene3 valid = testing::scene3(scene);
    for (const auto& s : reference::maximal_free_segments(valid, to_surd(line_through(p, q)))) {
        std::ostringstream text;
        text << s.label << " : " << s.dimension;
        result.push_back(text.str());
    }
    return result;
}

using Texts = std::vector<std::string>;

std::vector<std::string> arcs_with(const std::string& scene, const std::string& label) {
    std::vector<std::string> result;
    const auto skeleton = reference::visibility_skeleton(testing::scene3(scene));
    for (const SkeletonArc& arc : skeleton.arcs()) {
        std::ostringstream text;
        text << arc.label;
        if (text.str() == label) result.push_back(testing::to_string(skeleton, arc));
    }
    return result;
}

const std::string cube = "box 0 0 0, 2 2 2";

TEST(FreeSegments3Degenerate, GrazingAnEdgeAFaceOrAVertexIsFree) {
    EXPECT_EQ(segments(cube, {-1, 0, 1}, {0, 0, 1}), Texts{"e2 e4 | inf | inf : 2"}) << "a face";
    EXPECT_EQ(segments(cube, {-1, 1, 1}, {0, 0, 1}), Texts{"e2 | inf | inf : 3"});
    EXPECT_EQ(segments(cube, {-1, 1, 0}, {0, 0, 0}), Texts{"v0 | inf | inf : 2"});
    EXPECT_EQ(segments(cube, {0, 0, 0}, {1, 0, 0}), Texts{"v0 v1 | inf | inf : 0"}) << "an edge";
}

TEST(FreeSegments3Degenerate, InsideIsBlocked) {
    const Texts through = segments(cube, {-1, 1, 1}, {0, 1, 1});
    EXPECT_EQ(through.size(), 2U);
    EXPECT_EQ(segments("world; " + cube, {-1, 1, 1}, {0, 1, 1}), Texts{" | f3 | f5 : 4"});
}

// Contact in a face is sealed, in an edge a slit, in a point a pinhole.
TEST(FreeSegments3Degenerate, OnlyContactInAFaceIsSealed) {
    const std::string stack = "box 0 0 0, 2 2 2; box 0 0 2, 2 2 4";
    EXPECT_EQ(segments(stack, {-1, 1, 2}, {0, 1, 2}).size(), 2U);
    const std::string slit = "box 0 0 0, 2 2 2; box 2 0 2, 4 2 4";
    EXPECT_EQ(segments(slit, {1, 1, 3}, {2, 1, 2}).size(), 1U) << "across the common edge";
    const std::string pinhole = "box 0 0 0, 2 2 2; box 2 2 2, 4 4 4";
    EXPECT_EQ(segments(pinhole, {1, 2, 3}, {2, 2, 2}).size(), 1U) << "through the common corner";
    EXPECT_EQ(segments(pinhole, {1, 1, 1}, {2, 2, 2}).size(), 2U) << "inside both";
    const std::string four =
        "box 0 0 0, 2 2 2; box 2 0 0, 4 2 2; box 0 2 0, 2 4 2; box 2 2 0, 4 4 2";
    EXPECT_EQ(segments(four, {2, 2, -1}, {2, 2, 0}).size(), 2U) << "wedges fill the disc";
    const std::string three = "box 0 0 0, 2 2 2; box 2 0 0, 4 2 2; box 0 2 0, 2 4 2";
    EXPECT_EQ(segments(three, {2, 2, -1}, {2, 2, 0}).size(), 1U) << "three of four leave a slit";
}

// Lines that end at the seam of two boxes: into the lower, into the upper, and in the plane between, where
// the faces of both stop it. The last stay in that plane.
TEST(FreeSegments3Degenerate, TheEndBetweenTwoBodiesIsAnEndOfItsOwn) {
    const std::string stack = "box 0 0 0, 2 2 2; box 0 0 2, 2 2 4";
    const Texts below = segments(stack, {-1, 1, 3}, {0, 1, 2});
    const Texts above = segments(stack, {-1, 1, 1}, {0, 1, 2});
    const Texts between = segments(stack, {-1, 1, 2}, {0, 1, 2});
    ASSERT_EQ(below.size(), 2U);
    ASSERT_EQ(between.size(), 2U);
    EXPECT_TRUE(below[0].ends_with(": 3")) << below[0];
    EXPECT_TRUE(above[0].ends_with(": 3")) << above[0];
    EXPECT_TRUE(between[0].ends_with(": 2")) << between[0];
    EXPECT_NE(below[0], above[0]);
}

TEST(FreeSegments3Degenerate, SheetsAreFreeAtTheirBorderAndInTheirPlane) {
    const std::string sheet = "sheet 0 0 0, 4 0 0, 0 4 0";
    EXPECT_EQ(segments(sheet, {1, 1, 1}, {1, 1, 0}),
              (Texts{" | inf | f0- : 4", " | inf | f0 : 4"}));
    EXPECT_EQ(segments(sheet, {1, 0, 1}, {1, 0, 0}), Texts{"e0 | inf | inf : 3"}) << "border";
    EXPECT_EQ(segments(sheet, {1, 1, 0}, {2, 1, 0}).size(), 1U) << "plane";
}

// A wall that stands on a box seals: only a line that leaves on the side where it came from passes its foot.
TEST(FreeSegments3Degenerate, ASheetThatStandsOnABodySeals) {
    const std::string wall = "box 0 0 -2, 4 4 0; sheet 1 2 0, 3 2 0, 3 2 4, 1 2 4";
    EXPECT_EQ(segments(wall, {2, 0, 0}, {2, 1, 0}).size(), 2U) << "along the box, across the foot";
    EXPECT_EQ(segments(wall, {Rational(1, 2), 0, 0}, {Rational(1, 2), 1, 0}).size(), 1U)
        << "beside the wall";
}

// What comes in the plane of a wall and would leave it on the other side of a second wall ends at the far end
// of what it shares with the first; what comes from there ends at the near end: the two overlap.
TEST(FreeSegments3Degenerate, SegmentsThatMeetInASheetOverlap) {
    // A closed box of sheets but for the plane of its middle floor.
    const std::string cross =
        "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0; sheet 0 4 0, 4 4 0, 4 4 4, 0 4 4; "
        "sheet 0 4 0, 4 4 0, 4 4 -4, 0 4 -4; sheet 0 0 0, 4 0 0, 4 0 4, 0 0 4; "
        "sheet 0 0 0, 4 0 0, 4 0 -4, 0 0 -4";
    const Scene3 scene = testing::scene3(cross);
    const auto found = reference::maximal_free_segments(
        scene, to_surd(line_through(RationalPoint3{2, -1, 0}, RationalPoint3{2, 0, 0})));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(found[0].from.has_value());
    EXPECT_EQ(found[0].to, Surd(4));
    EXPECT_EQ(found[1].from, Surd(0));
    EXPECT_FALSE(found[1].to.has_value());
}

const std::string corner = "hull 0 0 0, 4 0 0, 0 4 0, 1 1 -3; sheet 8 1 -2, 8 1 2, 9 2 2";

// Lines in the plane of the top face that meet the sheet's edge e6 turn round the point where e6 pierces that
// plane. The last ones of them run through v1 and v2, and are nodes although their neighbours round v1 look
// the same: they cut the arc of those in two.
TEST(ReferenceSkeletonDegenerate, AnArcMayEndInsideAnother) {
    EXPECT_EQ(arcs_with(corner, "v1 e6 | inf | inf"),
              (Texts{"EV v1 e6 | inf | inf [VV v1 v4 | inf | inf] [FvE v1 e6 | inf | inf in f0]",
                     "EV v1 e6 | inf | inf [VV v1 v5 | inf | inf] [FvE v1 e6 | inf | inf in f0]"}));
    EXPECT_EQ(arcs_with(corner, "e0 e3 e6 | inf | inf"),
              Texts{"FE e0 e3 e6 | inf | inf [FvE v0 e3 e6 | inf | inf in f0] "
                    "[FvE v1 e6 | inf | inf in f0]"});
}

// Above the middle of four boxes that fill a square, the line between all four is a node: it stays where it
// is, as otherwise fewer than four would stop it.
TEST(ReferenceSkeletonDegenerate, AnEndBetweenFourBodiesFixesTheLine) {
    const auto skeleton = reference::visibility_skeleton(
        testing::scene3("box 0 0 0, 2 2 2; box 2 0 0, 4 2 2; box 0 2 0, 2 4 2; box 2 2 0, 4 4 2"));
    const auto nodes = std::ranges::count_if(skeleton.nodes(), [](const SkeletonNode& node) {
        return node.label.support.vertices.size() == 4 && node.label.support.edges.empty() &&
               node.label.ends[1].size() == 12 && node.label.ends[0].empty();
    });
    EXPECT_EQ(nodes, 2) << "above and below";
}

// Edges of touching bodies that cross fix a point, as a vertex does; told from the arc next to it, where
// the same two edges are met in different points.
TEST(ReferenceSkeletonDegenerate, CrossingEdgesFixAPoint) {
    const std::string boxes = "box 0 0 0, 4 4 4; box 4 2 1, 8 6 5";
    const auto skeleton = reference::visibility_skeleton(testing::scene3(boxes));
    const std::string label = "v15 e3 e6 e13 | inf | inf";
    const auto node = std::ranges::find_if(skeleton.nodes(), [&](const SkeletonNode& n) {
        std::ostringstream text;
        text << n.label;
        return text.str() == label;
    });
    ASSERT_NE(node, skeleton.nodes().end());
    EXPECT_EQ(node->type, NodeType::vv) << "v15, and the crossing of e6 and e13";
    const auto arcs = arcs_with(boxes, label);
    ASSERT_EQ(arcs.size(), 1U) << "beyond the crossing e13 comes before e6";
    EXPECT_NE(arcs[0].find("[" + testing::to_string(*node) + "]"), std::string::npos) << arcs[0];
}

}  // namespace
}  // namespace sightline
