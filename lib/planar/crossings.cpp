// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/crossings.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace sightline::detail {

Crossings::Crossings(const Triangulation& t, unsigned threads)
    : crossings_(3 * t.triangle_count()) {
    const auto triangles = static_cast<HalfEdge>(t.triangle_count());
    if (threads <= 1) {
        fill(t, 0, 4 * triangles);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<HalfEdge>(0, triangles, 1024),
                      [&](const auto& r) { fill(t, 4 * r.begin(), 4 * r.end()); });
}

void Crossings::fill(const Triangulation& t, HalfEdge begin, HalfEdge end) {
    for (HalfEdge base = begin; base < end; base += 4) {
        if (!t.is_free(base)) continue;
        std::uint32_t out[3];
        for (HalfEdge i = 0; i < 3; ++i) out[i] = beyond(t, base + i);
        for (HalfEdge i = 0; i < 3; ++i) {
            const Place apex = t.apex(base + i);
            const Point2& p = t.position(apex);
            // Entering through p→q, q is on the right: the left exit is apex→p, the right one q→apex.
            crossings_[index(base + i)] = {p.x,
                                           p.y,
                                           apex,
                                           out[prev(i)],
                                           out[next(i)],
                                           (t.is_scene_place(apex) ? is_vertex_flag : 0U) |
                                               (t.is_knot(apex) ? is_knot_flag : 0U)};
        }
    }
}

}  // namespace sightline::detail
