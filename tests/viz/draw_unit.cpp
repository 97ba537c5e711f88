// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "support/scenes.hpp"

namespace sightline::viz {
namespace {

using ::sightline::testing::scene2;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> names(const DrawList& list) {
    std::vector<std::string> result;
    for (const Layer& layer : list.layers) result.push_back(layer.name);
    return result;
}

Box wide_view() { return {{-10, -10, 0}, {10, 10, 0}}; }

TEST(DrawScene, BodyIsAPolygonWithItsHoles) {
    const DrawList list =
        draw(scene2("polygon 0 0, 9 0, 9 9, 0 9; hole 1 1, 2 1, 1 2; hole 5 5, 6 5, 5 6;"
                    "polygon 20 0, 21 0, 20 1"));
    EXPECT_THAT(names(list), ElementsAre("bodies"));
    const Layer& bodies = list.layers[0];
    EXPECT_EQ(bodies.count, 2u);
    ASSERT_EQ(bodies.polygons.size(), 2u);
    EXPECT_EQ(bodies.polygons[0].outer.size(), 4u);
    ASSERT_EQ(bodies.polygons[0].holes.size(), 2u);
    EXPECT_THAT(bodies.polygons[0].holes[1],
                ::testing::UnorderedElementsAre(Position{5, 5}, Position{6, 5}, Position{5, 6}));
    EXPECT_EQ(bodies.polygons[1].id, 1u);
    EXPECT_THAT(bodies.polygons[1].holes, IsEmpty());
    EXPECT_GT(bodies.style.fill_opacity, 0);
}

TEST(DrawScene, OutsideOfAWorldIsSolidUpToTheEdgeOfThePicture) {
    const DrawList list =
        draw(scene2("world; polygon 0 0, 9 0, 9 9, 0 9; hole 2 2, 3 2, 3 3, 2 3"));
    EXPECT_THAT(names(list), ElementsAre("outside", "bodies"));
    const Polygon& outside = list.layers[0].polygons.at(0);
    EXPECT_THAT(outside.outer,
                ElementsAre(list.view.low, Position{list.view.high.x, list.view.low.y},
                            list.view.high, Position{list.view.low.x, list.view.high.y}));
    ASSERT_EQ(outside.holes.size(), 1u);
    EXPECT_EQ(outside.holes[0].size(), 4u);
    EXPECT_EQ(list.layers[1].polygons.size(), 1u) << "the hole of the world is a body";
}

TEST(DrawScene, WallsAreChainsInFileOrder) {
    const DrawList list = draw(scene2("wall 0 0, 1 0, 1 1; wall 5 5, 6 6"));
    EXPECT_THAT(names(list), ElementsAre("walls"));
    const Layer& walls = list.layers[0];
    EXPECT_EQ(walls.count, 3u);
    ASSERT_EQ(walls.polylines.size(), 2u);
    EXPECT_THAT(walls.polylines[0].points,
                ElementsAre(Position{0, 0}, Position{1, 0}, Position{1, 1}));
    EXPECT_EQ(walls.polylines[1].id, 2u) << "the edge's number";
}

TEST(DrawScene, PointsAreAlwaysMarkedVerticesOnDemand) {
    const Scene2 scene = scene2("polygon 0 0, 1 0, 0 1; point 3 3");
    EXPECT_THAT(names(draw(scene)), ElementsAre("bodies", "points"));
    const DrawList list = draw(scene, {.vertices = true, .vertex_labels = true});
    const Layer* vertices = list.find("vertices");
    ASSERT_NE(vertices, nullptr);
    EXPECT_EQ(vertices->points.size(), 4u);
    EXPECT_EQ(vertices->labels.at(3), (Label{{3, 3}, "v3"}));
    EXPECT_THAT(list.find("points")->points, ElementsAre(Position{3, 3}));
}

TEST(DrawScene, TitleAndViewAreTaken) {
    const DrawList list =
        draw(scene2("polygon 0 0, 1 0, 0 1"), {.title = "T", .view = wide_view()});
    EXPECT_EQ(list.title, "T");
    EXPECT_EQ(list.view, wide_view());
}

TEST(DrawGraph, EdgesAreSegmentsInCanonicalOrder) {
    const Scene2 scene = scene2("polygon 0 0, 1 0, 0 1");
    const auto graph =
        VisibilityGraph::from_edges(3, {{VertexId{2}, VertexId{1}}, {VertexId{0}, VertexId{1}}});
    const DrawList list = draw(scene, graph);
    EXPECT_THAT(names(list), ElementsAre("bodies", "graph"));
    const Layer& edges = list.layers[1];
    EXPECT_EQ(edges.count, 2u);
    EXPECT_THAT(edges.segments,
                ElementsAre(Position{0, 0}, Position{1, 0}, Position{1, 0}, Position{0, 1}));
}

TEST(DrawGraph, MoreEdgesAreThinnerAndPaler) {
    const Scene2 scene = scene2("polygon 0 0, 1 0, 0 1");
    const auto style = [&](std::size_t n) {
        DrawList list;
        add_graph(list, scene, std::vector<VisibilityGraph::Edge>(n, {VertexId{0}, VertexId{1}}));
        return list.layers.at(0).style;
    };
    EXPECT_GT(style(10).opacity, 0.5);
    EXPECT_LT(style(5000).opacity, style(10).opacity);
    EXPECT_LT(style(100'000).opacity, style(5000).opacity);
    EXPECT_LT(style(100'000).width, style(10).width);
    EXPECT_GT(style(1'000'000).opacity, 0.01) << "never invisible";
}

TEST(DrawPath, EndsAndTurnsAreMarkedAndTheLengthIsInTheLegend) {
    const std::vector<RationalPoint2> points{{0, 0}, {3, 4}, {3, 10}};
    DrawList list;
    add_path(list, points, {11, 11});
    EXPECT_THAT(names(list), ElementsAre("path", "turns", "from", "to"));
    EXPECT_THAT(list.find("path")->polylines.at(0).points,
                ElementsAre(Position{0, 0}, Position{3, 4}, Position{3, 10}));
    EXPECT_THAT(list.find("path")->legend, HasSubstr("length 11"));
    EXPECT_THAT(list.find("turns")->points, ElementsAre(Position{3, 4}));
    EXPECT_EQ(list.find("from")->labels.at(0), (Label{{0, 0}, "from"}));
    EXPECT_EQ(list.find("to")->labels.at(0), (Label{{3, 10}, "to"}));
    EXPECT_NE(list.find("from")->style.marker, list.find("to")->style.marker);
}

TEST(DrawPath, StraightPathHasNoTurns) {
    DrawList list;
    add_path(list, std::vector<RationalPoint2>{{0, 0}, {3, 4}}, {5, 5});
    EXPECT_EQ(list.find("turns"), nullptr);
}

TEST(DrawPath, ShortestPathOfASceneIsDrawnRoundTheBody) {
    const Scene2 scene = scene2("polygon 2 -1, 3 -1, 3 5, 2 5");
    const auto path = shortest_path(scene, {0, 0}, {20, 0});
    ASSERT_TRUE(path) << path.error().message;
    const DrawList list = draw(scene, *path);
    EXPECT_THAT(list.find("path")->polylines.at(0).points,
                ElementsAre(Position{0, 0}, Position{2, -1}, Position{3, -1}, Position{20, 0}));
    EXPECT_EQ(list.find("turns")->count, 2u);
    EXPECT_GT(list.view.high.x, 20) << "the picture contains the ends";
}

/// The ring that add_view draws from exact vertices.
std::vector<Position> drawn_ring(const RationalPoint2& from, const std::vector<ViewPoint>& ring) {
    DrawList list;
    list.view = wide_view();
    add_view(list, from, ring);
    return list.find("view")->polygons.at(0).outer;
}

ViewPoint at(int x, int y) { return {{x, y}, false}; }
ViewPoint towards(int x, int y) { return {{x, y}, true}; }

TEST(DrawView, BoundedRingIsDrawnAsItIs) {
    EXPECT_THAT(drawn_ring({1, 1}, {at(0, 0), at(4, 0), at(0, 4)}),
                ElementsAre(Position{0, 0}, Position{4, 0}, Position{0, 4}));
}

TEST(DrawView, DirectionsEndAtTheEdgeOfThePicture) {
    EXPECT_THAT(drawn_ring({0, 0}, {at(1, 0), towards(1, 0), towards(2, 1), at(2, 1)}),
                ElementsAre(Position{1, 0}, Position{10, 0}, Position{10, 5}, Position{2, 1}));
}

TEST(DrawView, BoundaryLeavesOutTheEdgeOfThePicture) {
    DrawList list;
    list.view = wide_view();
    const std::vector<ViewPoint> ring{towards(2, 1), at(2, 1), at(1, 0), towards(1, 0)};
    add_view(list, {0, 0}, ring);
    const Layer* boundary = list.find("view boundary");
    ASSERT_EQ(boundary->polylines.size(), 1u);
    EXPECT_THAT(boundary->polylines[0].points,
                ElementsAre(Position{10, 5}, Position{2, 1}, Position{1, 0}, Position{10, 0}));
}

TEST(DrawView, CornersBetweenDirectionsBelongToTheView) {
    EXPECT_THAT(drawn_ring({0, 0}, {at(0, 0), towards(1, 0), towards(-1, 0)}),
                ElementsAre(Position{0, 0}, Position{10, 0}, Position{10, 10}, Position{-10, 10},
                            Position{-10, 0}));
    EXPECT_THAT(drawn_ring({0, 0}, {at(0, 0), towards(-1, 0), towards(1, 0)}),
                ElementsAre(Position{0, 0}, Position{-10, 0}, Position{-10, -10}, Position{10, -10},
                            Position{10, 0}));
}

TEST(DrawView, NothingInTheWayShowsTheWholePicture) {
    const auto ring =
        drawn_ring({0, 0}, {towards(1, 0), towards(0, 1), towards(-1, 0), towards(0, -1)});
    EXPECT_THAT(ring, ElementsAre(Position{10, 0}, Position{10, 10}, Position{0, 10},
                                  Position{-10, 10}, Position{-10, 0}, Position{-10, -10},
                                  Position{0, -10}, Position{10, -10}));
}

TEST(DrawView, DirectionIntoACornerEndsThere) {
    EXPECT_THAT(drawn_ring({0, 0}, {at(0, 0), towards(1, 1), towards(-1, 1)}),
                ElementsAre(Position{0, 0}, Position{10, 10}, Position{-10, 10}));
}

TEST(DrawView, HugeDirectionsAreDirections) {
    const Rational huge = *Rational::parse("1e900");
    const auto ring = drawn_ring({0, 0}, {at(0, 0), {{huge, huge}, true}, towards(-1, 1)});
    EXPECT_THAT(ring, ElementsAre(Position{0, 0}, Position{10, 10}, Position{-10, 10}));
}

TEST(DrawView, ViewpointOutsideThePictureStillSeesIntoIt) {
    DrawList list;
    list.view = {{0, 0, 0}, {10, 10, 0}};
    const std::vector<ViewPoint> ring{at(-20, 5), towards(1, 0), towards(0, 1)};
    add_view(list, {-20, 5}, ring);
    EXPECT_THAT(
        list.find("view")->polygons.at(0).outer,
        ElementsAre(Position{-20, 5}, Position{10, 5}, Position{10, 10}, Position{-20, 10}));
    EXPECT_EQ(list.view, (Box{{0, 0, 0}, {10, 10, 0}}));
}

TEST(DrawView, NeedlesAndViewpointHaveLayersOfTheirOwn) {
    DrawList list;
    list.view = wide_view();
    const std::vector<ViewPoint> ring{at(0, 0), at(1, 0), at(0, 1)};
    const std::vector<NeedlePoints> needles{{at(1, 0), towards(1, 0)}};
    add_view(list, {0, 0}, ring, needles);
    EXPECT_THAT(names(list), ElementsAre("view", "view boundary", "needles", "viewpoint"));
    EXPECT_THAT(list.find("needles")->segments, ElementsAre(Position{1, 0}, Position{10, 0}));
    EXPECT_THAT(list.find("viewpoint")->points, ElementsAre(Position{0, 0}));
    EXPECT_LT(list.find("view")->style.fill_opacity, 1) << "bodies shine through";
}

TEST(DrawView, VisibilityPolygonOfASceneIsDrawnToTheEdgeOfThePicture) {
    // A triangle hides what is behind it from the origin; the rest of the plane is seen.
    const Scene2 scene = scene2("polygon 2 -1, 3 0, 2 1");
    const auto polygon = visibility_polygon(scene, {0, 0});
    ASSERT_TRUE(polygon) << polygon.error().message;
    const DrawList list = draw(scene, *polygon, {.view = wide_view()});
    EXPECT_THAT(names(list), ElementsAre("bodies", "view", "view boundary", "viewpoint"));
    const auto& ring = list.find("view")->polygons.at(0).outer;
    EXPECT_THAT(ring,
                ::testing::IsSupersetOf({Position{2, -1}, Position{2, 1}, Position{10, 5},
                                         Position{10, 10}, Position{-10, 10}, Position{-10, -10},
                                         Position{10, -10}, Position{10, -5}}));
    for (const Position& p : ring) {
        EXPECT_FALSE(p.x > 2 && std::abs(p.y) * 2 < p.x) << "in the shadow";
    }
}

TEST(DrawView, PictureContainsTheViewpoint) {
    const Scene2 scene = scene2("polygon 2 -1, 3 0, 2 1");
    const auto polygon = visibility_polygon(scene, {-50, 0});
    ASSERT_TRUE(polygon);
    EXPECT_LT(draw(scene, *polygon).view.low.x, -50);
}

TEST(DrawAll, SceneGraphViewAndPathStackInReadingOrder) {
    const Scene2 scene = scene2("polygon 2 2, 3 2, 2 3; wall 5 0, 5 1");
    DrawList list = draw(scene, {.vertices = true});
    add_path(list, std::vector<RationalPoint2>{{0, 0}, {2, 3}, {4, 4}}, {6, 6});
    const std::vector<ViewPoint> ring{at(0, 0), at(1, 0), at(0, 1)};
    add_view(list, {0, 0}, ring);
    add_graph(list, scene, VisibilityGraph::from_edges(5, {{VertexId{0}, VertexId{1}}}));
    EXPECT_THAT(names(list), ElementsAre("bodies", "view", "view boundary", "graph", "walls",
                                         "vertices", "path", "turns", "from", "to", "viewpoint"));
}

}  // namespace
}  // namespace sightline::viz
