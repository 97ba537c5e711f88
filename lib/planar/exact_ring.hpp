// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {

/// The canonical form of a counter-clockwise ring: without repeats and straight vertices, from the
/// lexicographically least vertex on.
[[nodiscard]] std::vector<ViewPoint> canonical_form(std::vector<ViewPoint> ring);

}  // namespace sightline::detail
