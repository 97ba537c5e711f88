// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of 3D generators and transforms share.
#pragma once

#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <map>

#include "scene/families3_detail.hpp"
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

using families::detail::Int3;
using families::detail::Wide;

/// A component of a mesh with whole coordinates: its points, and its faces as indices into them.
struct Part {
    std::vector<Int3> points;
    families::detail::FaceList faces;

    [[nodiscard]] std::vector<Int3> edges() const {
        std::vector<Int3> result;
        for (const auto& face : faces) {
            for (std::size_t i = 0; i < face.size(); ++i) {
                if (face[i] < face[(i + 1) % face.size()])
                    result.push_back(points[face[(i + 1) % face.size()]] - points[face[i]]);
            }
        }
        return result;
    }
    [[nodiscard]] bool is_convex() const {
        for (const auto& face : faces) {
            for (const Int3& p : points) {
                if (families::detail::orientation_sign(points[face[0]], points[face[1]],
                                                       points[face[2]], p) < 0)
                    return false;
            }
        }
        return true;
    }
};

inline std::vector<Part> parts_of(const MeshInput3& mesh) {
    std::vector<std::uint32_t> least(mesh.vertices.size());  // vertex reached
    for (std::uint32_t v = 0; v < least.size(); ++v) least[v] = v;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& face : mesh.faces) {
            std::uint32_t low = UINT32_MAX;
            for (const std::uint32_t v : face) low = std::min(low, least[v]);
            for (const std::uint32_t v : face) {
                changed = changed || least[v] != low;
                least[v] = low;
            }
        }
    }
    std::map<std::uint32_t, Part> parts;
    std::vector<std::uint32_t> number(mesh.vertices.size());
    for (std::uint32_t v = 0; v < least.size(); ++v) {
        Part& part = parts[least[v]];
        number[v] = static_cast<std::uint32_t>(part.points.size());
        const Point3& p = mesh.vertices[v];
        part.points.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y),
                               static_cast<std::int64_t>(p.z)});
    }
    for (const auto& face : mesh.faces) {
        Part& part = parts[least[face[0]]];
        part.faces.emplace_back();
        for (const std::uint32_t v : face) part.faces.back().push_back(number[v]);
    }
    std::vector<Part> result;
    for (auto& [low, part] : parts) result.push_back(std::move(part));
    return result;
}

/// The extent of points along an axis.
inline std::pair<Wide, Wide> extent(const std::vector<Int3>& points, Int3 axis) {
    std::pair<Wide, Wide> range{0, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Wide height = static_cast<Wide>(points[i].x) * axis.x +
                            static_cast<Wide>(points[i].y) * axis.y +
                            static_cast<Wide>(points[i].z) * axis.z;
        if (i == 0) range = {height, height};
        range = {std::min(range.first, height), std::max(range.second, height)};
    }
    return range;
}

/// How two sets lie: interiors meet, only boundaries meet (or a plane between them touches both), or apart.
enum class Lie { overlap, touch, apart };

/// For convex parts, exactly, by separating axes; coordinates below 2^30.
inline Lie lie_of(const Part& a, const Part& b) {
    std::vector<Int3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Part* part : {&a, &b}) {
        for (const auto& face : part->faces) {
            const Int3 o = part->points[face[0]];
            axes.push_back(
                families::detail::cross3(part->points[face[1]] - o, part->points[face[2]] - o));
        }
    }
    for (const Int3& u : a.edges()) {
        for (const Int3& v : b.edges()) axes.push_back(families::detail::cross3(u, v));
    }
    Lie result = Lie::overlap;
    for (const Int3& axis : axes) {
        if (axis == Int3{}) continue;
        const auto [a_low, a_high] = extent(a.points, axis);
        const auto [b_low, b_high] = extent(b.points, axis);
        if (a_high < b_low || b_high < a_low) return Lie::apart;
        if (a_high <= b_low || b_high <= a_low) result = Lie::touch;
    }
    return result;
}

/// Whether the line through p along d meets the interior of a convex part.
inline bool stabs(const Part& part, Int3 p, Int3 d) {
    for (const Int3& edge : part.edges()) {
        const Int3 axis = families::detail::cross3(edge, d);
        if (axis == Int3{}) continue;
        const auto [low, high] = extent(part.points, axis);
        const Wide height = extent({p}, axis).first;
        if (height <= low || high <= height) return false;
    }
    return true;
}

/// How many pairs of the scene's convex parts lie in each way. The parts of a world do not take part.
inline std::map<Lie, std::size_t> lies_of(const SceneInput3& scene) {
    std::vector<Part> parts;
    for (std::size_t m = scene.world ? 1 : 0; m < scene.meshes.size(); ++m) {
        for (Part& part : parts_of(scene.meshes[m])) {
            if (part.is_convex()) parts.push_back(std::move(part));
        }
    }
    std::map<Lie, std::size_t> counts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) ++counts[lie_of(parts[i], parts[j])];
    }
    return counts;
}

}  // namespace sightline::families_test
