// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid 3D scenes on small integer grids, where everything degenerate is common: by seed, and for
// RapidCheck. Bodies are convex and have disjoint interiors, by an exact separating-axis test.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/scene3.hpp"
#include "support/scenes3.hpp"

namespace sightline::testing {

using families::detail::ConvexSolid;
using families::detail::Int3;

/// A convex body, or one polygon, with what separates it from others.
struct ConvexPiece {
    ConvexSolid solid;
    bool is_sheet = false;

    [[nodiscard]] std::vector<Int3> edges() const {
        std::vector<Int3> result;
        for (const auto& face : solid.faces) {
            for (std::size_t i = 0; i < face.size(); ++i) {
                result.push_back(solid.vertices[face[(i + 1) % face.size()]] -
                                 solid.vertices[face[i]]);
            }
        }
        return result;
    }
    [[nodiscard]] std::vector<Int3> normals() const {
        std::vector<Int3> result;
        for (const auto& face : solid.faces) {
            const Int3 a = solid.vertices[face[0]];
            result.push_back(
                families::detail::cross3(solid.vertices[face[1]] - a, solid.vertices[face[2]] - a));
        }
        return result;
    }
};

/// Whether a plane has one piece on each side; touching it is allowed unless `strict`. Exact for coordinates below
/// 2^14.
inline bool are_separated(const ConvexPiece& a, const ConvexPiece& b, bool strict) {
    const auto extent = [](const ConvexPiece& piece, Int3 axis) {
        std::vector<std::int64_t> heights;
        for (const Int3& p : piece.solid.vertices)
            heights.push_back(p.x * axis.x + p.y * axis.y + p.z * axis.z);
        return std::pair{*std::min_element(heights.begin(), heights.end()),
                         *std::max_element(heights.begin(), heights.end())};
    };
    const auto separates = [&](Int3 axis) {
        if (axis == Int3{}) return false;
        const auto [a_low, a_high] = extent(a, axis);
        const auto [b_low, b_high] = extent(b, axis);
        return strict ? a_high < b_low || b_high < a_low : a_high <= b_low || b_high <= a_low;
    };
    std::vector<Int3> axes = a.normals();
    for (const Int3& normal : b.normals()) axes.push_back(normal);
    for (const Int3& u : a.edges()) {
        for (const Int3& v : b.edges()) axes.push_back(families::detail::cross3(u, v));
    }
    for (const ConvexPiece* piece : {&a, &b}) {  // polygons in one plane
        if (!piece->is_sheet) continue;
        for (const Int3& edge : piece->edges())
            axes.push_back(families::detail::cross3(edge, piece->normals().front()));
    }
    return std::any_of(axes.begin(), axes.end(), separates);
}

/// What random scenes are made of.
struct Scene3Recipe {
    int grid = 4;          ///< coordinates are 0 … grid
    int bodies = 2;        ///< at most; those that don't find room are dropped, the first excepted
    bool boxes = false;    ///< some bodies are axis-parallel boxes instead of tetrahedra
    bool sheets = false;   ///< some bodies are triangles of zero thickness, apart from all else
    bool touching = true;  ///< bodies may touch
    bool joined = false;   ///< triangles may touch bodies and each other, too
    bool solids = true;    ///< else triangles only
};

/// Draws scenes: the same seed and recipe give the same scene on every machine. Each body is a mesh.
class Scene3Lottery {
public:
    Scene3Lottery(std::uint64_t seed, const Scene3Recipe& recipe) : bits_(seed), recipe_(recipe) {}

