// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices of boxes, and bodies that touch.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

/// Calls f(cell) in the order of layers, rows, columns.
template <typename F>
void for_each_cell(const Grid3& grid, F f) {
    SIGHTLINE_EXPECT(grid.columns >= 1 && grid.columns <= 100);
    SIGHTLINE_EXPECT(grid.rows >= 1 && grid.rows <= 100);
    SIGHTLINE_EXPECT(grid.layers >= 1 && grid.layers <= 100);
    for (std::size_t k = 0; k < grid.layers; ++k) {
        for (std::size_t j = 0; j < grid.rows; ++j) {
            for (std::size_t i = 0; i < grid.columns; ++i) {
                f(Int3{static_cast<std::int64_t>(i), static_cast<std::int64_t>(j),
                       static_cast<std::int64_t>(k)});
            }
        }
    }
}

constexpr Int3 diagonal{1, 1, 1};

}  // namespace

SceneInput3 grid3(const Grid3& parameters, std::uint64_t /*seed*/) {
    MeshBuilder mesh;
    for_each_cell(parameters, [&](Int3 cell) { mesh.add_box(2 * cell, 2 * cell + diagonal); });
    return mesh.take_scene();
}

SceneInput3 rotated_grid3(const Grid3& parameters, std::uint64_t /*seed*/) {
    MeshBuilder mesh;
    const Turn turn = turn_of(3, 1, 2, 1);
    for_each_cell(parameters,
                  [&](Int3 cell) { mesh.add_turned_box(turn, {}, 2 * cell, 2 * cell + diagonal); });
    return mesh.take_scene();
}

SceneInput3 perturbed_grid3(const Grid3& parameters, std::uint64_t seed) {
    Rng rng(seed);
    MeshBuilder mesh;
    constexpr std::int64_t side = 1 << 12;
    for_each_cell(parameters, [&](Int3 cell) {
        while (true) {
            Ring3 corners;
            for (int i = 0; i < 8; ++i) {
                const Int3 corner = 2 * cell + Int3{i & 1, i >> 1 & 1, i >> 2};
                const auto move = [&rng] { return rng.between(-side / 4, side / 4); };
                const std::int64_t x = move();
                const std::int64_t y = move();
                corners.push_back(side * corner + Int3{x, y, move()});
            }
            const ConvexSolid solid = convex_hull(corners);
            if (!solid.simplicial || solid.vertices.size() != 8) continue;
            mesh.add(solid);
            return;
        }
    });
    return mesh.take_scene();
}

SceneInput3 turned_grid3(const Grid3& parameters, std::uint64_t seed) {
    Rng rng(seed);
    MeshBuilder mesh;
    // A turned box stays within its circumscribed ball, of √3 half sides; the spacing is 4 half sides.
    constexpr std::int64_t half = 1 << 13;
    for_each_cell(parameters, [&](Int3 cell) {
        const Turn turn = random_turn(rng);
        const Int3 reach = half / turn.length * diagonal;
        mesh.add_turned_box(turn, 4 * half * cell, Int3{} - reach, reach);
    });
    return mesh.take_scene();
}

SceneInput3 checkerboard3(const Grid3& parameters, std::uint64_t /*seed*/) {
    MeshBuilder mesh;
    for_each_cell(parameters, [&](Int3 cell) {
        if ((cell.x + cell.y + cell.z) % 2 == 0) mesh.add_box(cell, cell + diagonal);
    });
    return mesh.take_scene();
}

SceneInput3 packed_grid3(const Grid3& parameters, std::uint64_t /*seed*/) {
    MeshBuilder mesh;
    for_each_cell(parameters, [&](Int3 cell) { mesh.add_box(cell, cell + diagonal); });
    return mesh.take_scene();
}

