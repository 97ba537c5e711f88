// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::experiments {

/// A scene of one of our families with about n vertices: dense, sparse, packed, grid, rotated_grid,
/// floor_plan, cave, needles.
[[nodiscard]] SceneInput2 family_scene(std::string_view family, std::size_t n, std::uint64_t seed);

/// `count` random points in the open free space of a bounded scene: uniform in its box, with all the digits
/// of a double, those in B left out.
[[nodiscard]] std::vector<Point2> free_points(const Scene2& scene, std::size_t count,
                                              std::uint64_t seed);

}  // namespace sightline::experiments
