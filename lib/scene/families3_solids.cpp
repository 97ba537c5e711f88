// SPDX-License-Identifier: GPL-3.0-or-later
// Single solids.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline::families {

using namespace detail;

namespace {

/// (a, b, c) with all signs, and the two cyclic shifts of these; without repetitions.
void add_cyclic(Ring3& points, std::int64_t a, std::int64_t b, std::int64_t c) {
    for (int signs = 0; signs < 8; ++signs) {
        const Int3 p{(signs & 1) != 0 ? -a : a, (signs & 2) != 0 ? -b : b,
                     (signs & 4) != 0 ? -c : c};
        for (const Int3& q : {p, Int3{p.y, p.z, p.x}, Int3{p.z, p.x, p.y}}) {
            if (std::find(points.begin(), points.end(), q) == points.end()) points.push_back(q);
        }
    }
}

ConvexSolid dodecahedron() {
    Ring3 points;
    add_cyclic(points, 4, 4, 4);
    add_cyclic(points, 0, 6, 3);
    return convex_hull(points);
}

ConvexSolid icosahedron() {
    Ring3 points;
    add_cyclic(points, 0, 8, 13);
    return convex_hull(points);
}

ConvexSolid octahedron() {
    Ring3 points;
    add_cyclic(points, 0, 0, 1);
    return convex_hull(points);
}

/// Four bars round a square: the coplanar faces on top and below merge to one with a hole each.
void add_ring(MeshBuilder& mesh) {
    const std::array<Int3, 16> v{{{0, 0, 0},
                                  {3, 0, 0},
                                  {3, 3, 0},
                                  {0, 3, 0},
                                  {1, 1, 0},
                                  {2, 1, 0},
                                  {2, 2, 0},
                                  {1, 2, 0},
                                  {0, 0, 1},
                                  {3, 0, 1},
                                  {3, 3, 1},
                                  {0, 3, 1},
                                  {1, 1, 1},
                                  {2, 1, 1},
                                  {2, 2, 1},
                                  {1, 2, 1}}};
    FaceList faces;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        faces.push_back({i, j, j + 8, i + 8});            // outer wall
        faces.push_back({j + 4, i + 4, i + 12, j + 12});  // inner wall
        faces.push_back({j, i, i + 4, j + 4});            // bottom
        faces.push_back({i + 8, j + 8, j + 12, i + 12});  // top
    }
    mesh.add(v, faces);
}

/// A cube of side 2 without the unit cube at its corner (2, 2, 2).
void add_notched_cube(MeshBuilder& mesh) {
    const std::array<Int3, 14> v{{{0, 0, 0},
                                  {2, 0, 0},
                                  {2, 2, 0},
                                  {0, 2, 0},
                                  {0, 0, 2},
                                  {2, 0, 2},
                                  {0, 2, 2},
                                  {2, 2, 1},
                                  {2, 1, 2},
                                  {1, 2, 2},
                                  {2, 1, 1},
                                  {1, 2, 1},
                                  {1, 1, 2},
                                  {1, 1, 1}}};
    mesh.add(v, {{0, 3, 2, 1},
                 {0, 1, 5, 4},
                 {0, 4, 6, 3},
                 {1, 2, 7, 10, 8, 5},
                 {3, 6, 9, 11, 7, 2},
                 {4, 5, 8, 12, 9, 6},
                 {13, 10, 7, 11},
                 {13, 12, 8, 10},
                 {13, 11, 9, 12}});
}

/// A strictly convex ring of lattice points in the plane z = 0, near a circle.
Ring3 base_ring(std::size_t sides) {
    SIGHTLINE_EXPECT(sides >= 3 && sides <= 1000);
    Ring3 ring;
    for (std::size_t i = 0; i < sides; ++i) {
        const IntPoint p = on_circle(i, sides, 1 << 20);
        ring.push_back({p.x, p.y, 0});
    }
    return ring;
}

}  // namespace

SceneInput3 solid(SolidShape shape) {
    MeshBuilder mesh;
    switch (shape) {
        case SolidShape::tetrahedron:
            mesh.add_tetrahedron({0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1});
            break;
        case SolidShape::cube:
            mesh.add_box({0, 0, 0}, {1, 1, 1});
            break;
        case SolidShape::octahedron:
            mesh.add(octahedron());
            break;
        case SolidShape::icosahedron:
            mesh.add(icosahedron());
            break;
        case SolidShape::dodecahedron:
            mesh.add(dodecahedron());
            break;
        case SolidShape::l_shape:
            mesh.add_prism({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                           {0, 0, 1});
            break;
        case SolidShape::u_shape:
            mesh.add_prism({{0, 0, 0},
                            {3, 0, 0},
                            {3, 3, 0},
                            {2, 3, 0},
                            {2, 1, 0},
                            {1, 1, 0},
                            {1, 3, 0},
                            {0, 3, 0}},
                           {0, 0, 1});
            break;
        case SolidShape::ring:
            add_ring(mesh);
            break;
        case SolidShape::notched_cube:
            add_notched_cube(mesh);
            break;
    }
    return mesh.take_scene();
}

SceneInput3 prism(const Sides& parameters) {
    MeshBuilder mesh;
    mesh.add_prism(base_ring(parameters.sides), {0, 0, 1 << 20});
    return mesh.take_scene();
}

SceneInput3 pyramid(const Sides& parameters) {
    Ring3 vertices = base_ring(parameters.sides);
    const auto n = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back({0, 0, 1 << 20});
    FaceList faces(1);
    for (std::uint32_t i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces.push_back({i, (i + 1) % n, n});
    }
    MeshBuilder mesh;
    mesh.add(vertices, faces);
    return mesh.take_scene();
}

SceneInput3 comb3(const Comb& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.teeth >= 1 && parameters.teeth <= 100'000);
    Rng rng(seed);
    const auto n = static_cast<std::int64_t>(parameters.teeth);
    Ring3 outline{{0, 0, 0}, {16 * (2 * n - 1), 0, 0}};
    for (std::int64_t i = n - 1; i >= 0; --i) {
        const std::int64_t tip = 32 + rng.between(32, 160);
        const std::int64_t left = 32 * i;
        if (i + 1 < n) outline.push_back({left + 16, 32, 0});
        outline.push_back({left + 16, tip, 0});
        outline.push_back({left, tip, 0});
        if (i > 0) outline.push_back({left, 32, 0});
    }
    MeshBuilder mesh;
    mesh.add_prism(outline, {0, 0, 16});
    return mesh.take_scene();
}

}  // namespace sightline::families
