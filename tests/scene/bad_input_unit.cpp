// SPDX-License-Identifier: GPL-3.0-or-later
// What is refused, and the one line that says so.
#include <gtest/gtest.h>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/text_format.hpp"

namespace sightline {
namespace {

struct BadInput {
    SceneFormat2 format;
    bool world;
    const char* content;
    Errc code;
    const char* message;
};

constexpr SceneFormat2 wkt = SceneFormat2::wkt;
constexpr SceneFormat2 text = SceneFormat2::text;
constexpr SceneFormat2 geojson = SceneFormat2::geojson;

// clang-format off
const BadInput bad_inputs[] = {
    {wkt, false, "",
     Errc::empty_scene, "f: the scene is empty; give at least one polygon, wall or point"},
    {wkt, false, "  \n",
     Errc::empty_scene, "f: the scene is empty; give at least one polygon, wall or point"},
    {wkt, false, "POLYGON EMPTY",
     Errc::empty_scene, "f: the scene is empty; give at least one polygon, wall or point"},
    {wkt, false, "POLYGON",
     Errc::syntax, "f:1:8: expected '(', but the text ends"},
    {wkt, false, "POLYGON (",
     Errc::syntax, "f:1:10: expected '(', but the text ends"},
    {wkt, false, "POLYGON ((0 0, 1 0, 0 1",
     Errc::syntax, "f:1:24: expected ')', but the text ends"},
    {wkt, false, "POLYGON ((0 0, 1 0, 0 1)) x",
     Errc::syntax, "f:1:28: 'x' is no geometry; write POLYGON, LINESTRING or POINT"},
    {wkt, false, "POLYGON ((0 0, 1 0, 0 1))) ",
     Errc::syntax, "f:1:26: expected a geometry such as POLYGON, found ')'"},
    {wkt, false, "POLYGON ((0 0, 1, 0 1))",
     Errc::syntax, "f:1:17: expected a number, found ','"},
    {wkt, false, "POLYGON ((0 0, 1 zero, 0 1))",
     Errc::syntax, "f:1:18: expected a number, found 'zero'"},
    {wkt, false, "POINT (1..2 3)",
     Errc::syntax, "f:1:8: expected a number, found '1..2'"},
    {wkt, false, "POINT (1e 3)",
     Errc::syntax, "f:1:8: expected a number, found '1e'"},
    {wkt, false, "POINT (0x10 3)",
     Errc::syntax, "f:1:8: expected a number, found '0x10'"},
    {wkt, false, "POINT (1 2,)",
     Errc::syntax, "f:1:11: expected ')', found ','"},
    {wkt, false, "\xff""\xfe"" binary",
     Errc::syntax, "f:1:1: expected a geometry such as POLYGON, found '\\xff\\xfe'"},
    {wkt, false, "POINT Z (1 2 3)",
     Errc::unsupported, "f:1:8: POINT Z has more than two coordinates; give x and y only"},
    {wkt, false, "LINESTRING (0 0 1, 1 1 1)",
     Errc::unsupported, "f:1:18: a third coordinate is not supported; give x and y only"},
    {wkt, false, "CIRCULARSTRING (0 0, 1 1, 2 0)",
     Errc::unsupported, "f:1:15: CIRCULARSTRING is not supported; write it as POLYGON or LINESTRING"},
    {wkt, false, "HEXAGON ((0 0, 1 1, 2 0, 0 0))",
     Errc::syntax, "f:1:8: 'HEXAGON' is no geometry; write POLYGON, LINESTRING or POINT"},
    {wkt, false, "POINT (1e400 0)",
     Errc::coordinate_too_large, "f:1:8: the number is beyond the doubles; give one below 2^1020 in size"},
    {wkt, false, "POINT (2e307 0)",
     Errc::coordinate_too_large, "f:1: element 0 (point), vertex 0 (2e+307, 0): is larger than 2^1020; scale the scene down by a power of two"},
    {wkt, false, "POINT (nan 0)",
     Errc::not_finite, "f:1: element 0 (point), vertex 0 (nan, 0): is not finite; give a number for each coordinate"},
    {wkt, false, "LINESTRING (0 0, inf 1)",
     Errc::not_finite, "f:1: element 0 (wall), vertex 1 (inf, 1): is not finite; give a number for each coordinate"},
    {wkt, false, "POINT (0 0)\nPOLYGON ((0 0, 1 0, 0 0))",
     Errc::too_few_vertices, "f:2: element 1 (polygon), outer ring: a ring needs at least 3 distinct vertices; add vertices or remove the ring"},
    {wkt, false, "POLYGON ((0 0, 1 1, 2 2, 0 0))",
     Errc::spike, "f:1: element 0 (polygon), outer ring, vertex 0 (0, 0): is a spike: the ring turns back on itself; remove the vertex, or use --repair"},
    {wkt, false, "POLYGON ((0 0, 1 0, 1 0, 0 1))",
     Errc::repeated_vertex, "f:1: element 0 (polygon), outer ring, vertex 2 (1, 0): repeats the vertex before it; remove one of the two, or use --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 6 4, 4 4, 0 4))",
     Errc::spike, "f:1: element 0 (polygon), outer ring, vertex 3 (6, 4): is a spike: the ring turns back on itself; remove the vertex, or use --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 4 2, 0 4))",
     Errc::spike, "f:1: element 0 (polygon), outer ring, vertex 2 (4, 4): is a spike: the ring turns back on itself; remove the vertex, or use --repair"},
    {wkt, false, "POLYGON ((0 0, 2 2, 2 0, 0 2))",
     Errc::self_intersection, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(2, 2) crosses element 0 (polygon), outer ring, edge 2 (2, 0)-(0, 2): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 2 -1, 0 4))",
     Errc::self_intersection, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(4, 0) crosses element 0 (polygon), outer ring, edge 3 (2, -1)-(0, 4): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 5 1, 2 2))",
     Errc::self_intersection, "f:1: element 0 (polygon), outer ring, edge 1 (4, 0)-(4, 4) crosses element 0 (polygon), hole 0, edge 0 (1, 1)-(5, 1): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 0, 3 0, 2 2))",
     Errc::self_intersection, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(4, 0) runs along element 0 (polygon), hole 0, edge 0 (1, 0)-(3, 0): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"},
    {wkt, false, "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 4 1, 4 4), (3 1.5, 6 2, 3 4))",
     Errc::wrong_nesting, "f:1: element 0 (polygon), hole 1, vertex 0 (3, 1.5): lies inside hole 0 of the same polygon; make it a polygon of its own"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4), (5 5, 6 5, 6 6))",
     Errc::hole_outside, "f:1: element 0 (polygon), hole 0, vertex 0 (5, 5): the hole is not inside its polygon's outer ring; move it, or make it a polygon of its own"},
    {wkt, false, "POLYGON ((1 1, 2 1, 2 2), (0 0, 4 0, 4 4, 0 4))",
     Errc::hole_outside, "f:1: element 0 (polygon), hole 0, vertex 0 (0, 0): the hole is not inside its polygon's outer ring; move it, or make it a polygon of its own"},
    {wkt, false, "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 8 1, 8 8, 1 8), (2 2, 3 2, 3 3))",
     Errc::wrong_nesting, "f:1: element 0 (polygon), hole 1, vertex 0 (2, 2): lies inside hole 0 of the same polygon; make it a polygon of its own"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((3 3, 6 3, 6 6, 3 6))",
     Errc::body_overlap, "f:2: element 1 (polygon), outer ring, vertex 0 (3, 3): lies inside body 0: bodies 0 and 1 overlap; separate them, or merge them with --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((1 1, 2 1, 2 2))",
     Errc::wrong_nesting, "f:2: element 1 (polygon), outer ring, vertex 0 (1, 1): body 1 lies inside the solid part of body 0; remove it, or merge them with --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((0 0, 4 0, 4 4, 0 4))",
     Errc::body_overlap, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(4, 0) runs along element 1 (polygon), outer ring, edge 0 (0, 0)-(4, 0): bodies 0 and 1 overlap; separate them, or merge them with --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4))\nPOLYGON ((4 0, 0 0, 2 1))",
     Errc::body_overlap, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(4, 0) runs along element 1 (polygon), outer ring, edge 0 (4, 0)-(0, 0): bodies 0 and 1 overlap; separate them, or merge them with --repair"},
    {wkt, false, "POLYGON ((-1 -1, 1 -1, 0 1))\nPOLYGON ((0 -3, 5 0, 0 3, 0.25 0))",
     Errc::body_overlap, "f:1: element 0 (polygon), outer ring, edge 0 (-1, -1)-(1, -1) crosses element 1 (polygon), outer ring, edge 3 (0.25, 0)-(0, -3): bodies 0 and 1 overlap; separate them, or merge them with --repair"},
    {wkt, true, "LINESTRING (0 0, 1 1)",
     Errc::empty_scene, "f: there is no polygon to be the world; add one, or read without the world option"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 5 1, 2 2))",
     Errc::outside_world, "f:1: element 0 (polygon), outer ring, edge 1 (4, 0)-(4, 4) crosses element 0 (polygon), hole 0, edge 0 (1, 1)-(5, 1): body 0 reaches out of the world; clip it to the world"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((5 5, 6 5, 6 6))",
     Errc::outside_world, "f:2: element 1 (polygon), outer ring, vertex 0 (5, 5): body 0 lies outside of the world; move it inside or clip it"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOLYGON ((-1 -1, 9 -1, 9 9, -1 9))",
     Errc::outside_world, "f:2: element 1 (polygon), outer ring, vertex 0 (-1, -1): body 0 lies outside of the world; move it inside or clip it"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nPOINT (5 5)",
     Errc::outside_world, "f:2: element 1 (point), vertex 0 (5, 5): the point lies outside of the world; move or remove it"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nLINESTRING (1 1, 5 1)",
     Errc::outside_world, "f:2: element 1 (wall), vertex 1 (5, 1): the wall leaves the world; clip it to the world"},
    {wkt, true, "POLYGON ((0 0, 4 0, 4 4, 0 4))\nLINESTRING (7 7, 8 8)",
     Errc::outside_world, "f:2: element 1 (wall), vertex 0 (7, 7): the wall leaves the world; clip it to the world"},
    {wkt, true, "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 5 1, 5 5, 1 5), (4 4, 6 4, 6 6, 4 6))",
     Errc::body_overlap, "f:1: element 0 (polygon), hole 1, vertex 0 (4, 4): lies inside body 0: bodies 0 and 1 overlap; separate them, or merge them with --repair"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4)) POINT (1 1)",
     Errc::point_in_body, "f:1: element 1 (point), vertex 0 (1, 1): the point lies inside body 0; move or remove it"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4)) LINESTRING (5 5, 2 2)",
     Errc::wall_crosses_body, "f:1: element 1 (wall), vertex 1 (2, 2): the wall runs through the interior of body 0; cut it at the body's boundary"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4)) LINESTRING (1 1, 2 2)",
     Errc::wall_crosses_body, "f:1: element 1 (wall), vertex 0 (1, 1): the wall runs through the interior of body 0; cut it at the body's boundary"},
    {wkt, false, "POLYGON ((0 0, 4 0, 4 4, 0 4)) LINESTRING (0 0, 4 4)",
     Errc::wall_crosses_body, "f:1: element 1 (wall), edge 0 (0, 0)-(4, 4): the wall runs through the interior of body 0; cut it at the body's boundary"},
    {wkt, false, "LINESTRING (0 0)",
     Errc::too_few_vertices, "f:1: element 0 (wall): a wall needs at least 2 vertices; add one, or give a point"},
    {wkt, false, "LINESTRING (0 0, 1 1, 1 1)",
     Errc::zero_length, "f:1: element 0 (wall), vertex 2 (1, 1): ends a wall of length zero; remove the vertex, or use --repair"},
    {text, false, "# nothing",
     Errc::empty_scene, "f: the scene is empty; give at least one polygon, wall or point"},
    {text, false, "polgon 0 0, 1 0, 0 1",
     Errc::syntax, "f:1:7: 'polgon' is no word of a scene; write polygon, hole, wall, point or world"},
    {text, false, "hole 0 0, 1 0, 0 1",
     Errc::syntax, "f:1:5: 'hole' does not follow a polygon; put it below its polygon's line"},
    {text, false, "wall 0 0, 1 1\nhole 0 0, 1 0, 0 1",
     Errc::syntax, "f:2:5: 'hole' does not follow a polygon; put it below its polygon's line"},
    {text, false, "polygon 0 0, 1 0, 0 1\nworld",
     Errc::syntax, "f:2:6: 'world' follows a polygon; put it before the first one"},
    {text, false, "polygon 0 0, 1 0 0 1",
     Errc::syntax, "f:1:18: expected ',' or the end of the line, found '0'"},
    {text, false, "polygon 0 0, 1 0,",
     Errc::syntax, "f:1:18: expected a number, but the text ends"},
    {text, false, "point 1",
     Errc::syntax, "f:1:8: expected a number, but the text ends"},
    {text, false, "wall 0 0; 1 1",
     Errc::syntax, "f:1:9: expected ',' or the end of the line, found ';'"},
    {text, false, "polygon",
     Errc::syntax, "f:1:8: expected a number, but the text ends"},
    {text, false, "point 1,5 2",
     Errc::syntax, "f:1:8: expected a number, found ',5'"},
    {geojson, false, "",
     Errc::syntax, "f:1:1: not JSON: the text ends too early; complete it"},
    {geojson, false, "[1, 2]",
     Errc::syntax, "f:1:1: GeoJSON begins with an object; write {\"type\": …}"},
    {geojson, false, "5",
     Errc::syntax, "f:1:1: GeoJSON begins with an object; write {\"type\": …}"},
    {geojson, false, "{\"type\": \"Polygon\"",
     Errc::syntax, "f:1:18: not JSON: the text ends too early; complete it"},
    {geojson, false, "{\"type\": \"Polygon\"}",
     Errc::syntax, "f:1:19: Polygon has no coordinates; add them"},
    {geojson, false, "{\"coordinates\": [1, 2]}",
     Errc::syntax, "f:1:23: an object has no type; add \"type\""},
    {geojson, false, "{\"type\": \"Topology\", \"arcs\": []}",
     Errc::unsupported, "f:1:32: type \"Topology\" is not supported; write Polygon, LineString or Point"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": [1, 2, 3]}",
     Errc::unsupported, "f:1:42: a third coordinate is not supported; give x and y only"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": [1]}",
     Errc::syntax, "f:1:36: a position has 1 numbers; write [x, y]"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": [1, \"2\"]}",
     Errc::syntax, "f:1:40: a text stands among the coordinates; write numbers"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": {\"x\": 1}}",
     Errc::syntax, "f:1:34: member \"coordinates\" is an object; write a list"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": null}",
     Errc::syntax, "f:1:37: member \"coordinates\" is null; write a list"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": [1e999, 0]}",
     Errc::coordinate_too_large, "f:1:40: the number is beyond the doubles; give one below 2^1020 in size"},
    {geojson, false, "{\"type\": \"Polygon\", \"coordinates\": [[0, 0], [1, 0], [0, 1]]}",
     Errc::syntax, "f:1:60: Polygon needs positions within 3 brackets, not 2; mend the brackets"},
    {geojson, false, "{\"type\": \"LineString\", \"coordinates\": [[0, 0], [[1, 0]]]}",
     Errc::syntax, "f:1:49: positions stand at different depths; write all as [x, y]"},
    {geojson, false, "{\"type\": \"MultiPolygon\", \"coordinates\": [[[[[0, 0]]]]]}",
     Errc::syntax, "f:1:45: coordinates are nested deeper than 4; no geometry has that"},
    {geojson, false, "{\"type\": \"FeatureCollection\",\n \"features\": {\"type\": \"Feature\"}}",
     Errc::syntax, "f:2:14: member \"features\" is an object; write a list"},
    {geojson, false, "{\"type\": \"FeatureCollection\",\n \"features\": [5]}",
     Errc::syntax, "f:2:16: a number stands in the place of a geometry; write an object"},
    {geojson, false, "{\"type\": 5}",
     Errc::syntax, "f:1:11: member \"type\" is a number; write a text"},
    {geojson, false, "{\"type\": \"Point\", \"coordinates\": [0, NaN]}",
     Errc::syntax, "f:1:38: not JSON: a bracket, comma, text or number is wrong here; mend it"},
    {geojson, false, "{\"type\": \"Feature\", \"geometry\": [1]}",
     Errc::syntax, "f:1:33: member \"geometry\" is a list; write a geometry object"},
    {geojson, false, "{\"type\": \"LineString\", \"coordinates\": [[0, 0], []]}",
     Errc::syntax, "f:1:49: a position has 0 numbers; write [x, y]"},
    {geojson, false, "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [1, 0], [0, 1], [0, 0]]]} x",
     Errc::syntax, "f:1:72: not JSON: a bracket, comma, text or number is wrong here; mend it"},
    {geojson, false, "{\"type\": \"Polygon\",\n \"coordinates\": [[[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]]]}",
     Errc::self_intersection, "f:1: element 0 (polygon), outer ring, edge 0 (0, 0)-(2, 2) crosses element 0 (polygon), outer ring, edge 2 (2, 0)-(0, 2): the rings of one polygon may touch in points but not cross or run along each other; mend the ring"},
};
// clang-format on

