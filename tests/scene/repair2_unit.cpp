// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/repair2.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/text_format.hpp"

namespace sightline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Result<RepairedScene2> repaired(std::string_view text, bool world = false) {
    return repair(*read_wkt(text, {.world = world}));
}

TEST(Repair, ValidInputStaysAsItIs) {
    const char* text = "POLYGON ((0 0, 4 0, 4 4, 0 4)) POLYGON ((4 0, 8 0, 8 4, 4 4))";
    const auto result = repaired(text);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(result->changes, IsEmpty());
    EXPECT_EQ(result->scene, test::scene_of(text)) << "touching bodies are not merged";
}

TEST(Repair, RemovesRepeatsSpikesAndWallsOfLengthZero) {
    const auto result = repaired(
        "POLYGON ((0 0, 4 0, 4 0, 4 4, 6 4, 4 4, 0 4), (1 1, 1 1, 1 1), (1 1, 2 1, 2 2, 1.5 1.5, 2 "
        "2))\n"
        "LINESTRING (5 5, 5 5, 6 6) LINESTRING (7 7, 7 7) POLYGON ((9 9, 10 10, 11 11))");
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(to_text(result->scene),
              "polygon 0 0, 4 0, 4 4, 0 4\nhole 1 1, 2 1, 2 2\nwall 5 5, 6 6\n");
    EXPECT_THAT(result->changes,
                ElementsAre("element 0 (polygon), outer ring: removed 2 repeated vertices.",
                            "element 0 (polygon), outer ring: removed 1 vertices of spikes.",
                            "element 0 (polygon), hole 0: removed, it has no area.",
                            "element 0 (polygon), hole 1: removed 1 repeated vertices.",
                            "element 0 (polygon), hole 1: removed 1 vertices of spikes.",
                            "element 1 (wall): removed 1 segments of length zero.",
                            "element 2 (wall): removed 1 segments of length zero.",
                            "element 2 (wall): removed, nothing of it was left.",
                            "element 3 (polygon), outer ring: removed 1 vertices of spikes.",
                            "element 3 (polygon): removed, its outer ring has no area."));
}

TEST(Repair, MergesOverlappingBodiesOnly) {
    const auto result = repaired(
        "POLYGON ((0 0, 4 0, 4 4, 0 4)) POLYGON ((10 0, 11 0, 11 1)) POLYGON ((3 3, 6 3, 6 6, 3 "
        "6)) "
        "POLYGON ((6 6, 7 6, 7 7))");
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(result->changes, ElementsAre("merged overlapping bodies 0, 2 into 1 polygons."));
    EXPECT_EQ(result->scene.body_count(), 3U);
    EXPECT_EQ(result->scene.rings()[0].count, 8U) << "an L of two boxes";
    EXPECT_EQ(result->scene.rings()[1].count, 3U);
}

TEST(Repair, SaysWhenAUnionRoundsVertices) {
    // The edges cross at x = 1/3.
    const auto result = repaired("POLYGON ((0 0, 1 3, -3 3)) POLYGON ((-1 1, 5 1, 5 0.5))");
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->changes.size(), 1U);
    EXPECT_THAT(result->changes[0],
                ::testing::MatchesRegex("merged overlapping bodies 0, 1 into 1 polygons, rounding "
                                        "[0-9]+ new vertices to the nearest doubles."));
    const auto vertices = result->scene.vertices();
    EXPECT_NE(std::find(vertices.begin(), vertices.end(), Point2{1.0 / 3, 1}), vertices.end());
}

TEST(Repair, ABodyInsideAnotherDisappears) {
    const auto result = repaired("POLYGON ((0 0, 4 0, 4 4, 0 4)) POLYGON ((1 1, 2 1, 2 2))");
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->scene.body_count(), 1U);
    EXPECT_EQ(result->scene.vertex_count(), 4U);
}

