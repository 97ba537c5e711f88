// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/box3.hpp"

namespace sightline {

/// The boxes of scene.triangles(), in their order.
[[nodiscard]] std::vector<Box3> triangle_boxes(const Scene3& scene);

/// The boxes of scene.edges(), in their order.
[[nodiscard]] std::vector<Box3> edge_boxes(const Scene3& scene);

/// The boxes of scene.faces(), in their order.
[[nodiscard]] std::vector<Box3> face_boxes(const Scene3& scene);

}  // namespace sightline
