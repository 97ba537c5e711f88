// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/reach.hpp"

#include <algorithm>

#include "skeleton/curve_box.hpp"

namespace sightline::detail {

void ReachSearch::search_segment(const StoppingFaces& stopping,
                                 std::span<const EventName> dismissed) {
    stopping_ = &stopping;
    dismissed_ = dismissed;
    const auto low = [&] { return std::max(reach_.left.lower(), 0.0); };
    const auto high = [&] { return std::min(reach_.right.upper(), 1.0); };
    CurveBoxTest test(curve_, stopping, low(), high());
    curve_.forms().edges().traverse(test, [&](std::uint32_t e) {
        if (consider_edge(EdgeId{e}, false)) test.set_interval(low(), high());
    });
    stopping_ = nullptr;
}

void ReachSearch::search_all(std::span<const EventName> dismissed) {
    search_segment({}, dismissed);
}

void ReachSearch::search_edges(std::span<const EdgeId> edges) {
    for (const EdgeId e : edges) consider_edge(e, true);
}

bool ReachSearch::consider_edge(EdgeId e, bool everywhere) {
    // Lines of a contact's pencil may run along one of the edges that cross there.
    const bool is_generator = curve_.kind() == CurveKind::contact_pencil
                                  ? e == curve_.base()
                                  : std::ranges::find(curve_.edges(), e) != curve_.edges().end();
    const EventForm form{EventForm::Kind::line, e.value, 0, VertexId::none(), 0};
    if (is_generator) return consider_crossings(e, everywhere);  // their ends are the interval's
    const Quadratic<Real> q = curve_.evaluate<Real>(form);
    if (surely_outside(q)) return false;
    if (!curve_.vanishes(q, form)) return consider_form(form, e, everywhere);
    const Edge3& edge = curve_.forms().scene()[e];
    bool narrowed = false;
    for (const VertexId v : {edge.source, edge.target}) {
        if (surely_passes_outside(v)) continue;
        if (const auto at_vertex = curve_.vertex_form(v, e)) {
            narrowed = consider_form(*at_vertex, e, everywhere) || narrowed;
        }
    }
    return consider_crossings(e, everywhere) || narrowed;
}

/// Whether no line of what is left of the pencil passes through v: one coordinate is enough to tell.
bool ReachSearch::surely_passes_outside(VertexId v) const {
    if (curve_.kind() == CurveKind::regulus) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const EventForm form{EventForm::Kind::vertex_axis, 0, 0, v, axis};
        if (surely_outside(curve_.evaluate<Real>(form))) return true;
    }
    return false;
}

/// Whether all lines of the curve meet the line of e.
bool ReachSearch::contains_all(EdgeId e) const {
    if (std::ranges::find(curve_.edges(), e) != curve_.edges().end()) return true;
    const EventForm form{EventForm::Kind::line, e.value, 0, VertexId::none(), 0};
    return curve_.vanishes(curve_.evaluate<Real>(form), form);
}

/// Where lines of a pencil pass through the point where e, which all of them meet, crosses another such edge.
bool ReachSearch::consider_crossings(EdgeId e, bool everywhere) {
    if (curve_.kind() == CurveKind::regulus) return false;
    bool narrowed = false;
    for (const EdgeId other : curve_.forms().crossing_edges(e)) {
        if (!contains_all(other)) continue;
        if (const auto form = curve_.crossing_form(e, other)) {
            narrowed = consider_form(*form, e, everywhere) || narrowed;
        }
    }
    return narrowed;
}

/// Bernstein's coefficients on what is left of the interval: no root when all have one sign.
bool ReachSearch::surely_outside(const Quadratic<Real>& q) const {
    const Real a(reach_.left.lower());
    const Real b(reach_.right.upper());
    const auto at_a = (q.q0 + a * (q.q1 + a * q.q2)).sign();
    if (!at_a || *at_a == Sign::zero) return false;
    if (at_a != (q.q0 + b * (q.q1 + b * q.q2)).sign()) return false;
    if (curve_.degree() == 1) return true;
    return at_a == (q.q0 + Real(0.5) * (a + b) * q.q1 + a * b * q.q2).sign();
}

bool ReachSearch::consider_form(const EventForm& form, EdgeId e, bool everywhere) {
    bool narrowed = false;
    for (Parameter& t : roots(curve_, form, curve_.evaluate<Real>(form))) {
        if (t.upper() < reach_.left.lower() || t.lower() > reach_.right.upper()) continue;
        narrowed = offer(std::move(t), e, form, everywhere) || narrowed;
    }
    return narrowed;
}

bool ReachSearch::offer(Parameter&& t, EdgeId e, const EventForm& form, bool everywhere) {
    const bool is_crossing = form.kind == EventForm::Kind::crossing_axis;
    const EventName name{e, form.vertex, t.branch(),
                         is_crossing ? EdgeId{form.other} : EdgeId::none()};
    if (std::ranges::find(dismissed_, name) != dismissed_.end()) return false;
    const Sign side = compare(policy_, t, sample_);
    const bool is_left = side == Sign::negative;
    if (side != Sign::zero) {
        const Sign beyond =
            is_left ? compare(policy_, t, reach_.left) : compare(policy_, reach_.right, t);
        if (beyond != Sign::positive) return false;
    }
    if (!everywhere && surely_irrelevant(t, e)) return false;
    if (side == Sign::zero) {
        hit_sample_ = true;
    } else if (is_left) {
        reach_.left = std::move(t);
        reach_.left_is_event = true;
        reach_.left_event = name;
    } else {
        reach_.right = std::move(t);
        reach_.right_is_event = true;
        reach_.right_event = name;
    }
    return true;
}

/// Whether the line at t misses the closed edge, or meets it behind a stopping face.
bool ReachSearch::surely_irrelevant(const Parameter& t, EdgeId e) const {
    const SceneForms& forms = curve_.forms();
    const PluckerOf<Real> line = CurvePoint(curve_, t).real_line();
    const Edge3& edge = forms.scene()[e];
    const Vec3<Real>& u = forms.point<Real>(edge.source);
    const Vec3<Real>& w = forms.point<Real>(edge.target);
    const Vec3<Real> at_u = normal_from(line, u);
    const Vec3<Real> at_w = normal_from(line, w);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(at_u[i].value() - at_w[i].value()) >
            std::abs(at_u[axis].value() - at_w[axis].value())) {
            axis = i;
        }
    }
    const auto s = at_u[axis].sign();
    const auto r = at_w[axis].sign();
    if (s && r && *s != Sign::zero && *s == *r) return true;
    if (stopping_ == nullptr) return false;
    const Real share = at_u[axis] / (at_u[axis] - at_w[axis]);
    const Vec3<Real> x = u + share * (w - u);
    const auto is_behind = [&](FaceId f) {
        const PlaneOf<Real>& plane = forms.plane<Real>(f);
        return (dot(plane.n, x) - plane.k).sign() == Sign::negative;
    };
    return std::ranges::any_of(*stopping_, [&](const auto& faces) {
        return !faces.empty() && std::ranges::all_of(faces, is_behind);
    });
}

}  // namespace sightline::detail