TEST(Repair, AUnionMayEncloseAHole) {
    const auto result = repaired(
        "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 5, 5 5, 5 1, 0 1)) POLYGON ((-1 0, 1 0, 1 6, -1 6))");
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->scene.body_count(), 1U);
    ASSERT_EQ(result->scene.rings().size(), 2U);
    EXPECT_TRUE(result->scene.rings()[1].is_hole);
}

TEST(Repair, ClipsBodiesToTheWorld) {
    const auto result = repaired(
        "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 3 1, 3 3, 1 3), (2 2, 4 2, 4 4, 2 4), (8 8, 11 8, 11 "
        "10, 8 10), (5 1, 6 1, 6 2)) "
        "POLYGON ((20 20, 21 20, 21 21))",
        true);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(result->changes, ElementsAre("merged overlapping bodies 0, 1 into 1 polygons.",
                                             "clipped body 2 to the world into 1 polygons.",
                                             "clipped body 4 to the world into 0 polygons."));
    EXPECT_EQ(result->scene.body_count(), 3U);
    EXPECT_TRUE(result->scene.has_world());
}

Rational twice_area(const Scene2& scene) {
    Rational sum;
    for (const Edge2& e : scene.edges()) {
        const RationalPoint2 p = to_rational(scene[e.source]);
        const RationalPoint2 q = to_rational(scene[e.target]);
        sum += p.x * q.y - q.x * p.y;
    }
    return sum;
}

TEST(Repair, MergesRingsThatTouchThemselves) {
    struct Case {
        const char* text;
        const char* twice_area;
    };
    // In a vertex outside, in a vertex inside, in a hole, in the middle of an edge; with a box each.
    const Case cases[] = {
        {"POLYGON ((0 0, 2 0, 2 2, 4 2, 4 4, 2 4, 2 2, 0 2)) POLYGON ((1 1, 3 1, 3 3, 1 3))", "20"},
        {"POLYGON ((0 0, 8 0, 8 8, 0 8, 4 4, 1 5, 1 3, 4 4)) POLYGON ((7 3, 9 3, 9 5, 7 5))",
         "106"},
        {"POLYGON ((0 0, 9 0, 9 9, 0 9), (2 2, 4 2, 4 4, 6 4, 6 6, 4 6, 4 4, 2 4)) "
         "POLYGON ((3 3, 12 3, 12 5, 3 5))",
         "164"},
        {"POLYGON ((0 0, 4 0, 8 0, 8 8, 6 8, 4 0, 2 8, 0 8)) POLYGON ((1 1, 7 1, 7 2, 1 2))",
         "195/2"},
        {"POLYGON ((0 0, 8 0, 8 8, 5 8, 4 0, 3 8, 0 8)) POLYGON ((1 1, 7 1, 7 2, 1 2))", "451/4"}};
    for (const Case& c : cases) {
        const auto result = repaired(c.text);
        ASSERT_TRUE(result) << c.text << ": " << result.error().message;
        EXPECT_EQ(twice_area(result->scene).to_string(), c.twice_area) << c.text;
    }
}

TEST(Repair, SaysWhatItCannotMend) {
    EXPECT_EQ(repaired("POLYGON ((0 0, 2 2, 2 0, 0 2))").error().code, Errc::self_intersection);
    EXPECT_EQ(repaired("POLYGON ((0 0, 2 0, 0 2)) POLYGON ((10 0, 12 2, 12 0, 10 2))").error().code,
              Errc::self_intersection);
    EXPECT_EQ(repaired("POLYGON ((0 0, 4 0, 4 4, 0 4)) POINT (1 1)").error().code,
              Errc::point_in_body);
    EXPECT_EQ(repaired("POLYGON ((0 0, inf 0, inf 4, 0 4))").error().code, Errc::not_finite);
    EXPECT_EQ(repaired("POLYGON ((0 0, 1 1, 2 2))").error().code, Errc::empty_scene);
}

}  // namespace
}  // namespace sightline
