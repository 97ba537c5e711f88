// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planar/triangulation.hpp"
#include "sightline/planar/exact_points.hpp"

namespace sightline::detail {

/// Exact coordinates of a polygon that was seen in the scene of the triangulation.
[[nodiscard]] ExactPoints exact_points(const Scene2& scene, const Triangulation& t,
                                       const VisibilityPolygon& polygon);

}  // namespace sightline::detail
