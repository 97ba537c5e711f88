// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sightline/scene/result.hpp"
#include "sightline/scene/scene3.hpp"

/// 3D scenes moved about, for laws ("the result is the same up to renaming") and for torture tests.
/// All transforms are exact; `approx_nudged3` alone is not.
namespace sightline::families {

/// Adds (dx, dy, dz). Fails with bad_parameter when a sum is no double, or a number is not finite, and with
/// coordinate_too_large on overflow.
[[nodiscard]] Result<SceneInput3> translated3(const SceneInput3& scene, double dx, double dy,
                                              double dz);
/// Multiplies by 2^exponent. Fails with bad_parameter when a product is no double, and with coordinate_too_large
/// on overflow.
[[nodiscard]] Result<SceneInput3> scaled3(const SceneInput3& scene, int exponent);
/// A rotation times the whole number a² + b² + c² + d², from the quaternion a + bi + cj + dk of whole numbers below
/// 2^25 in size, not all zero. Fails as translated3 does.
[[nodiscard]] Result<SceneInput3> rotated3(const SceneInput3& scene,
                                           const std::array<std::int64_t, 4>& quaternion);
/// (x, y, z) → (−x, y, z); faces are turned over, so that solids remain solids. A face's vertices come in the
/// opposite order, its first vertex stays the first.
[[nodiscard]] SceneInput3 mirrored3(const SceneInput3& scene);
/// New coordinate i is the old coordinate axes[i]; axes is a permutation of 0, 1, 2. Odd ones mirror, as mirrored3.
[[nodiscard]] SceneInput3 with_axes_permuted3(const SceneInput3& scene,
                                              const std::array<int, 3>& axes);

/// A renumbered scene, and for each of its vertices and faces (numbered through all meshes, as Scene3 does) the
/// number that it had.
struct PermutedScene3 {
    SceneInput3 scene;
    std::vector<std::uint32_t> old_vertex;
    std::vector<std::uint32_t> old_face;
};
/// Permutes meshes (a world stays the first), the vertices and faces of each, and the first vertices of faces.
[[nodiscard]] PermutedScene3 permuted3(const SceneInput3& scene, std::uint64_t seed);

/// Cuts each face into triangles along its own diagonals: the same surface, so the same features. Faces are simple
/// polygons. O(n³) for a face of n vertices.
[[nodiscard]] SceneInput3 triangulated3(const SceneInput3& scene);

/// Moves each coordinate to the next double below or above with a chance of per_mille/1000; zeros stay. The result
/// may be invalid: faces that aren't triangles bend, touching bodies overlap or part; validate it again.
[[nodiscard]] SceneInput3 approx_nudged3(const SceneInput3& scene, std::uint64_t seed,
                                         unsigned per_mille = 500);

}  // namespace sightline::families
