// SPDX-License-Identifier: GPL-3.0-or-later
#include "event/contacts.hpp"

#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

Contacts::Contacts(const Scene2& scene) : scene_(&scene), at_(scene.vertex_count()) {
    for (const Edge2& e : scene.edges()) {
        Contact& source = at_[e.source];
        Contact& target = at_[e.target];
        source.next = e.target;
        target.previous = e.source;
        source.body = target.body = e.body;
        source.of_area = target.of_area = e.kind != EdgeKind2::wall;
    }
}

std::uint32_t Contacts::owner(VertexId v) const {
    const Contact& c = at_[v];
    const auto bodies = static_cast<std::uint32_t>(scene_->body_count());
    if (!c.of_area) return bodies + 1 + v.value;
    return c.body.is_none() ? bodies : c.body.value;
}

Side Contacts::side(const Point2& from, const Point2& to, VertexId v) const {
    const Contact& c = at_[v];
    const auto side_of = [&](VertexId u) {
        return u.is_none() ? Sign::zero : orientation(from, to, (*scene_)[u]);
    };
    const Sign next = side_of(c.next);
    const Sign previous = side_of(c.previous);
    if (next * previous == Sign::negative) return Side::both;
    if (next != Sign::zero) return next == Sign::positive ? Side::left : Side::right;
    if (previous != Sign::zero) return previous == Sign::positive ? Side::left : Side::right;
    if (!c.of_area) return Side::on;
    // Straight: the inside is on the left of v→next, which runs along the line or against it.
    return ((*scene_)[v] < (*scene_)[c.next]) == (from < to) ? Side::left : Side::right;
}

Bitangent Contacts::bitangent(VertexId v, VertexId w) const {
    const Point2& from = (*scene_)[v];
    const Point2& to = (*scene_)[w];
    return {at_[v].body, at_[w].body, side(from, to, v), side(from, to, w), v, w};
}

}  // namespace sightline::detail
