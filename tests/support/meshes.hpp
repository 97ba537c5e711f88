// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Small meshes, and scenes made of them.

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "sightline/scene/scene3.hpp"

namespace sightline::test {

using Faces = std::vector<std::vector<std::uint32_t>>;

inline MeshInput3 mesh_of(std::vector<Point3> vertices, Faces faces,
                          SurfaceKind kind = SurfaceKind::solid) {
    MeshInput3 mesh;
    mesh.vertices = std::move(vertices);
    mesh.faces = std::move(faces);
    mesh.kind = kind;
    return mesh;
}

/// The box with these corners; vertex 4i + 2j + k is at (low or high x, y, z) for bits i, j, k.
inline MeshInput3 box_mesh(Point3 low, Point3 high) {
    MeshInput3 mesh;
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y})
            for (const double z : {low.z, high.z}) mesh.vertices.push_back({x, y, z});
    mesh.faces = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                  {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    return mesh;
}

inline MeshInput3 unit_cube() { return box_mesh({0, 0, 0}, {1, 1, 1}); }

inline MeshInput3 tetrahedron(Point3 a, Point3 b, Point3 c, Point3 d) {
    return mesh_of({a, b, c, d}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});
}

/// The same mesh with each face cut into a fan of triangles.
inline MeshInput3 fans_of(MeshInput3 mesh) {
    Faces triangles;
    for (const auto& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            triangles.push_back({face[0], face[i - 1], face[i]});
    mesh.faces = std::move(triangles);
    return mesh;
}

inline MeshInput3 turned(MeshInput3 mesh) {
    for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
    return mesh;
}

/// The prism over a polygon of the plane z = low, counter-clockwise.
inline MeshInput3 prism(const std::vector<Point2>& base, double low, double high) {
    MeshInput3 mesh;
    const auto n = static_cast<std::uint32_t>(base.size());
    for (const double z : {low, high})
        for (const Point2& p : base) mesh.vertices.push_back({p.x, p.y, z});
    mesh.faces.resize(2);
    for (std::uint32_t i = 0; i < n; ++i) {
        mesh.faces[0].push_back(n - 1 - i);
        mesh.faces[1].push_back(n + i);
        mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    return mesh;
}

inline Result<Scene3> make_scene3(std::vector<MeshInput3> meshes, bool world = false) {
    SceneInput3 input;
    input.meshes = std::move(meshes);
    input.world = world;
    return Scene3::make(input);
}

/// A scene that the test knows to be valid.
inline Scene3 scene3_of(std::vector<MeshInput3> meshes, bool world = false) {
    Result<Scene3> scene = make_scene3(std::move(meshes), world);
    if (!scene) throw std::invalid_argument(scene.error().message);
    return std::move(*scene);
}

}  // namespace sightline::test
