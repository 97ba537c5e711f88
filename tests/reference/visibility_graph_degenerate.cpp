// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs of hard little scenes, found by hand from the rules of semantics 2.4 and 4.1.
// `nearest` is the whole graph with nearest_only; `more` is what every_vertex adds to it.
#include <gtest/gtest.h>

#include "sightline/reference/visibility_graph.hpp"
#include "support/corpus.hpp"
#include "support/graphs.hpp"

namespace sightline {
namespace {

using testing::degenerate_scene;
using testing::same_graph;

struct Golden {
    const char* scene;
    const char* nearest;
    const char* more;
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.scene; }

const Golden goldens[] = {
    {"triangle", "0-1 0-2 1-2", ""},
    // The point sees the sides, and the top straight below it.
    {"triangle_and_point_above", "0-1 0-2 1-2 0-3 1-3 2-3", ""},
    // On the base line 0, 1, 3, 4 each sees its neighbour; 0-5 and 2-4 would cut a triangle's inside.
    {"two_triangles_on_a_line", "0-1 0-2 1-2 1-3 1-5 2-3 2-5 3-4 3-5 4-5", "0-3 0-4 1-4"},
    // 1 and 5 are one place: same neighbours, not each other. Through the pinhole run the line of the
    // points (6-7) and the lines along an edge of one triangle and then of the other (0-4, 2-3).
    {"pinhole", "0-1 0-5 0-2 0-3 0-6 1-2 1-3 1-4 1-6 1-7 2-4 2-5 2-7 3-4 3-5 3-6 4-5 4-7 5-6 5-7",
     "0-4 2-3 6-7"},
    // Through the common corner: straight along the right side of one and the left of the other, 1-7, and
    // along top and bottom, 3-5.
    {"diagonal_squares", "0-1 0-3 1-2 1-4 1-5 2-3 2-5 2-7 3-4 3-7 4-5 4-7 5-6 6-7", "1-7 3-5"},
    // The common edge is interior to B: its ends do not see each other. Top and bottom are straight.
    {"shared_edge", "0-1 0-3 0-4 1-5 2-3 2-6 3-7 4-5 5-6 6-7", "0-5 3-6"},
    // The table's top is free on both sides of the box and sealed under it: 0-1 is blocked for good.
    {"box_on_a_table", "0-3 0-4 0-7 1-2 1-5 1-6 2-3 4-7 5-6 6-7", ""},
    // A single point of contact seals nothing: along the top, 0-1 passes under the corner.
    {"corner_on_edge", "0-3 0-4 0-6 1-2 1-4 1-5 2-3 4-5 4-6 5-6", "0-1"},
    // The place in the middle is interior to B and sees nothing; the outline is a square with vertices in
    // the middle of its sides, two at each place.
    {"four_squares", "1-2 1-13 2-3 2-6 2-14 3-7 4-7 4-8 6-7 7-11 8-9 8-11 8-12 9-13 12-13 13-14",
     "2-7 2-13 7-8 8-13"},
    // Nothing is left of the hole.
    {"filled_hole", "0-1 0-3 1-2 2-3", ""},
    // The hole's corner 4 lies on the side 0-3: that side is cut there, and free; from 7 one sees through
    // 4 to 8 and no further aside.
    {"hole_touches_outer_ring", "0-1 0-4 0-7 1-2 2-3 3-4 3-7 4-5 4-6 4-7 4-8 5-6 5-8 6-8",
     "0-3 7-8"},
    // 2 and 5 are the pinch. Through it: straight across (6-7), and along an edge of each half.
    {"pinch_corner", "0-1 0-2 0-5 0-6 1-2 1-5 1-7 2-3 2-4 2-6 2-7 3-4 3-5 3-7 4-5 4-6 5-6 5-7",
     "0-3 0-4 1-3 1-4 6-7"},
    // 6, 0, 3, 7 lie on one line that has a body above at 0 and one below at 3: grazing both is free.
    {"zero_width_corridor",
     "0-1 0-2 0-3 0-4 0-6 1-2 1-3 1-4 1-5 1-7 2-4 2-6 3-4 3-5 3-7 4-5 4-6 5-7", "0-7 3-6 6-7"},
    {"collinear_points", "0-1 1-2 2-3", "0-2 0-3 1-3"},
    {"coincident_points", "0-2 1-2", ""},
    // The point cuts the edge; the far corner is behind the body.
    {"point_on_edge", "0-2 0-3 1-2 1-3", "0-1"},
    // The point has the edges of the corner that it lies on.
    {"point_on_corner", "0-1 0-2 0-3 1-2 2-3", ""},
    // The needle blocks; at its thick end 3 lies behind the corner 1 and 4 behind the corner 2.
    {"thinnest_needle", "0-1 0-2 0-3 0-4 1-2 1-4 2-3", ""},
    // 4 is below the line of the upper edge by one ulp, so that 0 and 3 do not see it; 5 is above it.
    {"one_ulp", "0-1 0-2 0-3 0-5 1-2 1-4 1-5 2-3 2-4 2-5 3-5 4-5", "1-3"},
    {"wall_between_points", "0-1 0-2 0-3 1-2 1-3", ""},
    // 2-3 passes the free end 0 of the wall: one goes round it.
    {"wall_end_grazed", "0-1 0-2 0-3 1-2 1-3", "2-3"},
    // 3-4 grazes the tip 1 from below and stays there; 5-6 would enter the V at its tip.
    {"wall_v", "0-1 0-3 0-5 0-6 1-2 1-3 1-4 1-5 1-6 2-4 2-5 2-6 3-5 4-5", "0-2 3-4"},
    // The stem 2-3 hides the sides from each other; past its free end 3 they see each other (4-5).
    {"wall_t", "0-2 0-3 0-4 1-2 1-3 1-5 2-3 2-4 2-5 3-4 3-5", "0-1 4-5"},
    // Each wall runs free along itself. 4-5 goes through the crossing, to the opposite sector: blocked.
    {"wall_x", "0-1 0-2 0-3 0-4 1-2 1-3 1-5 2-3 2-4 3-5", ""},
    // 3-4 touches the corner from outside; 5, inside, sees neither 3 nor 4. 0-2 passes 5.
    {"wall_l", "0-1 0-3 0-5 1-2 1-3 1-4 1-5 2-4 2-5", "0-2 3-4"},
    // A point on the wall sees both sides; 3-4 still crosses the wall there.
    {"point_on_wall", "0-2 0-3 0-4 1-2 1-3 1-4 2-3 2-4", "0-1"},
    // 0 and 4 close the ring at one place: both have the edges of the other. 5 is in, 6 is out.
    {"wall_ring", "0-1 0-2 0-3 0-5 1-2 1-3 1-4 1-5 1-6 2-3 2-4 2-5 2-6 3-4 3-5 4-5", ""},
    // 1-2 along the body would cross the wall where that ends on the body: sealed.
    {"wall_ends_on_body", "0-1 0-3 1-4 1-5 2-3 2-4 2-5 4-5", ""},
    // The wall runs on top of the box and beyond. 7-6 would pass from below the wall to above it at the
    // corner 3, between wall and box there is nothing: blocked. 4-5 runs along the wall all the way.
    {"wall_along_body_edge", "0-1 0-3 0-4 0-7 1-2 1-5 2-3 2-5 2-6 3-4 3-6 3-7 4-6 4-7 5-6",
     "2-4 3-5 4-5"},
    // Left and right of the pinhole are separated by the bodies alone, so that the wall, which cuts both
    // sides in two, is not what separates 8 from 9, 0 from 4, 2 from 3: these pass.
    {"wall_through_pinhole",
     "0-1 0-2 0-5 0-6 0-8 1-2 1-3 1-4 1-6 1-7 1-8 1-9 2-5 2-7 3-4 3-5 3-6 4-5 4-7 4-9 5-6 5-7 5-8 "
     "5-9 6-8 7-9",
     "0-4 2-3 6-7 8-9"},
    // Below and above are separated: 10 does not see 11, and neither do the corners across the wall. The
    // sides 1-2 and 4-7 would cross the wall at its ends.
    {"wall_between_bodies",
     "0-1 0-3 0-10 1-4 1-8 1-9 1-10 2-3 2-7 2-8 2-9 2-11 3-11 4-5 4-8 4-9 4-10 5-6 5-10 6-7 6-11 "
     "7-8 "
     "7-9 7-11 8-9 8-10 8-11 9-10 9-11",
     "0-4 0-5 1-5 2-6 3-6 3-7"},
    // Along the whole wall from 6 to 7: before it one is above and below left (round the end 0), after it
    // above and below right (round the end 1); the branches at 2 and 4 separate the two: blocked. From the
    // ends of the wall, and to them, nothing is crossed.
    {"wall_with_two_branches",
     "0-2 0-3 0-5 0-6 1-3 1-4 1-5 1-7 2-3 2-4 2-5 3-4 3-6 3-7 4-5 5-6 5-7",
     "0-1 0-4 0-7 1-2 1-6 2-6 2-7 4-6 4-7"},
    {"world_alone", "0-1 0-2 0-3 1-2 1-3 2-3", ""},
    // The hole's lowest corner 4 touches the world's boundary: a pinhole along it (0-1). The lines of its
    // sides go on to the upper corners (2-4, 3-4), the lines of the diagonals graze 5 and 6.
    {"world_with_touching_hole", "0-3 0-4 0-6 1-2 1-4 1-5 2-3 2-5 2-6 3-5 3-6 4-5 4-6 5-6",
     "0-1 0-2 1-3 2-4 3-4"},
    // The notch 3 hides the two upper corners from each other; the lower ones see the upper past it or,
    // straight through it, 0-2... from 5, everything is seen.
    {"world_not_convex", "0-1 0-3 0-4 0-5 1-2 1-3 1-5 2-3 3-4 3-5 2-5 4-5", "0-2 1-4"},
};

TEST(DegenerateScenes, are_valid) {
    for (const auto& [name, text] : testing::degenerate_scenes()) {
        const auto scene = Scene2::make(testing::scene_input(text));
        EXPECT_TRUE(scene.has_value()) << name << ": " << scene.error().message;
    }
}

class GoldenGraph : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenGraph, nearest_only) {
    const Scene2 scene = degenerate_scene(GetParam().scene);
    EXPECT_TRUE(same_graph(reference::visibility_graph(scene), GetParam().nearest));
}

TEST_P(GoldenGraph, every_vertex) {
    const Scene2 scene = degenerate_scene(GetParam().scene);
    const auto graph = reference::visibility_graph(scene, {.collinear = Collinear::every_vertex});
    EXPECT_TRUE(
        same_graph(graph, std::string(GetParam().nearest).append(" ").append(GetParam().more)));
}

TEST_P(GoldenGraph, rows_are_those_of_the_graph) {
    const Scene2 scene = degenerate_scene(GetParam().scene);
    const auto graph = reference::visibility_graph(scene);
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        const auto row = graph.neighbours(VertexId{i});
        EXPECT_EQ(reference::visible_from(scene, VertexId{i}),
                  std::vector<VertexId>(row.begin(), row.end()));
    }
}

