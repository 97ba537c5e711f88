// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sightline/scene/result.hpp"
#include "sightline/scene/scene2.hpp"

/// Scenes moved about, for laws ("the result is the same up to renaming") and for torture tests.
namespace sightline::families {

// ---- exact: the scene is congruent or similar to the original, or renamed, so results correspond ----------

/// Adds (dx, dy).
struct Translation {
    double dx = 0;
    double dy = 0;
};
/// Multiplies by 2^exponent.
struct PowerOfTwo {
    int exponent = 0;
};
/// (x, y) → (a x − b y, b x + a y): a rotation times √(a² + b²), which is a whole number for (3, 4), (5, 12)…
struct IntegerRotation {
    std::int64_t a = 3;
    std::int64_t b = 4;
};
/// (x, y) → (−x, y).
struct Mirror {};
/// Permutes elements (a world stays in front of all other elements), holes, the starts of rings, the sense of
/// rings and of walls.
struct Permutation {
    std::uint64_t seed = 0;
};

// ---- rounded: every coordinate becomes the double next to it, or nearly; near-degenerate configurations
//      change, and the result may be invalid (edges that cross, bodies that overlap): validate it again -------

/// Adds (dx, dy), rounding.
struct ApproxTranslation {
    double dx = 0;
    double dy = 0;
};
/// Multiplies by any factor, rounding.
struct ApproxScaling {
    double factor = 1;
};
/// Rotates about the origin, counter-clockwise, rounding.
struct ApproxRotation {
    double degrees = 0;
};
/// Moves each coordinate to the next double below or above with a chance of `per_mille`/1000.
struct Nudge {
    std::uint64_t seed = 0;
    unsigned per_mille = 500;
};

using Transform = std::variant<Translation, PowerOfTwo, IntegerRotation, Mirror, Permutation,
                               ApproxTranslation, ApproxScaling, ApproxRotation, Nudge>;

/// Whether the transform is one of the exact ones.
[[nodiscard]] bool is_exact(const Transform& transform);

/// One line for tables: `approx rotation by 30 degrees`.
[[nodiscard]] std::string to_string(const Transform& transform);

/// The scene after the transform. The same bytes on every platform. O(n).
/// Fails with coordinate_too_large when a coordinate overflows, and with bad_parameter when an exact transform
/// can't keep a coordinate exact (its approx_ counterpart rounds), or a parameter is not finite (for IntegerRotation: both are 0, or one
/// exceeds 2^53).
[[nodiscard]] Result<SceneInput2> transformed(const SceneInput2& scene, const Transform& transform);

/// A permuted scene, and for each of its vertices (numbered in input order, as Scene2 does) the number that the
/// vertex had.
struct PermutedScene2 {
    SceneInput2 scene;
    std::vector<std::uint32_t> old_vertex;
};
[[nodiscard]] PermutedScene2 permuted(const SceneInput2& scene, std::uint64_t seed);

}  // namespace sightline::families
