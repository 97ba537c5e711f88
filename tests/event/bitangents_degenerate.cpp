// SPDX-License-Identifier: GPL-3.0-or-later
// Each test states the rule that decides its case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sightline/event/bitangents.hpp"
#include "support/bitangents.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

using ::testing::Contains;
using ::testing::Not;
using testing::scene2;

std::string between(const std::string& scene) {
    return testing::to_string(bitangents(scene2(scene)));
}
std::string all_of(const std::string& scene) {
    return testing::to_string(bitangents(scene2(scene), {.one_body = true}));
}

TEST(BitangentsDegenerate, EdgesOnOneLineCountOnceBetweenNearestVertices) {
    const auto all = bitangents(scene2("0 0, 1 0, 0 1 | 3 0, 4 0, 4 1"));
    EXPECT_THAT(all, Contains(Bitangent{{0}, {1}, Side::left, Side::left, {1}, {3}}));
    EXPECT_EQ(all.size(), 8U);
}

TEST(BitangentsDegenerate, ContactsOfAThirdBodyBetweenTwoChangeNothing) {
    EXPECT_EQ(
        bitangents(scene2("0 0, 1 0, 0 1 | 6 0, 7 0, 7 1 | 3 0, 4 0, 4 1"), BodyId{0}, BodyId{1}),
        bitangents(scene2("0 0, 1 0, 0 1 | 6 0, 7 0, 7 1"), BodyId{0}, BodyId{1}));
}

TEST(BitangentsDegenerate, AnInnerOneMayRunAlongAnEdge) {
    // The line y = 0 has the first triangle above and the second below.
    EXPECT_THAT(bitangents(scene2("0 0, 1 0, 0 1 | 3 0, 4 -1, 4 0")),
                Contains(Bitangent{{0}, {1}, Side::left, Side::right, {1}, {3}}));
}

TEST(BitangentsDegenerate, ABodyEdgeIsOneWhenBothItsEndsAreConvex) {
    EXPECT_EQ(all_of("0 0, 2 0, 1 2"), "LL v0 v1 b0 b0; RR v0 v2 b0 b0; LL v1 v2 b0 b0");
}

TEST(BitangentsDegenerate, AStraightVertexIsAContactOfItsOwnEdge) {
    EXPECT_EQ(all_of("0 0, 1 0, 2 0, 1 2"),
              "LL v0 v1 b0 b0; RR v0 v3 b0 b0; LL v1 v2 b0 b0; LL v2 v3 b0 b0");
}

TEST(BitangentsDegenerate, AReflexCornerIsNoContact) {
    const auto all = bitangents(scene2("0 0, 4 0, 2 1, 4 4, 0 4"), {.one_body = true});
    for (const Bitangent& b : all) EXPECT_NE(b.source, VertexId{2}) << b;
}

TEST(BitangentsDegenerate, CornersOfAHoleAreReflexForItsBody) {
    const std::string scene =
        "polygon 0 0, 9 0, 9 9, 0 9; hole 3 3, 6 3, 3 6; polygon 4 4, 4.5 4, 4 4.5";
    EXPECT_EQ(between(scene), "");
    EXPECT_EQ(all_of(scene),
              "LL v0 v1 b0 b0; RR v0 v3 b0 b0; LL v1 v2 b0 b0; LL v2 v3 b0 b0; "
              "LL v7 v8 b1 b1; RR v7 v9 b1 b1; LL v8 v9 b1 b1");
}

TEST(BitangentsDegenerate, CornersOfTheWorldThatJutIntoItAreContacts) {
    EXPECT_EQ(between("world; polygon 0 0, 8 0, 8 4, 4 4, 4 8, 0 8; polygon 5 1, 7 1, 6 2.5"),
              "LL v3 v6 b- b0; LR v3 v8 b- b0");
}

TEST(BitangentsDegenerate, BothContactsMayBeOnTheWorld) {
    const std::string room =
        "world; polygon 0 0, 3 0, 3 1, 5 1, 5 0, 8 0, 8 4, 5 4, 5 3, 3 3, 3 4, 0 4";
    EXPECT_EQ(between(room), "") << "the world counts as one body";
    EXPECT_EQ(all_of(room),
              "RR v2 v3 b- b-; RL v2 v8 b- b-; RR v2 v9 b- b-; LL v3 v8 b- b-; LR v3 v9 b- b-; "
              "RR v8 v9 b- b-")
        << "the sides, the ends and the diagonals of a passage between two rooms";
}

TEST(BitangentsDegenerate, PointsHaveNoSide) {
    EXPECT_EQ(between("polygon 0 0, 2 0, 1 2; point 1 -3, 4 -3"),
              "LO v0 v3 b0 b-; LO v0 v4 b0 b-; RO v1 v3 b0 b-; RO v2 v4 b0 b-; OO v3 v4 b- b-");
}

