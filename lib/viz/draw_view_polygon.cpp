// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {

void add_view(DrawList& list, const Scene2& scene, const VisibilityPolygon& polygon) {
    std::vector<NeedlePoints> needles;
    needles.reserve(polygon.needles.size());
    for (const auto& [near, far] : polygon.needles) {
        needles.emplace_back(exact_point(scene, polygon.from, near),
                             exact_point(scene, polygon.from, far));
    }
    add_view(list, polygon.from, exact_ring(scene, polygon), needles);
}

DrawList draw(const Scene2& scene, const VisibilityPolygon& polygon, const DrawOptions& options) {
    const std::vector<ViewPoint> ring = exact_ring(scene, polygon);
    DrawList list = detail::begin(scene, options, detail::places_of(polygon.from, ring));
    add_view(list, scene, polygon);
    return list;
}

}  // namespace sightline::viz
