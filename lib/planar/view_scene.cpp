// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/view_scene.hpp"

#include <cmath>
#include <string>

namespace sightline::detail {
namespace {

std::string text_of(const Viewpoint& v) {
    const RationalPoint2 p = v.exact != nullptr ? *v.exact : to_rational(v.position);
    return "(" + p.x.to_string() + ", " + p.y.to_string() + ")";
}

bool is_seeing(const Triangulation& t, const Location& at) {
    const HalfEdge h = at.half_edge;
    if (at.kind == Location::Kind::triangle) return t.is_free(h);
    if (at.kind == Location::Kind::edge) return t.is_free(h) || t.is_free(t.twin(h));
    HalfEdge k = h;
    do {
        if (t.is_free(k)) return true;
        k = t.rotate_ccw(k);
    } while (k != h);
    return false;
}

// The body around a solid triangle: the first body edge met by spreading from there.
BodyId body_around(const Scene2& scene, const Triangulation& t, HalfEdge start) {
    std::vector<std::uint8_t> seen(t.triangle_count(), 0);
    std::vector<HalfEdge> pending{start & ~3U};
    seen[start >> 2U] = 1;
    while (!pending.empty()) {
        const HalfEdge base = pending.back();
        pending.pop_back();
        for (HalfEdge h = base; h < base + 3; ++h) {
            const HalfEdge g = t.twin(h);
            if (g == no_index) return BodyId::none();
            if (t.is_boundary(h)) {
                return scene[t.scene_edge(h)].body;
            } else if (seen[g >> 2U] == 0) {
                seen[g >> 2U] = 1;
                pending.push_back(g & ~3U);
            }
        }
    }
    return BodyId::none();
}

}  // namespace

Result<void> check_size(const Point2& rounded) {
    if (std::fabs(rounded.x) <= 0x1p1020 && std::fabs(rounded.y) <= 0x1p1020) return {};
    return fail(Errc::coordinate_too_large,
                "a coordinate of the point is larger than 2^1020; choose a nearer point");
}

Result<Standpoint> stand_at(const Scene2& scene, const ViewScene& view, const Viewpoint& q,
                            Tally* tally) {
    const Triangulation& t = view.triangulation;
    const Location at = view.locator.locate(q, tally);
    if (is_seeing(t, at)) {
        const HalfEdge h = at.half_edge;
        if (at.kind != Location::Kind::place) return Standpoint{q, at};
        return Standpoint{{t.position(t.origin(h)), t.origin(h)}, at};
    }
    // On a contact several are around: a body is named rather than the outside.
    BodyId body = body_around(scene, t, at.half_edge);
    if (body.is_none() && at.kind == Location::Kind::edge)
        body = body_around(scene, t, t.twin(at.half_edge));
    if (body.is_none() && at.kind == Location::Kind::place)
        for (HalfEdge h = t.rotate_ccw(at.half_edge); body.is_none() && h != at.half_edge;
             h = t.rotate_ccw(h))
            body = body_around(scene, t, h);
    if (body.is_none())
        return fail(
            Errc::outside_of_world,
            "point " + text_of(q) + " lies outside the world; choose a point inside its boundary");
    return fail(Errc::inside_body, "point " + text_of(q) + " lies inside body " +
                                       std::to_string(body.index()) +
                                       "; choose a point outside the bodies");
}

}  // namespace sightline::detail
