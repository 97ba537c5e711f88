// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of docs/structures/shooting.md. To draw it anew:
//   SIGHTLINE_BLESS=1 build/release/bin/test_viz --gtest_filter=ShootingFigure.*
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "sightline/spatial/shooting.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/draw3.hpp"
#include "sightline/viz/render.hpp"
#include "support/scenes3.hpp"

namespace sightline::viz {
namespace {

constexpr Point3 eye{6, -6, 6};

// Two boxes with a slit between them, and a sheet.
Scene3 figure_scene() {
    return sightline::testing::scene3(
        "box 0 0 0, 4 4 4; box 4 4 0, 8 8 3; sheet 7 0 0, 11 0 0, 11 0 3, 7 0 3");
}

struct Aim {
    Point3 at;
    std::size_t faces;  // at which the ray ends; 0: it goes on
};

const Aim aims[] = {
    {{2, 0, 2}, 1},    // inside of a face
    {{2, 0, 4}, 2},    // an edge
    {{4, 0, 4}, 3},    // a corner
    {{9, 0, 1.5}, 1},  // the sheet
    {{11, 0, 2}, 0},   // its border
    {{0, 2, 4}, 0},    // over an edge of the top
    {{4, 4, 2}, 0},    // the slit
};

DrawList figure() {
    const Scene3 scene = figure_scene();
    const Camera camera{{0.9, -1, 0.55}, {0, 0, 1}};
    DrawList list = draw(scene, {.title = "Rays from one point", .camera = camera});
    Layer ending{.name = "ending",
                 .legend = "rays that end",
                 .order = PaintOrder::graphs,
                 .style = {.colour = Palette::vermilion, .width = 2.5}};
    Layer free{.name = "free",
               .legend = "rays that graze: border, edge, slit",
               .order = PaintOrder::graphs,
               .style = {.colour = Palette::blue, .width = 2.5}};
    Layer ends{.name = "ends",
               .order = PaintOrder::graphs,
               .style = {.colour = Palette::vermilion, .marker = Marker::disc}};
    const Position from{eye.x, eye.y, eye.z};
    SegmentShooter shooter(scene);
    for (const Aim& aim : aims) {
        const FreeEnd3 end = shooter.first_hit(eye, aim.at);
        const auto beyond = [](double a, double b) { return a + 1.6 * (b - a); };
        Position to{beyond(eye.x, aim.at.x), beyond(eye.y, aim.at.y), beyond(eye.z, aim.at.z)};
        if (end.point) {
            const Point3 p = approx_point(*end.point);
            to = {p.x, p.y, p.z};
            ends.points.push_back(to);
        }
        Layer& layer = end.point ? ending : free;
        layer.segments.push_back(from);
        layer.segments.push_back(to);
        ++layer.count;
    }
    list.add(std::move(ending));
    list.add(std::move(free));
    list.add(std::move(ends));
    list.add({.name = "eye",
              .legend = "where they start",
              .order = PaintOrder::graphs,
              .style = {.marker = Marker::disc, .marker_size = 8},
              .points = {from}});
    return list;
}

TEST(ShootingFigure, RaysEndAtAsManyFacesAsMeetThere) {
    const Scene3 scene = figure_scene();
    SegmentShooter shooter(scene);
    for (const Aim& aim : aims) {
        EXPECT_EQ(shooter.first_hit(eye, aim.at).faces.size(), aim.faces) << aim.at;
    }
}

TEST(ShootingFigure, ShowsFourRaysThatEndAndThreeThatGraze) {
    const DrawList list = figure();
    ASSERT_NE(list.find("ending"), nullptr);
    EXPECT_EQ(list.find("ending")->count, 4U);
    EXPECT_EQ(list.find("ends")->points.size(), 4U);
    ASSERT_NE(list.find("free"), nullptr);
    EXPECT_EQ(list.find("free")->count, 3U);
    if (std::getenv("SIGHTLINE_BLESS") == nullptr) return;
    const auto drawn = render_png(list, SIGHTLINE_TESTS_DIR "/../docs/figures/shooting.png",
                                  {.width = 900, .supersampling = 3});
    EXPECT_TRUE(drawn) << drawn.error().message;
}

}  // namespace
}  // namespace sightline::viz
