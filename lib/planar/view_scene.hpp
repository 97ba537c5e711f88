// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "planar/crossings.hpp"
#include "planar/point_locator.hpp"

namespace sightline::detail {

/// A scene prepared for questions about arbitrary points.
struct ViewScene {
    ViewScene(const Scene2& scene, std::span<const Point2> within)
        : triangulation(scene, within), crossings(triangulation), locator(triangulation) {}

    Triangulation triangulation;
    Crossings crossings;
    PointLocator locator;
};

/// Fails with coordinate_too_large beyond the bound that scenes keep, 2^1020: a frame round such a point
/// would have no finite size. `rounded` is the point or its nearest doubles.
[[nodiscard]] Result<void> check_size(const Point2& rounded);

/// A point and where it lies; a place when it lies on one.
struct Standpoint {
    Viewpoint viewpoint;
    Location at;
};

/// Finds the point (which lies in the frame); fails with inside_body or outside_of_world when it lies
/// in the interior of B.
[[nodiscard]] Result<Standpoint> stand_at(const Scene2& scene, const ViewScene& view,
                                          const Viewpoint& q, Tally* tally);

}  // namespace sightline::detail
