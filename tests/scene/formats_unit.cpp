// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/text_format.hpp"

namespace sightline {
namespace {

using ::testing::ElementsAre;

const Ring2 square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const Ring2 triangle = {{0.5, 0.5}, {1, 0.5}, {1, 1}};

TEST(Wkt, EveryKindBecomesItsElements) {
    const auto input = read_wkt(
        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (0.5 0.5, 1 0.5, 1 1, 0.5 0.5))\n"
        "multipolygon (((0 0, 2 0, 2 2, 0 2)), empty, ((0.5 0.5, 1 0.5, 1 1)))\n"
        "LINESTRING(1 2, +3 4e0) MULTILINESTRING ((1 2, 3 4), (5 6, 7 8), EMPTY); POINT (1 2)\n"
        "MULTIPOINT (1 2, 3 4) MULTIPOINT ((5 6), EMPTY, (7 8))\n"
        "GEOMETRYCOLLECTION (POINT (9 9), GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1)), POLYGON "
        "EMPTY)\n"
        "SRID=4326;POINT(0 1) GEOMETRYCOLLECTION EMPTY");
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_THAT(input->elements,
                ElementsAre(Polygon2{square, {triangle}}, Polygon2{square, {}},
                            Polygon2{triangle, {}}, Polyline2{{{1, 2}, {3, 4}}},
                            Polyline2{{{1, 2}, {3, 4}}}, Polyline2{{{5, 6}, {7, 8}}}, Point2{1, 2},
                            Point2{1, 2}, Point2{3, 4}, Point2{5, 6}, Point2{7, 8}, Point2{9, 9},
                            Polyline2{{{0, 0}, {1, 1}}}, Point2{0, 1}));
    EXPECT_THAT(input->lines, ElementsAre(1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 6));
}

TEST(GeoJson, EveryKindBecomesItsElements) {
    const auto input = read_geojson(
        R"({"type": "FeatureCollection", "name": {"type": [1, {"a": null}]}, "features": [
{"type": "Feature", "properties": {"coordinates": "x"}, "geometry":
 {"coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]], [[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 0.5]]], "type": "Polygon"}},
{"type": "Feature", "geometry": null},
{"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
 {"type": "MultiPolygon", "coordinates": [[[[0,0],[2,0],[2,2],[0,2]]], [], [[[5e-1,0.5],[1,0.5],[1,1]]]]},
 {"type": "LineString", "coordinates": [[1, 2], [3, 4]]},
 {"type": "MultiLineString", "coordinates": [[[1, 2], [3, 4]], [[5, 6], [7, 8]]]},
 {"type": "Point", "coordinates": [1, 2], "bbox": [1, 2, 1, 2]},
 {"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]]},
 {"type": "Polygon", "coordinates": []}]}}]})");
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_THAT(
        input->elements,
        ElementsAre(Polygon2{square, {triangle}}, Polygon2{square, {}}, Polygon2{triangle, {}},
                    Polyline2{{{1, 2}, {3, 4}}}, Polyline2{{{1, 2}, {3, 4}}},
                    Polyline2{{{5, 6}, {7, 8}}}, Point2{1, 2}, Point2{1, 2}, Point2{3, 4}));
    EXPECT_THAT(input->lines, ElementsAre(3, 6, 6, 7, 8, 8, 9, 10, 10));
    EXPECT_FALSE(input->world);
}

TEST(GeoJson, AGeometryMayStandAloneAndSayThatItIsTheWorld) {
    const auto input = read_geojson(
        R"({"type": "Polygon", "world": true, "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]})");
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_TRUE(input->world);
    EXPECT_THAT(input->elements, ElementsAre(Polygon2{square, {}}));
}

TEST(TextFormat, EveryWordBecomesItsElements) {
    const auto input = read_text(
        "# a comment\nworld # another\n  polygon 0 0, 2 0,2 2 , 0 2 # a third\nhole .5 0.5, 1 0.5, "
        "1 1, 0.5 0.5\r\n"
        "wall 1 2, 3 4\n\npoint 1 2\npoint 3 4, 5 6");
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_TRUE(input->world);
    EXPECT_THAT(input->elements,
                ElementsAre(Polygon2{square, {triangle}}, Polyline2{{{1, 2}, {3, 4}}}, Point2{1, 2},
                            Point2{3, 4}, Point2{5, 6}));
    EXPECT_THAT(input->lines, ElementsAre(3, 5, 7, 8, 8));
}

TEST(Numbers, AreTheNearestDoubles) {
    const auto input = read_wkt(
        "POINT (0.1 1e-400) POINT (4.9e-324 -1e-999999999999) POINT (9007199254740993 "
        "1.7976931348623157e308) "
        "POINT (0.00000000000000000000000000000000000000000001e44 000.50)");
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_THAT(input->elements,
                ElementsAre(Point2{0.1, 0}, Point2{5e-324, 0},
                            Point2{9007199254740992, 1.7976931348623157e308}, Point2{1, 0.5}));
}

TEST(Formats, AreToldByNameThenByContent) {
    EXPECT_EQ(scene_format("a.WKT", "{"), SceneFormat2::wkt);
    EXPECT_EQ(scene_format("a.geojson", ""), SceneFormat2::geojson);
    EXPECT_EQ(scene_format("a.json", ""), SceneFormat2::geojson);
    EXPECT_EQ(scene_format("a.txt", "POLYGON ((0 0, 1 0, 0 1))"), SceneFormat2::wkt);
    EXPECT_EQ(scene_format("a.txt", "polygon ((0 0, 1 0, 0 1))"), SceneFormat2::wkt);
    EXPECT_EQ(scene_format("a.txt", "point empty"), SceneFormat2::wkt);
    EXPECT_EQ(scene_format("a.txt", "\n # x\npolygon 0 0"), SceneFormat2::text);
    EXPECT_EQ(scene_format("a.txt", "polygon -1 0, 1 0, 0 1"), SceneFormat2::text);
    EXPECT_EQ(scene_format("", " {\"type\": 1}"), SceneFormat2::geojson);
    EXPECT_EQ(scene_format("", ""), SceneFormat2::text);
}

TEST(Files, AreReadByPathAndNamedInErrors) {
    const auto folder = std::filesystem::path(::testing::TempDir());
    const std::string good = (folder / "sightline-good.scene").string();
    const std::string bad = (folder / "sightline-bad.wkt").string();
    std::ofstream(good) << "polygon 0 0, 1 0, 0 1\n";
    std::ofstream(bad) << "POINT (0 0)\nPOLYGON ((0 0, 1 0, 1 0, 0 1))\n";
    const auto scene = read_scene(good);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->edge_count(), 3U);
    const auto refused = read_scene(bad);
    EXPECT_EQ(refused.error().code, Errc::repeated_vertex);
    EXPECT_EQ(refused.error().message.rfind(
                  bad + ":2: element 1 (polygon), outer ring, vertex 2 (1, 0): ", 0),
              0U)
        << refused.error().message;
    EXPECT_EQ(read_scene((folder / "sightline-none").string()).error().code, Errc::cannot_open);
    EXPECT_EQ(read_scene(folder.string()).error().code, Errc::cannot_open);
    std::filesystem::remove(good);
    std::filesystem::remove(bad);
}

}  // namespace
}  // namespace sightline
