// SPDX-License-Identifier: GPL-3.0-or-later
// Named degenerate 3D scenes, small enough for brute force.
#pragma once

#include <map>
#include <string>

#include "support/scenes3.hpp"

namespace sightline::testing {

/// Text of each scene (see scene_input3) by name.
using Corpus3 = std::map<std::string, std::string>;

inline const Corpus3& degenerate_scenes3() {
    static const Corpus3 corpus{
        {"tetrahedron", "family tetrahedron"},
        {"cube", "family cube"},
        {"octahedron", "family octahedron"},
        {"notched_cube", "family notched-cube"},
        {"l_shape", "family l-shape"},
        {"u_shape", "family u-shape"},
        {"ring", "family ring"},
        {"triangle", "sheet 0 0 0, 4 0 0, 0 4 0"},
        {"two_triangles_in_a_plane", "sheet 0 0 0, 4 0 0, 0 4 0; sheet 6 6 0, 9 6 0, 6 9 0"},
        {"two_parallel_triangles", "sheet 0 0 0, 4 0 0, 0 4 0; sheet 0 0 3, 4 0 3, 0 4 3"},
        {"touching_face", "family touching-face"},
        {"touching_partial_face", "family touching-partial-face"},
        {"box_on_table", "family touching-box-on-table"},
        {"touching_edge", "family touching-edge"},
        {"touching_partial_edge", "family touching-partial-edge"},
        {"touching_edge_on_face", "family touching-edge-on-face"},
        {"touching_vertex", "family touching-vertex"},
        {"touching_vertex_on_face", "family touching-vertex-on-face"},
        {"touching_vertex_on_edge", "family touching-vertex-on-edge"},
        {"touching_edge_crossing", "family touching-edge-crossing"},
        {"two_boxes_aligned", "box 0 0 0, 1 1 1; box 3 0 0, 4 1 1"},
        {"two_boxes_in_a_plane", "box 0 0 0, 2 2 2; box 3 1 0, 5 5 1"},
        {"three_boxes_in_a_row", "box 0 0 0, 1 1 1; box 2 0 0, 3 1 1; box 4 0 0, 5 1 1"},
        {"grid_2x2x1", "family grid3 2 2 1"},
        {"grid_2x2x2", "family grid3 2 2 2"},
        {"checkerboard_2x2x1", "family checkerboard3 2 2 1"},
        {"checkerboard_2x2x2", "family checkerboard3 2 2 2"},
        {"eight_cubes_round_a_vertex", "family cubes-round-vertex 8"},
        {"five_cubes_round_a_vertex", "family cubes-round-vertex 5"},
        {"stack_of_four", "family stack 4"},
        {"chain_of_four", "family chain3 4"},
        {"vertex_in_a_face_plane",
         "hull 0 0 0, 4 0 0, 0 4 0, 1 1 -3; hull 5 5 0, 7 6 2, 6 7 3, 8 8 1"},
        {"edge_in_a_face_plane",
         "hull 0 0 0, 4 0 0, 0 4 0, 1 1 -3; hull 5 5 0, 9 6 0, 6 7 3, 8 8 2"},
        {"faces_in_a_plane", "hull 0 0 0, 4 0 0, 0 4 0, 1 1 -3; hull 5 5 0, 9 6 0, 6 9 0, 7 7 3"},
        {"edges_on_a_line", "hull 0 0 0, 2 0 0, 1 2 1, 1 1 3; hull 4 0 0, 7 0 0, 5 2 2, 6 1 4"},
        {"room_with_box", "world; box 0 0 0, 8 8 8; box 2 3 1, 5 5 4"},
        {"room_with_box_on_floor", "world; box 0 0 0, 8 8 8; box 2 3 0, 5 5 4"},
    };
    return corpus;
}

/// One of them.
inline Scene3 degenerate_scene3(const std::string& name) {
    return scene3(degenerate_scenes3().at(name));
}

}  // namespace sightline::testing
