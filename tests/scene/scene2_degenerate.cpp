// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene/scene_helpers.hpp"

namespace sightline {
namespace {

using test::make_wkt;
using test::scene_of;

constexpr const char* box = "POLYGON ((0 0, 4 0, 4 4, 0 4)) ";

/// "ok", or the name of the error.
std::string verdict(const std::string& text, bool world = false) {
    const auto scene = make_wkt(text, world);
    return scene ? "ok" : name_of(scene.error().code);
}

TEST(Scene2Degenerate, BodiesMayTouch) {
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 0, 8 0, 8 4, 4 4))"), "ok")
        << "along an edge";
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 1, 8 1, 8 3, 4 3))"), "ok")
        << "along a piece";
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 4, 8 4, 8 8, 4 8))"), "ok") << "in a vertex";
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 2, 8 0, 8 4))"), "ok")
        << "a vertex on an edge";
    EXPECT_EQ(verdict("POLYGON ((0 0, 9 0, 9 9, 0 9), (0 0, 2 0, 2 2, 0 2))", true), "ok")
        << "the world's edge";
    EXPECT_EQ(
        verdict(
            "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 8 1, 8 8, 1 8)) POLYGON ((1 1, 8 1, 8 8, 1 8))"),
        "ok")
        << "a hole filled by another body";
}

TEST(Scene2Degenerate, RingsMayTouchInPointsOnly) {
    EXPECT_EQ(verdict("POLYGON ((0 0, 2 0, 1 1, 2 2, 0 2, 1 1))"), "ok") << "pinched at a vertex";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (0 0, 2 1, 1 2))"), "ok")
        << "a hole at a corner";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (2 0, 3 2, 1 2))"), "ok")
        << "a hole at an edge";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (1 0, 2 0, 2 1))"), "self_intersection");
    EXPECT_EQ(verdict("POLYGON ((0 0, 6 0, 6 4, 0 4), (1 1, 3 2, 1 3), (5 1, 5 3, 3 2))"), "ok")
        << "two holes";
    EXPECT_EQ(verdict("POLYGON ((0 0, 6 0, 6 4, 0 4), (1 1, 3 1, 3 3), (3 1, 3 3, 5 1))"),
              "self_intersection");
}

TEST(Scene2Degenerate, ARingThatGoesAroundItselfIsFineAsLongAsItDoesNotCross) {
    // The outer chain returns to (0, 0) and goes round a free triangle.
    EXPECT_EQ(verdict("POLYGON ((0 0, 6 -3, 6 3, 0 0, 4 1, 4 -1))"), "ok");
    EXPECT_EQ(verdict("POLYGON ((0 0, 6 -3, 6 3, 0 0, 4 -1, 4 1))"), "self_intersection")
        << "the same set, but the chains cross in (0, 0)";
}

TEST(Scene2Degenerate, ThreeArmsWhoseChainsCrossAreRefused) {
    // Three clockwise arms leave (0, 0): visited clockwise the chains nest, counter-clockwise they
    // cross, although the sides fit in both.
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 1, 4 -1, 0 0, -4 -4, -4 -3, 0 0, -4 3, -4 4))"), "ok");
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 1, 4 -1, 0 0, -4 3, -4 4, 0 0, -4 -4, -4 -3))"),
              "self_intersection");
}

TEST(Scene2Degenerate, APointOnASealedContactIsInsideOfB) {
    const std::string sealed = std::string(box) + "POLYGON ((4 1, 8 1, 8 3, 4 3)) ";
    EXPECT_EQ(verdict(sealed + "POINT (4 2)"), "point_in_body");
    EXPECT_EQ(verdict(sealed + "POINT (4 1)"), "ok") << "the end of the contact is on the boundary";
    EXPECT_EQ(verdict(sealed + "POINT (4 0.5)"), "ok");
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 4, 8 4, 8 8, 4 8)) POINT (4 4)"), "ok")
        << "a pinhole";
    EXPECT_EQ(
        verdict(std::string(box) + "POLYGON ((4 0, 8 0, 8 4, 4 4)) POLYGON ((0 4, 4 4, 4 8, 0 8)) "
                                   "POLYGON ((4 4, 8 4, 8 8, 4 8)) POINT (4 4)"),
        "point_in_body")
        << "four boxes close the place";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (0 0, 2 0, 2 2, 0 2)) POINT (0 1)", true),
              "point_in_body")
        << "between a body and the world's outside";
}

TEST(Scene2Degenerate, WallsMayTouchBodiesAndRunAlongThem) {
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (-1 0, 5 0)"), "ok");
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (1 0, 3 0)"), "ok");
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (-1 1, 1 -1)"), "ok")
        << "through a corner, outside";
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (2 4, 2 6)"), "ok") << "from an edge";
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (4 4, 6 7)"), "ok") << "from a vertex";
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (2 4, 2 3)"), "wall_crosses_body");
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (0 0, 4 4)"), "wall_crosses_body")
        << "a diagonal";
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (-1 -1, 5 5)"), "wall_crosses_body");
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (0 2, 4 2)"), "wall_crosses_body")
        << "from edge to edge";
    EXPECT_EQ(verdict(std::string(box) + "LINESTRING (1 1, 2 2)"), "wall_crosses_body")
        << "wholly inside";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (0 0, 2 1, 1 2)) LINESTRING (0 0, 1.5 1.5)"),
              "ok")
        << "into a hole that touches a corner";
    EXPECT_EQ(verdict("POLYGON ((0 0, 4 0, 4 4, 0 4), (0 0, 2 1, 1 2)) LINESTRING (0 0, 3 3)"),
              "wall_crosses_body");
    EXPECT_EQ(verdict(std::string(box) + "POLYGON ((4 0, 8 0, 8 4, 4 4)) LINESTRING (4 -1, 4 5)"),
              "ok")
        << "along a sealed contact";
}

TEST(Scene2Degenerate, WallsMayCrossAndOverlapEachOther) {
    EXPECT_EQ(verdict("LINESTRING (0 0, 4 4) LINESTRING (0 4, 4 0) LINESTRING (0 0, 2 2) "
                      "LINESTRING (0 0, 1 0, 0 0)"),
              "ok");
}

TEST(Scene2Degenerate, CoordinatesMayBeTinyAndHuge) {
    EXPECT_EQ(verdict("POLYGON ((0 0, 5e-324 0, 0 5e-324))"), "ok");
    EXPECT_EQ(verdict("POLYGON ((-1e300 -1e300, 1e300 -1e300, 0 1e300), (-1 -1, 1 -1, 0 1))"),
              "ok");
    EXPECT_EQ(verdict("POLYGON ((0 0, 1.1235582092889474e307 0, 0 1))"), "ok") << "2^1020";
    EXPECT_EQ(verdict("POLYGON ((0 0, 1.1235582092889476e307 0, 0 1))"), "coordinate_too_large");
}

TEST(Scene2Degenerate, OneUlpDecides) {
    EXPECT_EQ(verdict("POLYGON ((0 0, 1 0, 0 1)) POLYGON ((1 1, 0.5 0.5, 1 0))"), "ok");
    EXPECT_EQ(verdict("POLYGON ((0 0, 1 0, 0 1)) POLYGON ((1 1, 0.49999999999999994 0.5, 1 0))"),
              "body_overlap");
    EXPECT_EQ(verdict("POLYGON ((0 0, 1 0, 0 1)) POINT (0.5 0.49999999999999994)"),
              "point_in_body");
    EXPECT_EQ(verdict("POLYGON ((0 0, 1 0, 0 1)) POINT (0.5 0.5)"), "ok");
}

}  // namespace
}  // namespace sightline
