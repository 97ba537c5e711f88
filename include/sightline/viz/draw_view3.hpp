// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/view/view3.hpp"
#include "sightline/viz/draw.hpp"

namespace sightline::viz {

/// A view of space as it is seen: the planar map with its faces coloured (by body, shaded by the direction of the
/// face), the visible pieces of edges and the T-junctions.
///
/// Seen from infinity, and from a point when everything lies well within a half space, straight edges are straight;
/// else the sphere of directions is projected stereographically, and straight edges are arcs of circles.
[[nodiscard]] DrawList draw(const Scene3& scene, const View3& view,
                            const DrawOptions& options = {});

}  // namespace sightline::viz