Result<Scene2> make_from(const BadInput& bad) {
    const ReadOptions options{.world = bad.world, .file = "f"};
    const std::string_view content = bad.content;
    const auto input = bad.format == wkt    ? read_wkt(content, options)
                       : bad.format == text ? read_text(content, options)
                                            : read_geojson(content, options);
    if (!input) return tl::unexpected(input.error());
    return Scene2::make(*input);
}

TEST(BadInput, IsRefusedWithOneLineThatSaysWhereAndWhatWouldMendIt) {
    EXPECT_GE(std::size(bad_inputs), 40U);
    for (const BadInput& bad : bad_inputs) {
        const auto scene = make_from(bad);
        ASSERT_FALSE(scene) << bad.content;
        EXPECT_STREQ(name_of(scene.error().code), name_of(bad.code)) << bad.content;
        EXPECT_EQ(scene.error().message, bad.message) << bad.content;
        EXPECT_EQ(scene.error().message.find('\n'), std::string::npos) << bad.content;
    }
}

TEST(BadInput, DeepNestingIsRefusedNotFollowed) {
    std::string deep_wkt;
    std::string deep_json;
    std::string deep_member = R"({"type": "Point", "coordinates": [0, 0], "x": )";
    for (int i = 0; i < 100000; ++i) {
        deep_wkt += "GEOMETRYCOLLECTION (";
        deep_json += R"({"type": "GeometryCollection", "geometries": [)";
        deep_member += '[';
    }
    EXPECT_EQ(read_wkt(std::string_view(deep_wkt)).error().code, Errc::limit_reached);
    EXPECT_EQ(read_geojson(std::string_view(deep_json)).error().code, Errc::limit_reached);
    EXPECT_EQ(read_geojson(std::string_view(deep_member)).error().code, Errc::limit_reached);
    const std::string shallow = "GEOMETRYCOLLECTION (GEOMETRYCOLLECTION (POINT (0 0)))";
    EXPECT_TRUE(read_wkt(std::string_view(shallow), {.max_depth = 2}));
    EXPECT_EQ(read_wkt(std::string_view(shallow), {.max_depth = 1}).error(),
              (Error{Errc::limit_reached,
                     "line 1:40: collections are nested deeper than 1; flatten them"}));
}

}  // namespace
}  // namespace sightline