INSTANTIATE_TEST_SUITE_P(Degenerate, GoldenGraph, ::testing::ValuesIn(goldens),
                         [](const auto& golden) { return std::string(golden.param.scene); });

VisibilityGraph tangent_graph(const std::string& name) {
    return reference::visibility_graph(degenerate_scene(name), {.tangent_only = true});
}

// 3-2 hits the top of the triangle from above: going on, it would enter.
TEST(TangentGraph, leaves_out_what_ends_head_on) {
    EXPECT_TRUE(same_graph(tangent_graph("triangle_and_point_above"), "0-1 0-2 1-2 0-3 1-3"));
}

// Both common outer and both inner tangents, and the edges: the whole graph.
TEST(TangentGraph, keeps_bitangents_and_edges) {
    EXPECT_TRUE(same_graph(tangent_graph("two_triangles_on_a_line"),
                           "0-1 0-2 1-2 1-3 1-5 2-3 2-5 3-4 3-5 4-5"));
}

// At the tip, lines from straight below (5) and from inside (6) would cross; those that graze it don't.
TEST(TangentGraph, grazes_the_tip_of_a_v) {
    EXPECT_TRUE(
        same_graph(tangent_graph("wall_v"), "0-1 0-3 0-5 0-6 1-2 1-3 1-4 2-4 2-5 2-6 3-5 4-5"));
}

