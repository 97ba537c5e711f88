// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes that the writers write: whoever changes them changes every file that users keep.
#include <gtest/gtest.h>

#include <sstream>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/text_format.hpp"

namespace sightline {
namespace {

const char* const as_wkt =
    "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (1 1, 3 1, 2 2.5, 1 1), (4 4, 4 5, 5 5, 4 4))\n"
    "LINESTRING (6 6, 0.1 9, 1e-07 9.5)\n"
    "POINT (9 9)\n"
    "POLYGON ((6 1, 9 1, 9 4, 6 4, 6 1), (7 2, 8 2, 8 3, 7 2))\n"
    "LINESTRING (6 6, 7 7)\n"
    "LINESTRING (7 7, 8 8)\n";

const char* const as_text =
    "world\n"
    "polygon 0 0, 10 0, 10 10, 0 10\n"
    "hole 1 1, 3 1, 2 2.5\n"
    "hole 4 4, 4 5, 5 5\n"
    "wall 6 6, 0.1 9, 1e-07 9.5\n"
    "point 9 9\n"
    "polygon 6 1, 9 1, 9 4, 6 4\n"
    "hole 7 2, 8 2, 8 3\n"
    "wall 6 6, 7 7\n"
    "wall 7 7, 8 8\n";

const char* const as_geojson =
    "{\"type\": \"GeometryCollection\", \"world\": true, \"geometries\": [\n"
    "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]], [[1, "
    "1], [3, 1], "
    "[2, 2.5], [1, 1]], [[4, 4], [4, 5], [5, 5], [4, 4]]]},\n"
    "{\"type\": \"LineString\", \"coordinates\": [[6, 6], [0.1, 9], [1e-07, 9.5]]},\n"
    "{\"type\": \"Point\", \"coordinates\": [9, 9]},\n"
    "{\"type\": \"Polygon\", \"coordinates\": [[[6, 1], [9, 1], [9, 4], [6, 4], [6, 1]], [[7, 2], "
    "[8, 2], [8, 3], "
    "[7, 2]]]},\n"
    "{\"type\": \"LineString\", \"coordinates\": [[6, 6], [7, 7]]},\n"
    "{\"type\": \"LineString\", \"coordinates\": [[7, 7], [8, 8]]}\n"
    "]}\n";

std::string written(const Scene2& scene, SceneFormat2 format) {
    std::ostringstream out;
    write_input(out, to_input(scene), format);
    return out.str();
}

TEST(FormatsGolden, ASceneIsWrittenInThreeFormats) {
    const Scene2 scene = test::scene_of(as_wkt, true);
    EXPECT_EQ(written(scene, SceneFormat2::wkt), as_wkt);
    EXPECT_EQ(written(scene, SceneFormat2::text), as_text);
    EXPECT_EQ(written(scene, SceneFormat2::geojson), as_geojson);
    EXPECT_EQ(to_text(scene), as_text);
}

TEST(FormatsGolden, WhatIsWrittenReadsBackToTheSameScene) {
    const Scene2 scene = test::scene_of(as_wkt, true);
    EXPECT_EQ(scene_from_text(as_text), scene);
    const auto input = read_geojson(std::string_view(as_geojson));
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_EQ(Scene2::make(*input), scene);
}

}  // namespace
}  // namespace sightline
