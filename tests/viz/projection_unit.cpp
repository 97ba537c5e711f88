// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "sightline/scene/result.hpp"
#include "sightline/viz/draw_list.hpp"
#include "sightline/viz/svg.hpp"
#include "viz/pictures.hpp"
#include "viz/spaces.hpp"

namespace sightline::viz {
namespace {

/// Where the camera sees points.
std::vector<Position> seen(const Camera& camera, std::vector<Position> points) {
    DrawList list;
    list.camera = camera;
    list.add({.name = "points", .points = std::move(points)});
    return projected(list).layers.at(0).points;
}

void expect_near(const Position& a, const Position& b) {
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Projection, FromAboveXIsRightYIsUpAndZIsNear) {
    const auto p = seen({.from = {0, 0, 7}, .up = {0, 1, 0}}, {{1, 2, 3}});
    expect_near(p[0], {1, 2, 3});
}

TEST(Projection, FromTheFrontZIsUpAndYIsFar) {
    const auto p = seen({.from = {0, -1, 0}}, {{1, 2, 3}});
    expect_near(p[0], {1, 3, -2});
}

TEST(Projection, IsometricAxesHaveEqualLengthsAndLieAt120Degrees) {
    const auto p = seen({}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const double side = std::sqrt(2.0 / 3);
    for (const Position& axis : p) EXPECT_NEAR(std::hypot(axis.x, axis.y), side, 1e-12);
    expect_near(p[2], {0, side, std::sqrt(1.0 / 3)});
    EXPECT_NEAR(p[0].x * p[2].x + p[0].y * p[2].y, -side * side / 2, 1e-12);
    EXPECT_GT(p[0].x, 0) << "x to the right";
    EXPECT_GT(p[1].x, 0) << "y to the right too, into the depth";
    EXPECT_LT(p[1].z, 0);
}

TEST(Projection, LengthsAndHandednessStay) {
    const Camera camera{.from = {0.3, -2, 1.1}, .up = {0.2, 0.1, 1}};
    const auto p = seen(camera, {{0, 0, 0}, {1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    EXPECT_NEAR(std::hypot(p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z), std::sqrt(14.0),
                1e-12);
    const double volume = p[2].x * (p[3].y * p[4].z - p[3].z * p[4].y) -
                          p[2].y * (p[3].x * p[4].z - p[3].z * p[4].x) +
                          p[2].z * (p[3].x * p[4].y - p[3].y * p[4].x);
    EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(Projection, UpwardsAlongTheViewIsReplaced) {
    const auto p = seen({.from = {0, 0, 1}, .up = {0, 0, 5}}, {{1, 2, 3}});
    expect_near(p[0], {1, 2, 3});
}

TEST(Projection, HugeAndTinyDirectionsAreDirections) {
    for (const double size : {0x1p-1000, 0x1p1000}) {
        const auto p = seen({.from = {0, -size, 0}, .up = {0, 0, size}}, {{1, 2, 3}});
        expect_near(p[0], {1, 3, -2});
    }
}

TEST(Projection, CameraNeedsADirection) {
    EXPECT_THROW((void)seen({.from = {0, 0, 0}}, {{1, 2, 3}}), ContractViolation);
}

TEST(Projection, ViewShowsTheWholeBox) {
    DrawList list = small_space();
    list.camera = Camera{};
    const DrawList flat = projected(list);
    const Box all = bounds(flat);
    EXPECT_LT(flat.view.low.x, all.low.x);
    EXPECT_GT(flat.view.high.y, all.high.y);
    EXPECT_LT(flat.view.low.z, flat.view.high.z);
}

TEST(Projection, PicturesOfThePlaneStay) { EXPECT_EQ(projected(small_picture()), small_picture()); }

TEST(Projection, CameraIsPrinted) {
    std::ostringstream text;
    text << small_space();
    EXPECT_THAT(text.str(), ::testing::HasSubstr("camera from 0 0 1 up 0 1\n"));
}

TEST(Projection, SvgHasNoDepth) {
    std::ostringstream out;
    EXPECT_THROW(write_svg(small_space(), out), ContractViolation);
}

}  // namespace
}  // namespace sightline::viz
