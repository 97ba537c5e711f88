// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// An outside opinion: the canonical ring of what q sees, by CGAL's exact triangular expansion.
///
/// For scenes with a world, without walls, in which nothing touches, and q in the open free space.
/// (CGAL's rotational sweep is not asked: it is wrong, also with exact numbers.)
[[nodiscard]] std::vector<ViewPoint> cgal_visibility_ring(const Scene2& scene,
                                                          const RationalPoint2& q);

}  // namespace sightline::reference
