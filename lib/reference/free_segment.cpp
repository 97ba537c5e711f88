// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/free_segment.hpp"

#include "reference/sight_line.hpp"

namespace sightline::reference {
namespace {

bool is_free_between(const Scene2& scene, const Place& p, const Place& q) {
    if (is_interior(scene, p)) return false;
    if (p == q) return true;
    const Everything everything(scene);
    return SightLine(scene, everything.candidates(), p, q, Reach::segment).is_free();
}

}  // namespace

bool is_free(const Scene2& scene, const RationalPoint2& p, const RationalPoint2& q) {
    return is_free_between(scene, p, q);
}

bool is_free(const Scene2& scene, VertexId u, VertexId w) {
    return is_free_between(scene, scene[u], scene[w]);
}

}  // namespace sightline::reference