// All lines to the pinhole from the sides go on into the other side; 1 and 5 are one place, judged as one.
TEST(TangentGraph, goes_on_through_a_pinhole) {
    const auto graph = tangent_graph("pinhole");
    EXPECT_TRUE(graph.has_edge(VertexId{6}, VertexId{1}));
    EXPECT_TRUE(graph.has_edge(VertexId{6}, VertexId{5}));
    EXPECT_TRUE(graph.has_edge(VertexId{0}, VertexId{5}));
    EXPECT_TRUE(graph.has_edge(VertexId{2}, VertexId{7}));
    EXPECT_FALSE(tangent_graph("corner_on_edge").has_edge(VertexId{4}, VertexId{2}));
}

// In a convex room no corner is grazed, and its walls end where the world ends.
TEST(TangentGraph, of_a_convex_world_is_empty) {
    EXPECT_TRUE(same_graph(tangent_graph("world_alone"), ""));
}

VisibilityGraph without_edges(const std::string& name, Collinear collinear) {
    return reference::visibility_graph(degenerate_scene(name),
                                       {.collinear = collinear, .body_edges = false});
}

TEST(WithoutBodyEdges, leaves_out_what_runs_along_boundaries) {
    EXPECT_TRUE(same_graph(without_edges("two_triangles_on_a_line", Collinear::nearest_only),
                           "1-3 1-5 2-3 2-5"));
    EXPECT_TRUE(same_graph(without_edges("world_alone", Collinear::nearest_only), "0-2 1-3"));
    EXPECT_TRUE(same_graph(without_edges("wall_between_points", Collinear::nearest_only),
                           "0-1 0-2 0-3 1-2 1-3"));
}

// 0-3 runs along an edge and then through the open: it stays. The table's top 0-1 is all boundary.
TEST(WithoutBodyEdges, keeps_what_leaves_the_boundary) {
    EXPECT_TRUE(same_graph(without_edges("two_triangles_on_a_line", Collinear::every_vertex),
                           "0-3 0-4 1-3 1-4 1-5 2-3 2-5"));
    EXPECT_FALSE(without_edges("corner_on_edge", Collinear::every_vertex)
                     .has_edge(VertexId{0}, VertexId{1}));
}

}  // namespace
}  // namespace sightline
