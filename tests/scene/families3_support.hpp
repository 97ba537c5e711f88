// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of 3D generators and transforms share.
#pragma once

#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/families_support.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::families_test {

inline std::uint64_t fingerprint(const SceneInput3& scene) {
    Fingerprint print;
    print.add(scene.world ? 1 : 0);
    for (const MeshInput3& mesh : scene.meshes) {
        print.add(mesh.kind == SurfaceKind::sheet ? 1 : 0);
        print.add(mesh.vertices.size());
        for (const Point3& p : mesh.vertices) {
            for (const double c : {p.x, p.y, p.z}) print.add(std::bit_cast<std::uint64_t>(c));
        }
        for (const auto& face : mesh.faces) {
            print.add(face.size());
            for (const std::uint32_t v : face) print.add(v);
        }
    }
    return print.value();
}

inline Rational determinant(const Point3& o, const Point3& a, const Point3& b, const Point3& c) {
    const auto d = [&](const Point3& p) {
        return RationalPoint3{Rational(p.x) - Rational(o.x), Rational(p.y) - Rational(o.y),
                              Rational(p.z) - Rational(o.z)};
    };
    const RationalPoint3 u = d(a);
    const RationalPoint3 v = d(b);
    const RationalPoint3 w = d(c);
    return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) +
           u.z * (v.x * w.y - v.y * w.x);
}

/// Six times the volume that the faces enclose (fans from the first vertex), exactly.
inline Rational six_volumes(const MeshInput3& mesh) {
    Rational sum;
    const Point3& o = mesh.vertices.front();
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            sum = sum + determinant(o, mesh.vertices[face[0]], mesh.vertices[face[i]],
                                    mesh.vertices[face[i + 1]]);
        }
    }
    return sum;
}

/// Feature-like counts of an input as it is.
struct Counts3 {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::size_t faces = 0;
    friend bool operator==(const Counts3&, const Counts3&) = default;
};
inline Counts3 counts_of(const SceneInput3& scene) {
    Counts3 counts;
    for (const MeshInput3& mesh : scene.meshes) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const auto& face : mesh.faces) {
            for (std::size_t i = 0; i < face.size(); ++i) {
                const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
                edges.emplace(low, high);
            }
        }
        counts.vertices += mesh.vertices.size();
        counts.edges += edges.size();
        counts.faces += mesh.faces.size();
    }
    return counts;
}

}  // namespace sightline::families_test