SceneInput3 touching(Contact contact) {
    MeshBuilder mesh;
    mesh.add_box({0, 0, 0}, {4, 4, 4});
    switch (contact) {
        case Contact::face:
            mesh.add_box({4, 0, 0}, {8, 4, 4});
            break;
        case Contact::partial_face:
            mesh.add_box({4, 2, 1}, {8, 6, 5});
            break;
        case Contact::box_on_table:
            mesh.add_box({1, 1, 4}, {2, 3, 7});
            break;
        case Contact::edge:
            mesh.add_box({4, 4, 0}, {8, 8, 4});
            break;
        case Contact::partial_edge:
            mesh.add_box({4, 4, 1}, {8, 8, 6});
            break;
        case Contact::edge_on_face:
            mesh.add_prism({{1, 1, 4}, {0, 1, 6}, {2, 1, 7}}, {0, 2, 0});
            break;
        case Contact::vertex:
            mesh.add_box({4, 4, 4}, {8, 8, 8});
            break;
        case Contact::vertex_on_face:
            mesh.add_tetrahedron({2, 1, 4}, {1, 1, 7}, {4, 2, 8}, {2, 3, 7});
            break;
        case Contact::vertex_on_edge:
            mesh.add_tetrahedron({4, 2, 4}, {5, 1, 7}, {8, 2, 6}, {5, 4, 5});
            break;
        case Contact::edge_crossing:  // (3, 2, 5)…(5, 2, 3) crosses the edge x = z = 4 in (4, 2, 4)
            mesh.add_tetrahedron({3, 2, 5}, {5, 2, 3}, {6, 1, 6}, {6, 3, 6});
            break;
    }
    return mesh.take_scene();
}

SceneInput3 stacked_boxes(const Boxes& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.boxes >= 1 && parameters.boxes <= 100'000);
    Rng rng(seed);
    MeshBuilder mesh;
    Int3 low;
    Int3 high{16, 16, 4};
    for (std::size_t i = 0; i < parameters.boxes; ++i) {
        if (i > 0) {
            // The next covers a point of the top at least.
            const Int3 on{rng.between(low.x, high.x - 1), rng.between(low.y, high.y - 1), high.z};
            const std::int64_t left = rng.between(0, 12);
            const std::int64_t front = rng.between(0, 12);
            const std::int64_t right = rng.between(1, 12);
            const std::int64_t back = rng.between(1, 12);
            low = on - Int3{left, front, 0};
            high = on + Int3{right, back, rng.between(2, 8)};
        }
        mesh.add_box(low, high);
    }
    return mesh.take_scene();
}

SceneInput3 touching_chain3(const Boxes& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.boxes >= 1 && parameters.boxes <= 100'000);
    Rng rng(seed);
    MeshBuilder mesh;
    Int3 low;
    for (std::size_t i = 0; i < parameters.boxes; ++i) {
        const Int3 high = low + Int3{4, 4, 4};
        mesh.add_box(low, high);
        // Each step goes on in x, so that only neighbours touch: 0 whole, ±1…3 piece, ±4 border.
        const auto slip = [&rng] {
            constexpr std::array<std::int64_t, 7> slips{-4, -2, 0, 0, 1, 3, 4};
            return slips[rng.below(slips.size())];
        };
        const std::int64_t y = slip();
        low = low + Int3{4, y, slip()};
    }
    return mesh.take_scene();
}

SceneInput3 cubes_round_vertex(const Boxes& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.boxes >= 1 && parameters.boxes <= 8);
    Rng rng(seed);
    std::vector<std::int64_t> octants{0, 1, 2, 3, 4, 5, 6, 7};
    rng.shuffle(octants);
    octants.resize(parameters.boxes);
    std::sort(octants.begin(), octants.end());
    MeshBuilder mesh;
    for (const std::int64_t i : octants) {
        const Int3 low{-(i & 1), -(i >> 1 & 1), -(i >> 2)};
        mesh.add_box(low, low + diagonal);
    }
    return mesh.take_scene();
}

SceneInput3 two_boxes_triangle() {
    MeshBuilder mesh;
    const Turn left = turn_of(9, 1, 1, 2);
    const Turn right = turn_of(8, -1, 2, 1);
    mesh.add_turned_box(left, {-900, 0, 0}, {-2, -2, -2}, {2, 2, 2});
    mesh.add_turned_box(right, {900, 60, 40}, {-2, -3, -2}, {2, 2, 3});
    mesh.add_prism({{-20, -260, -340}, {40, 300, -180}, {10, 20, 330}}, {24, -3, 2});
    return mesh.take_scene();
}

}  // namespace sightline::families
