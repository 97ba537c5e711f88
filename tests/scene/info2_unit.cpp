// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/info2.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_helpers.hpp"

namespace sightline {
namespace {

using test::scene_of;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(Info, CountsWhatIsThere) {
    const SceneInfo2 info =
        describe(scene_of("POLYGON ((0 0, 9 0, 9 8, 0 7), (1 1, 4 1, 1 4)) POLYGON ((5 5, 7 5, 7 "
                          "7), (6 5.5, 6.5 5.5, 6.5 6)) "
                          "LINESTRING (5 1, 6 2, 7 1) POINT (8 1)",
                          true));
    EXPECT_EQ(info.vertices, 17U);
    EXPECT_EQ(info.bodies, 2U);
    EXPECT_EQ(info.holes, 1U);
    EXPECT_EQ(info.body_edges, 9U);
    EXPECT_EQ(info.world_edges, 4U);
    EXPECT_EQ(info.walls, 2U);
    EXPECT_EQ(info.points, 1U);
    EXPECT_TRUE(info.has_world);
    EXPECT_EQ(info.low, (Point2{0, 0}));
    EXPECT_EQ(info.high, (Point2{9, 8}));
    EXPECT_EQ(info.approx_shortest_edge, 0.5);
    EXPECT_EQ(info.approx_extent, 9);
    EXPECT_FALSE(info.is_degenerate());
    EXPECT_THAT(to_text(info), ::testing::EndsWith("degeneracies: none\n"));
}

TEST(Info, ListsWhereBodiesTouch) {
    const SceneInfo2 info =
        describe(scene_of("POLYGON ((0 0, 20 0, 20 20, 0 20), (1 1, 4 1, 4 4, 1 4), (4 2, 6 2, 6 "
                          "6, 4 6), (6 6, 8 6, 7 8), (0 10, 2 9, 2 11))",
                          true));
    EXPECT_THAT(info.contacts, ElementsAre(BodyContact2{BodyId{0}, BodyId{1}, 0, 1},
                                           BodyContact2{BodyId{1}, BodyId{2}, 1, 0},
                                           BodyContact2{BodyId{3}, BodyId::none(), 1, 0}));
    EXPECT_THAT(info.coincident, ElementsAre(ElementsAre(VertexId{10}, VertexId{12})));
    EXPECT_THAT(info.vertices_on_edges,
                ElementsAre(Pair(VertexId{6}, EdgeId{11}), Pair(VertexId{8}, EdgeId{5}),
                            Pair(VertexId{15}, EdgeId{0})));
    EXPECT_THAT(info.pinches, IsEmpty());
    EXPECT_THAT(info.straight, IsEmpty());
    EXPECT_TRUE(info.is_degenerate());
}

TEST(Info, ListsPinches) {
    const SceneInfo2 info =
        describe(scene_of("POLYGON ((0 0, 2 0, 1 1, 2 2, 0 2, 1 1)) POLYGON ((4 0, 8 0, 8 4, 4 4), "
                          "(6 0, 7 2, 5 2))"));
    EXPECT_THAT(info.pinches, ElementsAre(VertexId{2}, VertexId{10}));
    EXPECT_THAT(info.coincident, ElementsAre(ElementsAre(VertexId{2}, VertexId{5})));
    EXPECT_THAT(info.contacts, IsEmpty());
}

TEST(Info, ListsStraightAndNearlyStraightVertices) {
    const SceneInfo2 info =
        describe(scene_of("POLYGON ((0 0, 1 0, 2 0, 2 1, 2 2, 1.0000000000000002 1)) LINESTRING (5 "
                          "0, 5 1, 5 3) LINESTRING (5 4, 5 6, 6 6)"));
    EXPECT_THAT(info.straight, ElementsAre(VertexId{1}, VertexId{3}, VertexId{7}));
    EXPECT_THAT(info.nearly_straight, ElementsAre(VertexId{5}));
}

TEST(Info, CountsPairsOfWalls) {
    const SceneInfo2 info =
        describe(scene_of("LINESTRING (0 0, 4 4) LINESTRING (0 4, 4 0) LINESTRING (1 1, 6 6) "
                          "LINESTRING (4 0, 9 0) LINESTRING (6 0, 6 -2) POINT (2 2) "
                          "POLYGON ((-5 0, -4 0, -4 1)) POINT (-4.5 0)"));
    EXPECT_EQ(info.crossing_walls, 2U);
    EXPECT_EQ(info.overlapping_walls, 1U);
    EXPECT_TRUE(info.all_walls_compared);
    EXPECT_THAT(info.vertices_on_edges,
                ElementsAre(Pair(VertexId{1}, EdgeId{2}), Pair(VertexId{4}, EdgeId{0}),
                            Pair(VertexId{8}, EdgeId{3}), Pair(VertexId{10}, EdgeId{0}),
                            Pair(VertexId{10}, EdgeId{1}), Pair(VertexId{10}, EdgeId{2}),
                            Pair(VertexId{14}, EdgeId{5})));
}

TEST(Info, PrintsALineAFact) {
    const SceneInfo2 info = describe(scene_of(
        "POLYGON ((0 0, 4 0, 4 4, 0 4)) POLYGON ((4 0, 8 0, 8 4, 4 4)) LINESTRING (9 0, 9 9)"));
    EXPECT_EQ(
        to_text(info),
        "vertices: 10\nbodies: 2 (8 edges, 0 holes)\nworld: no\nwalls: 1\npoints: 0\nbox: (0, 0) "
        "to (9, 9)\n"
        "shortest edge: about 4, extent: about 9\ntouching bodies: 1 (b0-b1 0 points 1 edges)\n"
        "places with several vertices: 2 (2 at v1, 2 at v2)\n");
}

}  // namespace
}  // namespace sightline
