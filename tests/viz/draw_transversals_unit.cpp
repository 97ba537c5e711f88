// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_transversals.hpp"

#include <gtest/gtest.h>

#include "sightline/event/segment_file.hpp"

namespace sightline::viz {
namespace {

// Two lines through the x axis, the line y at height 2, and two more.
const char* const skew = "-90 0 0 90 0 0  0 -90 2 0 90 2  -89 -88 -90 91 92 90  -28 1 -90 32 1 90";
// Lines of z = xy: all lines y = c with c between 0 and 1 meet them.
const char* const regulus = "0 0 0 0 1 0  1 0 0 1 1 1  2 0 0 2 1 2  3 -1 -3 3 1 3";

TEST(DrawTransversals, EachLineIsDrawnBetweenItsOutermostPoints) {
    const auto segments = read_segments(skew, "skew").value();
    const auto found = transversals(segments).value();
    ASSERT_EQ(found.lines.size(), 2u);
    const DrawList list = draw(segments, found, {.title = "T"});
    EXPECT_EQ(list.title, "T");
    EXPECT_TRUE(list.camera);
    EXPECT_EQ(list.find("segments")->segments.size(), 8u);
    EXPECT_EQ(list.find("families"), nullptr);
    const Layer& lines = *list.find("lines");
    EXPECT_EQ(lines.count, 2u);
    ASSERT_EQ(lines.segments.size(), 4u);
    for (std::size_t i = 0; i < 2; ++i) {
        // From z = 0 to z = 2 and a little further, as the line meets both axes.
        const Position &a = lines.segments[2 * i], &b = lines.segments[2 * i + 1];
        EXPECT_LT(std::min(a.z, b.z), 0);
        EXPECT_GT(std::max(a.z, b.z), 2);
        const double t = -a.z / (b.z - a.z);
        EXPECT_NEAR(a.y + t * (b.y - a.y), 0, 1e-9) << "through the x axis";
    }
}

TEST(DrawTransversals, OfManyLinesTheFirstAreDrawnAndANoteSaysSo) {
    const auto segments = read_segments(skew, "skew").value();
    const DrawList list = draw(segments, transversals(segments).value(),
                               {.title = {}, .camera = {}, .most_lines = 1});
    EXPECT_EQ(list.find("lines")->count, 1u);
    ASSERT_EQ(list.notes.size(), 1u);
    EXPECT_EQ(list.notes[0], "1 of 2 lines are drawn");
}

TEST(DrawTransversals, AFamilyIsShownByItsEndsAndLinesBetween) {
    const auto segments = read_segments(regulus, "regulus").value();
    const DrawList list = draw(segments, transversals(segments).value());
    EXPECT_EQ(list.find("lines"), nullptr);
    const Layer& families = *list.find("families");
    ASSERT_EQ(families.segments.size(), 18u);
    for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_NEAR(families.segments[i].y, static_cast<double>(i / 2) / 8, 1e-9);
    }
}

TEST(DrawTransversals, APencilIsShownByLinesThroughItsCentre) {
    // The origin, and three segments in the plane z = 0 that are seen under one angle.
    const auto segments =
        read_segments("0 0 0 0 0 0  1 0 0 1 1 0  2 0 0 2 2 0  3 0 0 3 3 0", "pencil").value();
    const auto found = transversals(segments).value();
    ASSERT_EQ(found.components.size(), 1u);
    const DrawList list = draw(segments, found);
    const Layer& families = *list.find("families");
    ASSERT_EQ(families.segments.size(), 18u);
    for (std::size_t i = 0; i < 18; i += 2) {
        const Position &a = families.segments[i], &b = families.segments[i + 1];
        EXPECT_NEAR(a.x * b.y - a.y * b.x, 0, 1e-9);
        EXPECT_NEAR(std::max(a.y / a.x, b.y / b.x), static_cast<double>(i) / 16, 1e-9);
    }
}

TEST(DrawTransversals, TrianglesAreAreas) {
    const auto t = read_triangles(
                       "0 0 0 1 0 0 0 1 0  9 0 0 10 0 0 9 1 0 "
                       "0 0 0 1 0 0 0 1 0  9 0 0 10 0 0 9 1 0",
                       "flat")
                       .value();
    const std::array<RationalTriangle3, 4> four{t[0], t[1], t[2], t[3]};
    const DrawList list = draw(four, triangle_tangents(four));
    EXPECT_EQ(list.find("triangles")->polygons.size(), 4u);
    EXPECT_EQ(list.find("lines")->count, 4u);
}

}  // namespace
}  // namespace sightline::viz