TEST(BitangentsDegenerate, AWallHasTheSideOnWhichItsPiecesLie) {
    EXPECT_EQ(between("wall 0 0, 2 0; point 1 2, 4 0"),
              "OO v0 v1 b- b-; RO v0 v2 b- b-; OO v0 v3 b- b-; LO v1 v2 b- b-; OO v1 v3 b- b-; "
              "OO v2 v3 b- b-")
        << "its vertices count each by itself; it is on its own line";
}

TEST(BitangentsDegenerate, ALineThatCrossesAWallAtItsBendIsNone) {
    // From v3, inside the angle of the bend v1, the line through v1 would cross the wall there.
    EXPECT_EQ(between("wall 0 0, 2 0, 3 2; point 2 3, 1 -1"),
              "OL v0 v1 b- b-; RR v0 v2 b- b-; RO v0 v3 b- b-; LO v0 v4 b- b-; LO v1 v2 b- b-; "
              "RO v1 v4 b- b-; LO v2 v3 b- b-; LO v2 v4 b- b-; OO v3 v4 b- b-");
}

TEST(BitangentsDegenerate, VerticesAtOnePlaceHaveTheirOwn) {
    // Two triangles touch with their tips v0 and v3, side by side.
    EXPECT_EQ(between("polygon 0 0, -1 1, -1 -1; polygon 0 0, 1 -1, 1 1"),
              "RL v0 v4 b0 b1; LR v0 v5 b0 b1; RL v1 v3 b0 b1; RR v1 v5 b0 b1; LR v2 v3 b0 b1; "
              "LL v2 v4 b0 b1")
        << "v0 and v3 are no contacts of each other; the inner ones run along the edges at the "
           "tips";
}

TEST(BitangentsDegenerate, TangencyIsJudgedAgainstAllThatTouches) {
    // Boxes that share an edge: a line through v1 = v4 that supports one of them alone cuts the other.
    EXPECT_EQ(between("polygon 0 0, 1 0, 1 1, 0 1; polygon 1 0, 2 0, 2 1, 1 1"),
              "LL v0 v4 b0 b1; LL v1 v5 b0 b1; RR v2 v6 b0 b1; RR v3 v7 b0 b1");
    // A triangle that stands with its tip v4 on the edge of a table.
    EXPECT_EQ(bitangents(scene2("polygon 0 0, 4 0, 4 -1, 0 -1; polygon 2 0, 3 2, 1 2"), BodyId{0},
                         BodyId{1})
                  .front(),
              (Bitangent{{0}, {1}, Side::right, Side::left, {0}, {4}}));
    for (const Bitangent& b :
         bitangents(scene2("polygon 0 0, 4 0, 4 -1, 0 -1; polygon 2 0, 3 2, 1 2; point 3 -5"))) {
        if (b.source == VertexId{4}) {
            EXPECT_NE(b.target, VertexId{7}) << "it would cut the table";
        }
    }
}

TEST(BitangentsDegenerate, AroundAPinholeOfOneBodyItLiesOnBothSides) {
    // The hole's corner v4 lies on the outer edge v3 v0.
    EXPECT_EQ(between("polygon 0 0, 6 0, 6 6, 0 6; hole 0 3, 3 2, 3 4; point -2 3, 2 3"),
              "RO v0 v7 b0 b-; LO v3 v7 b0 b-; BO v4 v7 b0 b-; BO v4 v8 b0 b-; OO v7 v8 b- b-");
}

TEST(BitangentsDegenerate, APlaceSealedInFromAllSidesHasNone) {
    const auto all = bitangents(scene2("0 0, 1 0, 1 1, 0 1 | -1 0, 0 0, 0 1, -1 1 | "
                                       "-1 -1, 0 -1, 0 0, -1 0 | 0 -1, 1 -1, 1 0, 0 0"),
                                {.one_body = true});
    EXPECT_FALSE(all.empty());
    for (const Bitangent& b : all) EXPECT_NE(b.source, VertexId{0}) << b;
}

TEST(BitangentsDegenerate, OneUlpDecides) {
    // The second triangle's lower edge lies on the line of the first one's, or one ulp above it.
    const auto touches = [](double y) {
        SceneInput2 input;
        input.elements.emplace_back(Polygon2{{{0, 1}, {1, 1}, {0, 2}}, {}});
        input.elements.emplace_back(Polygon2{{{3, y}, {4, y}, {4, 3}}, {}});
        return sightline::testing::to_string(bitangents(*Scene2::make(input)));
    };
    EXPECT_EQ(touches(1), "LL v1 v3 b0 b1; LR v1 v5 b0 b1; RL v2 v3 b0 b1; RR v2 v5 b0 b1");
    EXPECT_EQ(touches(1 + 0x1p-52),
              "LL v1 v4 b0 b1; LR v1 v5 b0 b1; RL v2 v3 b0 b1; RR v2 v5 b0 b1");
    EXPECT_EQ(touches(1 - 0x1p-53),
              "LL v0 v3 b0 b1; LR v1 v5 b0 b1; RL v2 v3 b0 b1; RR v2 v5 b0 b1");
}

}  // namespace
}  // namespace sightline
