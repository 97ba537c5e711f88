// SPDX-License-Identifier: GPL-3.0-or-later
// Random disjoint bodies.
#include <algorithm>
#include <array>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

constexpr std::int64_t radius = 1 << 16;

/// `count` points of the sphere, at least so far apart.
Ring3 sphere_points(Rng& rng, std::size_t count, std::int64_t apart) {
    Ring3 points;
    while (points.size() < count) {
        const Int3 candidate = on_sphere(rng, radius);
        const bool far = std::all_of(points.begin(), points.end(), [&](Int3 p) {
            return squared_length(p - candidate) > apart * apart;
        });
        if (far) points.push_back(candidate);
    }
    return points;
}

Ring3 shifted(Ring3 points, Int3 by) {
    for (Int3& p : points) p = p + by;
    return points;
}

void expect_in_range(const Bodies& parameters) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 100'000);
    SIGHTLINE_EXPECT(parameters.percent >= 1 && parameters.percent <= 30);
}

bool has_axis_parallel_edge(const ConvexSolid& solid) {
    for (const auto& face : solid.faces) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Int3 edge = solid.vertices[face[(i + 1) % face.size()]] - solid.vertices[face[i]];
            if ((edge.x == 0) + (edge.y == 0) + (edge.z == 0) > 1) return true;
        }
    }
    return false;
}

/// Far enough apart, each point of a sphere is a vertex of the hull in spite of the rounding.
ConvexSolid random_polytope(Rng& rng, std::size_t vertices) {
    const auto apart = 2 * radius / (ceil_sqrt(vertices) + 6);
    while (true) {
        ConvexSolid solid = convex_hull(sphere_points(rng, vertices, apart));
        const bool generic = solid.simplicial && !has_axis_parallel_edge(solid);
        if (generic && solid.vertices.size() == vertices) return solid;
    }
}

}  // namespace

SceneInput3 random_tetrahedra(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        Ring3 p;
        Wide volume = 0;
        do {
            p = shifted(sphere_points(rng, 4, radius / 2), centre);
            volume = triple(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
        } while (std::max(volume, -volume) < static_cast<Wide>(radius) * radius * radius / 2);
        mesh.add_tetrahedron(p[0], p[1], p[2], p[3]);
    }
    return mesh.take_scene();
}

SceneInput3 thin_tetrahedra(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        Ring3 p;
        Wide volume = 0;
        do {
            const Int3 axis = on_sphere(rng, radius);
            const auto aside = [&] { return on_sphere(rng, radius / 16); };
            p = {axis, Int3{} - axis, aside(), aside()};
            volume = triple(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
        } while (std::max(volume, -volume) < static_cast<Wide>(radius) * radius * radius / 256);
        p = shifted(p, centre);
        mesh.add_tetrahedron(p[0], p[1], p[2], p[3]);
    }
    return mesh.take_scene();
}

SceneInput3 thin_triangles(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        const Int3 axis = on_sphere(rng, radius);
        Int3 aside;
        do {  // neither on the axis nor nearly
            aside = on_sphere(rng, radius / 16);
        } while (squared_length(cross3(axis, aside)) / radius / radius <
                 static_cast<std::int64_t>(radius) * radius / 1024);
        mesh.add_polygon({centre + axis, centre - axis, centre + aside});
    }
    return mesh.take_scene(SurfaceKind::sheet);
}

SceneInput3 random_boxes(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        const auto half = [&rng] { return rng.between(radius / 6, radius * 577 / 1000); };
        const std::int64_t x = half();
        const std::int64_t y = half();
        const Int3 reach{x, y, half()};
        mesh.add_box(centre - reach, centre + reach);
    }
    return mesh.take_scene();
}

SceneInput3 turned_boxes(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        const Turn turn = random_turn(rng);
        const auto half = [&] {
            return rng.between(radius / 6, radius * 577 / 1000) / turn.length;
        };
        const std::int64_t x = half();
        const std::int64_t y = half();
        const Int3 reach{x, y, half()};
        mesh.add_turned_box(turn, centre, Int3{} - reach, reach);
    }
    return mesh.take_scene();
}

SceneInput3 random_l_shapes(const Bodies& parameters, std::uint64_t seed) {
    expect_in_range(parameters);
    Rng rng(seed);
    MeshBuilder mesh;
    for (const Int3& centre : random_balls(rng, parameters.count, radius, parameters.percent)) {
        const Turn turn = random_turn(rng);
        const std::int64_t half = radius * 577 / 1000 / turn.length;
        const std::int64_t x = rng.between(-half / 2, half / 2);
        const std::int64_t y = rng.between(-half / 2, half / 2);
        const std::int64_t z = rng.between(half / 4, half);
        Ring3 outline{{-half, -half, -z}, {half, -half, -z}, {half, y, -z},
                      {x, y, -z},         {x, half, -z},     {-half, half, -z}};
        for (Int3& p : outline) p = centre + turn(p);
        mesh.add_prism(outline, turn({0, 0, 2 * z}));
    }
    return mesh.take_scene();
}

SceneInput3 random_polytopes(const Polytopes& parameters, std::uint64_t seed) {
    expect_in_range({parameters.count, parameters.percent});
    SIGHTLINE_EXPECT(parameters.edges_per_body >= 6 && parameters.edges_per_body <= 1000);
    Rng rng(seed);
    const std::size_t k = parameters.count;
    const std::size_t vertices = (k * (parameters.edges_per_body + 6) + 1) / 3;
    MeshBuilder mesh;
    const std::vector<Int3> centres = random_balls(rng, k, radius, parameters.percent);
    for (std::size_t i = 0; i < k; ++i) {
        // The shares of `vertices` as even as can be, in a fixed pattern.
        const std::size_t share = vertices * (i + 1) / k - vertices * i / k;
        ConvexSolid solid = random_polytope(rng, share);
        for (Int3& p : solid.vertices) p = p + centres[i];
        mesh.add(solid);
    }
    return mesh.take_scene();
}

}  // namespace sightline::families
