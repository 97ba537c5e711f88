// SPDX-License-Identifier: GPL-3.0-or-later
// The small scenes of the catalogue's pictures.
#pragma once

#include <utility>
#include <vector>

#include "sightline/scene/scene3.hpp"

namespace sightline::experiments {

inline MeshInput3 box(const Point3& a, const Point3& b) {
    MeshInput3 mesh;
    mesh.vertices = {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z},
                     {a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}};
    mesh.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return mesh;
}

/// Corners in the order in which abc is clockwise seen from d.
inline MeshInput3 tetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    MeshInput3 mesh;
    mesh.vertices = {a, b, c, d};
    mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return mesh;
}

inline MeshInput3 sheet(std::vector<Point3> ring) {
    MeshInput3 mesh;
    mesh.faces.emplace_back();
    for (std::uint32_t v = 0; v < ring.size(); ++v) mesh.faces[0].push_back(v);
    mesh.vertices = std::move(ring);
    mesh.kind = SurfaceKind::sheet;
    return mesh;
}

/// A level, an upright and a slanting edge behind one another; with four, a steep one behind these.
inline std::vector<MeshInput3> sheets(std::size_t count) {
    std::vector<MeshInput3> all{sheet({{0, -3, -3}, {0, 3, -3}, {0, 3, 0}, {0, -3, 0}}),
                                sheet({{5, -4, -4}, {5, 0, -4}, {5, 0, 4}, {5, -4, 4}}),
                                sheet({{10, -4, -4}, {10, 4, 4}, {10, -4, 4}}),
                                sheet({{15, -4, 1}, {15, 4, 2}, {15, 4, 5}})};
    all.resize(count);
    return all;
}

}  // namespace sightline::experiments
