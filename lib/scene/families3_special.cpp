// SPDX-License-Identifier: GPL-3.0-or-later
// Special position, nearly special position, and coordinates of unusual sizes.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/scene/transform3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

void expect_in_range(const Aligned& parameters) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 10'000);
}

SceneInput3 finished(MeshBuilder& mesh, const Aligned& parameters, std::uint64_t seed) {
    SceneInput3 scene = mesh.take_scene();
    return parameters.near ? approx_nudged3(scene, seed) : scene;
}

/// Local coordinates to slanted ones.
Turn slanted() { return turn_of(3, 1, 2, 1); }

constexpr std::int64_t cell = 64;

/// The corner of the i-th cell of a square of cells in the plane z = 0.
Int3 cell_corner(std::size_t i, std::size_t count) {
    const std::int64_t columns = ceil_sqrt(count);
    const auto index = static_cast<std::int64_t>(i);
    return {cell * (index % columns), cell * (index / columns), 0};
}

/// A random point over the inner part of a cell, at a height between these.
Int3 over_cell(Rng& rng, std::int64_t low, std::int64_t high) {
    const std::int64_t x = rng.between(0, 48);
    const std::int64_t y = rng.between(0, 48);
    return {x, y, rng.between(low, high)};
}

/// Draws four points until they make a tetrahedron that isn't too flat, turns and adds it.
template <typename Draw>
void add_drawn(MeshBuilder& mesh, Draw draw) {
    while (true) {
        std::array<Int3, 4> p = draw();
        const Wide volume = triple(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
        if (std::max(volume, -volume) < 4000) continue;
        for (Int3& q : p) q = slanted()(q);
        mesh.add_tetrahedron(p[0], p[1], p[2], p[3]);
        return;
    }
}

}  // namespace

SceneInput3 coplanar_faces(const Aligned& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const Int3 corner = cell_corner(i, parameters.count);
        const bool above = rng.one_in(2);
        add_drawn(mesh, [&] {
            const Int3 a = corner + over_cell(rng, 0, 0);
            const Int3 b = corner + over_cell(rng, 0, 0);
            const Int3 c = corner + over_cell(rng, 0, 0);
            return std::array{a, b, c, corner + over_cell(rng, above ? 8 : -40, above ? 40 : -8)};
        });
    }
    return finished(mesh, parameters, seed);
}

SceneInput3 collinear_edges(const Aligned& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const Int3 corner{cell * static_cast<std::int64_t>(i), 0, 0};
        add_drawn(mesh, [&] {
            const Int3 end = corner + Int3{rng.between(16, 48), 0, 0};
            const Int3 middle{0, 24, 0};
            const Int3 c = corner + over_cell(rng, -40, 40) - middle;
            return std::array{corner, end, c, corner + over_cell(rng, -40, 40) - middle};
        });
    }
    return finished(mesh, parameters, seed);
}

SceneInput3 vertices_in_plane(const Aligned& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const Int3 corner = cell_corner(i, parameters.count);
        add_drawn(mesh, [&] {
            if (i == 0)
                return std::array<Int3, 4>{{{0, 0, 0}, {48, 0, 0}, {0, 48, 0}, {9, 7, -30}}};
            const Int3 foot = corner + over_cell(rng, 0, 0);
            const Int3 b = corner + over_cell(rng, 4, 40);
            const Int3 c = corner + over_cell(rng, 4, 40);
            return std::array{foot, b, c, corner + over_cell(rng, 4, 40)};
        });
    }
    return finished(mesh, parameters, seed);
}

SceneInput3 concurrent_edges(const Aligned& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    // Each tetrahedron stays in a narrow cone about its edge; the cones are apart.
    constexpr std::int64_t radius = 1 << 16;
    const std::int64_t apart = 2 * radius / (ceil_sqrt(parameters.count) + 6);
    Ring3 directions;
    MeshBuilder mesh;
    while (directions.size() < parameters.count) {
        const Int3 q = on_sphere(rng, radius);
        const bool far = std::all_of(directions.begin(), directions.end(), [&](Int3 other) {
            return squared_length(q - other) > apart * apart;
        });
        if (!far) continue;
        directions.push_back(q);
        const Int3 c = 3 * q + on_sphere(rng, apart / 2);
        Int3 d;
        do {
            d = 3 * q + on_sphere(rng, apart / 2);
        } while (orientation_sign(2 * q, 4 * q, c, d) == 0);
        mesh.add_tetrahedron(2 * q, 4 * q, c, d);
    }
    return finished(mesh, parameters, seed);
}

namespace {

/// A tetrahedron above z = xy with an edge on the ruling of this x: lines y = const, |y| < 4, z = xy graze it.
void add_ruling(MeshBuilder& mesh, std::int64_t x, std::int64_t height) {
    mesh.add_tetrahedron({x, -4, -4 * x}, {x, 4, 4 * x}, {x - 1, 0, height}, {x + 1, 0, height});
}

}  // namespace

SceneInput3 regulus_edges(const Aligned& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (std::size_t i = 1; i <= parameters.count; ++i)
        add_ruling(mesh, 4 * static_cast<std::int64_t>(i), rng.between(8, 24));
    return finished(mesh, parameters, seed);
}

SceneInput3 double_root(int ulps) {
    SIGHTLINE_EXPECT(ulps >= -100 && ulps <= 100);
    MeshBuilder mesh;
    for (const std::int64_t x : {4, 8, 12}) add_ruling(mesh, x, 8);
    // The tangent of z = xy in (16, 0, 0) along (1, 1, 16); the body is on one side of the plane that holds the
    // tangent and the x axis.
    mesh.add_tetrahedron({15, -1, -16}, {17, 1, 16}, {15, -16, 1}, {17, -16, 1});
    SceneInput3 scene = mesh.take_scene();
    for (Point3& p : scene.meshes.front().vertices) {
        const bool on_tangent = (p.x == 15 || p.x == 17) && (p.y == 1 || p.y == -1);
        if (on_tangent) p.z += ulps * 0x1p-48;
    }
    return scene;
}

SceneInput3 near_grid3(const Grid3& parameters, std::uint64_t seed) {
    // Away from zero, next to which an ulp is not like the others.
    const Result<SceneInput3> grid = translated3(triangulated3(grid3(parameters)), 1, 1, 1);
    return approx_nudged3(grid.value(), seed);
}

SceneInput3 far_polytopes(const FarPolytopes& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(std::abs(parameters.shift) < 0x1p52 &&
                     std::floor(parameters.shift) == parameters.shift);
    SIGHTLINE_EXPECT(parameters.exponent >= -1074 && parameters.exponent <= 900);
    const SceneInput3 scene = random_polytopes({.count = parameters.count}, seed);
    const auto shifted = translated3(scene, parameters.shift, -parameters.shift, parameters.shift);
    return scaled3(shifted.value(), parameters.exponent).value();
}

}  // namespace sightline::families
