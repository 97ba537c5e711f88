// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which surfaces surround a point, and which way surfaces look. Private.

#include <map>
#include <span>

#include "scene/box_tree3.hpp"
#include "scene/exact3.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::detail {

/// The triangle's corners.
using Corners3 = std::array<Point3, 3>;

[[nodiscard]] SceneBox3 box_of(const Corners3& corners);

/// By how much the number of surfaces round a point grows at its ray in the direction −x, or 0 when that ray misses
/// the triangle. The ray is thought to be moved by (ε, ε²) in y and z, so that it meets no edge. The point does not lie on
/// the triangle.
[[nodiscard]] int winding_step(const Corners3& triangle, const Point3& p);

/// Sign of the volume that closed surfaces bound, positive when they look outwards.
[[nodiscard]] Sign sign_of_volume(std::span<const Corners3> triangles);

/// Whether the point lies on the closed triangle.
[[nodiscard]] bool is_on(const Corners3& triangle, const Point3& p);
[[nodiscard]] bool is_on(const Corners3& triangle, const RationalPoint3& p);

}  // namespace sightline::detail