    [[nodiscard]] SceneInput3 draw() {
        std::vector<ConvexPiece> pieces;
        for (int tries = 0; tries < 40 && static_cast<int>(pieces.size()) < recipe_.bodies;
             ++tries) {
            ConvexPiece piece = propose();
            const bool fits = std::all_of(pieces.begin(), pieces.end(), [&](const auto& other) {
                const bool has_sheet = piece.is_sheet || other.is_sheet;
                const bool strict = has_sheet ? !recipe_.joined : !recipe_.touching;
                return are_separated(piece, other, strict);
            });
            if (fits) pieces.push_back(std::move(piece));
        }
        SceneInput3 input;
        for (const ConvexPiece& piece : pieces) {
            families::detail::MeshBuilder mesh;
            mesh.add(piece.solid);
            input.meshes.push_back(
                mesh.take(piece.is_sheet ? SurfaceKind::sheet : SurfaceKind::solid));
        }
        return input;
    }

private:
    int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
    Int3 point() {
        const int x = below(recipe_.grid + 1);
        const int y = below(recipe_.grid + 1);
        return {x, y, below(recipe_.grid + 1)};
    }
    ConvexPiece propose() {
        if (!recipe_.solids) return triangle();
        const int kind = below(4);
        if (kind == 0 && recipe_.boxes) return box();
        if (kind == 1 && recipe_.sheets) return triangle();
        while (true) {
            const std::vector<Int3> p{point(), point(), point(), point()};
            if (families::detail::orientation_sign(p[0], p[1], p[2], p[3]) == 0) continue;
            return {families::detail::convex_hull(p), false};
        }
    }
    ConvexPiece box() {
        const Int3 low{below(recipe_.grid), below(recipe_.grid), below(recipe_.grid)};
        const auto side = [&](std::int64_t from) {
            return 1 + below(static_cast<int>(recipe_.grid - from));
        };
        const Int3 high = low + Int3{side(low.x), side(low.y), side(low.z)};
        std::vector<Int3> corners;
        for (int i = 0; i < 8; ++i) {
            corners.push_back({(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                               (i & 4) != 0 ? high.z : low.z});
        }
        return {families::detail::convex_hull(corners), false};
    }
    ConvexPiece triangle() {
        while (true) {
            const std::vector<Int3> p{point(), point(), point()};
            if (families::detail::cross3(p[1] - p[0], p[2] - p[0]) == Int3{}) continue;
            return {{p, {{0, 1, 2}}, true}, true};
        }
    }

    std::mt19937_64 bits_;
    Scene3Recipe recipe_;
};

/// The mixture that differential tests use: one to three tetrahedra, at times with boxes and triangles, on grids of
/// 2 … 6, touching or apart.
inline SceneInput3 random_scene3(std::uint64_t seed) {
    Scene3Recipe recipe;
    recipe.grid = 2 + static_cast<int>(seed % 5);
    recipe.bodies = 1 + static_cast<int>(seed / 5 % 3);
    recipe.boxes = seed % 2 == 0;
    recipe.sheets = seed % 7 == 3;
    recipe.touching = seed % 3 != 1;
    return Scene3Lottery(seed, recipe).draw();
}

}  // namespace sightline::testing

namespace rc {

/// Points of a small grid: three on a line, or four in a plane, are common.
template <>
struct Arbitrary<sightline::Point3> {
    static Gen<sightline::Point3> arbitrary() {
        const auto coordinate = gen::inRange(0, 5);
        return gen::map(gen::tuple(coordinate, coordinate, coordinate),
                        [](const std::tuple<int, int, int>& p) {
                            return sightline::Point3{static_cast<double>(std::get<0>(p)),
                                                     static_cast<double>(std::get<1>(p)),
                                                     static_cast<double>(std::get<2>(p))};
                        });
    }
};

/// Valid scenes of `random_scene3`, of which RapidCheck can leave out bodies (never the first).
template <>
struct Arbitrary<sightline::SceneInput3> {
    static Gen<sightline::SceneInput3> arbitrary() {
        return gen::shrink(gen::map(gen::arbitrary<std::uint64_t>(),
                                    [](std::uint64_t seed) {
                                        return sightline::testing::random_scene3(seed % 1'000'000);
                                    }),
                           [](const sightline::SceneInput3& input) {
                               std::vector<sightline::SceneInput3> smaller;
                               for (std::size_t i = 0;
                                    input.meshes.size() > 1 && i < input.meshes.size(); ++i) {
                                   smaller.push_back(input);
                                   auto& meshes = smaller.back().meshes;
                                   meshes.erase(meshes.begin() + static_cast<std::ptrdiff_t>(i));
                               }
                               return seq::fromContainer(std::move(smaller));
                           });
    }
};

}  // namespace rc

namespace sightline {

/// How RapidCheck shows a scene.
inline void showValue(const SceneInput3& input, std::ostream& out) {
    out << testing::to_text(input);
}

}  // namespace sightline
