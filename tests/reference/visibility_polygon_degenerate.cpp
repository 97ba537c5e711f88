// SPDX-License-Identifier: GPL-3.0-or-later
// Views found by hand from semantics 4.2 and the canonical form in the header.
#include <gtest/gtest.h>

#include "sightline/reference/visibility_polygon.hpp"
#include "sightline/reference/visibility_polygon_cgal.hpp"
#include "support/corpus.hpp"
#include "support/views.hpp"

namespace sightline {
namespace {

using testing::degenerate_scene;
using testing::exact_point2;
using testing::scene2;
using testing::to_string;

std::string ring(const Scene2& scene, const std::string& from) {
    return to_string(reference::visibility_polygon(scene, exact_point2(from))->ring);
}

std::string needles(const Scene2& scene, const std::string& from) {
    const auto view = reference::visibility_polygon(scene, exact_point2(from),
                                                    {.needles = Needles::with_needles});
    return to_string(view->needles);
}

Errc error(const Scene2& scene, const std::string& from) {
    return reference::visibility_polygon(scene, exact_point2(from)).error().code;
}

TEST(ReferenceView, of_an_empty_plane_is_the_four_axis_directions) {
    const Scene2 scene = scene2("point 5 5");
    EXPECT_EQ(ring(scene, "0,0"), "@-1,0 @0,-1 @1,0 @0,1");
    EXPECT_EQ(ring(scene, "5,5"), "@-1,0 @0,-1 @1,0 @0,1");
}

TEST(ReferenceView, of_a_convex_world_is_the_world) {
    const Scene2 scene = degenerate_scene("world_alone");
    EXPECT_EQ(ring(scene, "1,1/3"), "0,0 4,0 4,4 0,4");
    EXPECT_EQ(ring(scene, "0,1"),
              "0,0 4,0 4,4 0,4");  // on the boundary: the viewpoint is no corner
    EXPECT_EQ(ring(scene, "4,4"), "0,0 4,0 4,4 0,4");
}

// The wall's shadow is a sector; the rest of the plane spans more than 180°, so that the axes between its
// bounding directions are vertices at infinity: up, left and down.
TEST(ReferenceView, past_a_wall_is_unbounded) {
    EXPECT_EQ(ring(scene2("wall 1 -1, 1 1"), "0,0"), "1,-1 1,1 @1,1 @0,1 @-1,0 @0,-1 @1,-1");
}

// A body below hides less than 180° of what is below; seen from a point of its long edge it hides 180°.
TEST(ReferenceView, from_an_edge_is_a_half_plane) {
    const Scene2 scene = scene2("0 0, 4 0, 2 -3");
    EXPECT_EQ(ring(scene, "2,0"), "2,0 @1,0 @0,1 @-1,0");
    // From the corner: the free sector is 360° less the triangle's angle, from the edge 0-1 on.
    EXPECT_EQ(ring(scene, "0,0"), "0,0 @1,0 @0,1 @-1,0 @0,-1 @2/3,-1");
}

TEST(ReferenceView, has_no_answer_inside_a_body) {
    EXPECT_EQ(error(degenerate_scene("triangle"), "1,1"), Errc::inside_body);
    // On the common edge of two bodies one is inside their union; at its ends one isn't.
    EXPECT_EQ(error(degenerate_scene("shared_edge"), "1,1/2"), Errc::inside_body);
    EXPECT_EQ(ring(degenerate_scene("shared_edge"), "1,1"), "1,1 @1,0 @0,1 @-1,0");
    EXPECT_EQ(error(degenerate_scene("four_squares"), "0,0"), Errc::inside_body);
    EXPECT_EQ(error(degenerate_scene("world_alone"), "5,1"), Errc::outside_of_world);
    EXPECT_EQ(error(degenerate_scene("world_with_touching_hole"), "3,1"), Errc::inside_body);
}

TEST(ReferenceView, names_the_body) {
    const auto view = reference::visibility_polygon(degenerate_scene("two_triangles_on_a_line"),
                                                    exact_point2("6,1"));
    EXPECT_NE(view.error().message.find("b1"), std::string::npos) << view.error().message;
}

// Through the pinhole at the origin goes one line of sight, from the origin to infinity.
TEST(ReferenceView, through_a_pinhole_is_a_needle) {
    const Scene2 scene = degenerate_scene("pinhole");
    EXPECT_EQ(needles(scene, "-3,0"), "0,0..@1,0 ");
    EXPECT_EQ(needles(scene, "-3,1"), "0,0..@1,-1/3 ");
    EXPECT_EQ(needles(scene, "-3,4"), "");  // the origin is hidden
    EXPECT_EQ(ring(scene, "-3,0"), "-2,-2 0,0 -2,2 @1/2,1 @0,1 @-1,0 @0,-1 @1/2,-1");
}

// In the hole of a body, through the hole's corner on the outer ring: to infinity on the other side.
TEST(ReferenceView, through_a_pinhole_in_an_edge) {
    const Scene2 scene = degenerate_scene("hole_touches_outer_ring");
    EXPECT_EQ(ring(scene, "2,3"), "0,3 3,2 3,4");
    EXPECT_EQ(needles(scene, "2,3"), "0,3..@-1,0 ");
    EXPECT_EQ(needles(scene, "-2,3"), "0,3..3,3 ");
}

// The viewpoint is the pinhole: it sees both sides, and is a corner of the ring twice.
TEST(ReferenceView, from_a_pinhole_sees_both_sides) {
    EXPECT_EQ(ring(degenerate_scene("pinhole"), "0,0"), "0,0 @-1,1 @-1,-1 0,0 @1,-1 @1,1");
    EXPECT_EQ(ring(degenerate_scene("world_with_pinch_corner"), "2,2"), "0,0 2,2 4,0 4,4 2,2 0,4");
}

// Corners of two bodies on one line on alternate sides: the corridor of no width is a needle.
TEST(ReferenceView, along_a_corridor_of_no_width_is_a_needle) {
    const Scene2 scene = degenerate_scene("zero_width_corridor");
    EXPECT_EQ(needles(scene, "-1,0"), "2,0..@1,0 ");
}

TEST(ReferenceView, from_a_wall_sees_both_sides) {
    EXPECT_EQ(ring(scene2("world; polygon 0 0, 4 0, 4 4, 0 4; wall 1 2, 3 2"), "2,2"),
              "0,0 4,0 4,4 0,4");
    // From beside the wall its far side is hidden.
    EXPECT_EQ(ring(scene2("world; polygon 0 0, 4 0, 4 4, 0 4; wall 1 2, 3 2"), "2,1"),
              "0,0 4,0 4,3 3,2 1,2 0,3");
    // In line with the wall nothing is hidden: one sees along it.
    EXPECT_EQ(ring(scene2("world; polygon 0 0, 4 0, 4 4, 0 4; wall 1 2, 3 2"), "0,2"),
              "0,0 4,0 4,4 0,4");
    EXPECT_EQ(needles(scene2("world; polygon 0 0, 4 0, 4 4, 0 4; wall 1 2, 3 2"), "0,2"), "");
}

// Two walls cross at 3/2,3/2, which is no vertex of the scene; the view has a corner there.
TEST(ReferenceView, sees_the_crossing_of_two_walls) {
    EXPECT_EQ(ring(scene2("wall 0 0, 3 3; wall 0 3, 3 0"), "3/2,0"),
              "0,0 @-1,0 @0,-1 @1,0 3,0 3/2,3/2");
}

TEST(ReferenceView, is_closed_by_a_ring_of_walls) {
    EXPECT_EQ(ring(degenerate_scene("wall_ring"), "2,1"), "0,0 4,0 4,4 0,4");
    EXPECT_EQ(ring(degenerate_scene("grid_of_walls"), "1/2,1/2"), "0,0 1,0 1,1 0,1");
}

// The polygon on which CGAL's rotational sweep errs by one unit square.
TEST(ReferenceView, is_right_where_a_rotational_sweep_is_wrong) {
    const Scene2 scene = scene2(
        "world; polygon -3 -1, 0 -1, 0 -2, 1 -2, 1 -4, 3 -4, 3 -3, 2 -3, 2 -1, 5 -1, 5 1, 6 1, 6 "
        "3, 5 3, "
        "5 4, 6 4, 6 5, 4 5, 4 4, -2 4, -2 3, 0 3, 0 1, -1 1, -1 0, -3 0");
    const auto view = reference::visibility_polygon(scene, exact_point2("1/2,-3/2"));
    EXPECT_EQ(reference::twice_area(view->ring), Rational(6013, 99));  // area 30.3687, not 31.3687
    EXPECT_EQ(to_string(view->ring),
              to_string(reference::cgal_visibility_ring(scene, exact_point2("1/2,-3/2"))));
}

}  // namespace
}  // namespace sightline
