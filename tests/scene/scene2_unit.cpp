// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_helpers.hpp"

namespace sightline {
namespace {

using test::make_wkt;
using test::scene_of;
using ::testing::ElementsAre;

TEST(Scene2, BodiesHaveTheirInteriorOnTheLeftWhateverTheInputSays) {
    const Scene2 clockwise = scene_of("POLYGON ((0 0, 0 1, 1 0, 0 0))");
    const Scene2 counter = scene_of("POLYGON ((0 0, 1 0, 0 1, 0 0))");
    for (const Scene2* scene : {&clockwise, &counter}) {
        ASSERT_EQ(scene->edge_count(), 3U);
        for (const Edge2& e : scene->edges()) {
            const Point2& s = (*scene)[e.source];
            const Point2& t = (*scene)[e.target];
            EXPECT_GT((t.x - s.x) * (0.25 - s.y) - (t.y - s.y) * (0.25 - s.x), 0)
                << "(1/4, 1/4) is left";
            EXPECT_EQ(e.body, BodyId{0});
            EXPECT_EQ(e.kind, EdgeKind2::body);
        }
    }
}

TEST(Scene2, RingsKeepTheirVerticesAndFormChains) {
    const Scene2 scene = scene_of("POLYGON ((0 0, 0 1, 1 0, 0 0))");
    EXPECT_THAT(scene.vertices(), ElementsAre(Point2{0, 0}, Point2{0, 1}, Point2{1, 0}));
    EXPECT_EQ(scene[EdgeId{0}].source, VertexId{0});
    EXPECT_EQ(scene[EdgeId{0}].target, VertexId{2});
    EXPECT_EQ(scene[EdgeId{1}].target, VertexId{1});
    EXPECT_EQ(scene[EdgeId{2}].target, VertexId{0});
}

TEST(Scene2, TheWorldHasItsOutsideOnTheLeftAndItsHolesAreTheFirstBodies) {
    const Scene2 scene = scene_of(
        "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1), (4 4, 5 4, 5 5, 4 4)) "
        "POLYGON ((6 6, 8 6, 8 8, 6 8), (6.5 6.5, 7.5 6.5, 7 7.5))",
        true);
    EXPECT_TRUE(scene.has_world());
    EXPECT_EQ(scene.body_count(), 3U);
    ASSERT_EQ(scene.rings().size(), 5U);
    EXPECT_TRUE(scene.rings()[0].body.is_none());
    EXPECT_EQ(scene.rings()[1].body, BodyId{0});
    EXPECT_EQ(scene.rings()[2].body, BodyId{1});
    EXPECT_EQ(scene.rings()[3].body, BodyId{2});
    EXPECT_FALSE(scene.rings()[3].is_hole);
    EXPECT_TRUE(scene.rings()[4].is_hole);
    EXPECT_EQ(scene[EdgeId{0}].kind, EdgeKind2::world);
    EXPECT_EQ(scene[EdgeId{0}].target, VertexId{3}) << "clockwise: the outside is on the left";
}

TEST(Scene2, WallsAndPointsFollowTheInputOrder) {
    const Scene2 scene = scene_of("POINT (5 5) LINESTRING (0 0, 1 1, 2 0) POINT (6 6)");
    EXPECT_THAT(scene.points(), ElementsAre(VertexId{0}, VertexId{4}));
    ASSERT_EQ(scene.edge_count(), 2U);
    EXPECT_EQ(scene[EdgeId{1}], (Edge2{VertexId{2}, VertexId{3}, BodyId::none(), EdgeKind2::wall}));
}

TEST(Scene2, NegativeZeroBecomesZero) {
    const Scene2 scene = scene_of("POINT (-0 -0.0)");
    EXPECT_FALSE(std::signbit(scene[VertexId{0}].x));
    EXPECT_FALSE(std::signbit(scene[VertexId{0}].y));
}

TEST(Scene2, AddedPointsAreVerticesAfterTheOthers) {
    const Scene2 scene = scene_of("POLYGON ((0 0, 4 0, 0 4))");
    const Point2 added[] = {{3, 3}, {2, 2}, {0, 0}};
    const auto more = scene.with_points(added);
    ASSERT_TRUE(more) << more.error().message;
    EXPECT_EQ(more->vertex_count(), 6U);
    EXPECT_THAT(more->points(), ElementsAre(VertexId{3}, VertexId{4}, VertexId{5}));
    EXPECT_EQ(scene.vertex_count(), 3U) << "the scene itself is immutable";
}

TEST(Scene2, PointsInsideOfBCannotBeAdded) {
    const Scene2 scene = scene_of("POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 4 1, 1 4))", true);
    const Point2 inside[] = {{2, 2}};
    EXPECT_EQ(scene.with_points(inside).error(),
              (Error{Errc::inside_body, "point (2, 2) lies inside body 0; choose one outside"}));
    const Point2 outside[] = {{10, 2}};
    EXPECT_EQ(scene.with_points(outside).error(),
              (Error{Errc::outside_of_world,
                     "point (10, 2) lies outside of the world; choose one inside"}));
    const Point2 infinite[] = {{1, INFINITY}};
    EXPECT_EQ(scene.with_points(infinite).error().code, Errc::not_finite);
}

}  // namespace
}  // namespace sightline
