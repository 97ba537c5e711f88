// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/point_locator.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {

/// The needles of a view: of each followed ray (a place on it) the part beyond the regularised polygon.
/// Ascending, without repeats.
[[nodiscard]] std::vector<Needle> find_needles(const Scene2& scene, const Triangulation& t,
                                               const Viewpoint& from, const Location& at,
                                               const VisibilityPolygon& polygon,
                                               const std::vector<Place>& followed);

}  // namespace sightline::detail
