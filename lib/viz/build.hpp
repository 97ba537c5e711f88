// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sightline/viz/draw.hpp"

namespace sightline::viz::detail {

[[nodiscard]] inline Position position(const Point2& p) { return {p.x, p.y, 0}; }
[[nodiscard]] inline Position position(const RationalPoint2& p) {
    return position(approx_point(p));
}

/// A picture of the scene that shows the given places too, ready for more.
[[nodiscard]] DrawList begin(const Scene2& scene, const DrawOptions& options,
                             std::span<const RationalPoint2> places);

/// The finite places of a view, and where it is seen from.
[[nodiscard]] inline std::vector<RationalPoint2> places_of(const RationalPoint2& from,
                                                           std::span<const ViewPoint> ring) {
    std::vector<RationalPoint2> places{from};
    for (const ViewPoint& p : ring) {
        if (!p.at_infinity) places.push_back(p.coordinates);
    }
    return places;
}

}  // namespace sightline::viz::detail
