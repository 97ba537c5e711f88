// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/curve.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {

namespace {

/// The point where two lines of one plane cross, homogeneous: point and weight. Zero when parallel.
template <typename N>
std::pair<Vec3<N>, N> crossing(const PluckerOf<N>& a, const Vec3<N>& on_a, const PluckerOf<N>& b,
                               const Vec3<N>& on_b) {
    // p = on_a + s·a.d with (p − on_b) × b.d = 0: s = −((on_a − on_b) × b.d)·n / n·n, n = a.d × b.d.
    const Vec3<N> n = cross(a.d, b.d);
    const N weight = dot(n, n);
    const N s = N(-dot(cross<N>(on_a - on_b, b.d), n));
    return {weight * on_a + s * a.d, weight};
}

/// The point where a line pierces a plane, homogeneous.
template <typename N>
std::pair<Vec3<N>, N> piercing(const PluckerOf<N>& line, const PlaneOf<N>& plane) {
    return {plane.k * line.d + cross(plane.n, line.m), dot(plane.n, line.d)};
}

/// The plane of edge a and one end of edge b, which lies in one plane with it.
template <typename N>
PlaneOf<N> plane_of_edges(const SceneForms& forms, EdgeId a, VertexId end_of_b) {
    const Vec3<N>& v = forms.point<N>(end_of_b);
    const Vec3<N> n = normal_from(forms.line<N>(a.index()), v);
    return {n, dot(n, v)};
}

/// The end of b that is farther from a's line, so that the plane is well determined.
VertexId far_end(const SceneForms& forms, EdgeId a, EdgeId b) {
    const Edge3& edge = forms.scene()[b];
    const auto distance = [&](VertexId v) {
        const Vec3<Real> n = normal_from(forms.line<Real>(a.index()), forms.point<Real>(v));
        return dot(n, n).value();
    };
    return distance(edge.source) >= distance(edge.target) ? edge.source : edge.target;
}

Sign side_of_edges(const SceneForms& forms, const Policy& policy, EdgeId a, EdgeId b) {
    const auto of = [&]<typename N>(const N&) {
        return side(forms.line<N>(a.index()), forms.line<N>(b.index()));
    };
    return policy.sign(Predicate::line_form3, of(Real{}),
                       [&] { return sign_of_integer(of(Integer{})); });
}

bool is_on_line(const SceneForms& forms, const Policy& policy, VertexId v, EdgeId e) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto of = [&]<typename N>(const N&) {
            return normal_from(forms.line<N>(e.index()), forms.point<N>(v), axis);
        };
        const Sign sign = policy.sign(Predicate::line_form3, of(Real{}),
                                      [&] { return sign_of_integer(of(Integer{})); });
        if (sign != Sign::zero) return false;
    }
    return true;
}

/// Whether edge c pierces the plane of edge a and the vertex in its relative interior.
bool pierces_inside(const SceneForms& forms, const Policy& policy, EdgeId a, VertexId v, EdgeId c) {
    const auto height = [&](VertexId w) {
        const auto of = [&]<typename N>(const N&) {
            const PlaneOf<N> plane = plane_of_edges<N>(forms, a, v);
            return N(dot(plane.n, forms.point<N>(w)) - plane.k);
        };
        return policy.sign(Predicate::line_form3, of(Real{}),
                           [&] { return sign_of_integer(of(Integer{})); });
    };
    const Edge3& e = forms.scene()[c];
    return height(e.source) * height(e.target) == Sign::negative;
}

}  // namespace

std::optional<Curve> Curve::pencil(const SceneForms& forms, const Policy& policy, VertexId v,
                                   EdgeId e) {
    if (is_on_line(forms, policy, v, e)) return std::nullopt;
    Curve curve(forms, policy, CurveKind::vertex_pencil);
    curve.vertex_ = v;
    curve.edges_ = {e};
    curve.real_ = curve.compute<Real>();
    return curve;
}

std::optional<Curve> Curve::contact_pencil(const SceneForms& forms, const Policy& policy, EdgeId a,
                                           EdgeId b, EdgeId e) {
    const auto [point, weight] =
        crossing(forms.line<Integer>(a.index()), forms.point<Integer>(forms.scene()[a].source),
                 forms.line<Integer>(b.index()), forms.point<Integer>(forms.scene()[b].source));
    const PluckerOf<Integer>& line = forms.line<Integer>(e.index());
    const Vec3<Integer> off = weight * line.m - cross(point, line.d);
    if (sgn(off[0]) == 0 && sgn(off[1]) == 0 && sgn(off[2]) == 0) return std::nullopt;
    Curve curve(forms, policy, CurveKind::contact_pencil);
    curve.edges_ = {e, a, b};
    curve.real_ = curve.compute<Real>();
    return curve;
}

std::optional<Curve> Curve::through_edges(const SceneForms& forms, const Policy& policy,
                                          std::array<EdgeId, 3> edges) {
    int coplanar = 0;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const EdgeId a = edges[(i + 1) % 3];
        const EdgeId b = edges[(i + 2) % 3];
        if (side_of_edges(forms, policy, a, b) != Sign::zero) continue;
        ++coplanar;
        apart = i;
    }
    if (coplanar > 1) return std::nullopt;
    if (coplanar == 0) {
        Curve curve(forms, policy, CurveKind::regulus);
        curve.edges_ = {edges[0], edges[1], edges[2]};
        curve.real_ = curve.compute<Real>();
        return curve;
    }
    const EdgeId a = edges[(apart + 1) % 3];
    const EdgeId b = edges[(apart + 2) % 3];
    VertexId end = far_end(forms, a, b);
    if (is_on_line(forms, policy, end, a)) {
        const Edge3& edge = forms.scene()[b];
        end = end == edge.source ? edge.target : edge.source;
        if (is_on_line(forms, policy, end, a)) return std::nullopt;  // one line
    }
    if (!pierces_inside(forms, policy, a, end, edges[apart])) return std::nullopt;
    Curve curve(forms, policy, CurveKind::plane_pencil);
    curve.vertex_ = end;
    curve.edges_ = {a, b, edges[apart]};
    curve.real_ = curve.compute<Real>();
    return curve;
}

template <typename N>
std::array<PluckerOf<N>, 3> Curve::pencil_through(const Vec3<N>& p, const N& w) const {
    const Vec3<N>& a = forms_->point<N>(forms_->scene()[base()].source);
    const Vec3<N>& u = forms_->line<N>(base().index()).d;
    // From p/w to a + tu, times w.
    return {PluckerOf<N>{w * a - p, cross(p, a)}, PluckerOf<N>{w * u, cross(p, u)}, PluckerOf<N>{}};
}

template <typename N>
std::array<PluckerOf<N>, 3> Curve::ruling() const {
    const Vec3<N>& a = forms_->point<N>(forms_->scene()[base()].source);
    const Vec3<N>& u = forms_->line<N>(base().index()).d;
    const PluckerOf<N>& l2 = forms_->line<N>(edges_[1].index());
    const PluckerOf<N>& l3 = forms_->line<N>(edges_[2].index());
    const Vec3<N> n20 = normal_from(l2, a);
    const Vec3<N> n21 = -cross(u, l2.d);
    const Vec3<N> n30 = normal_from(l3, a);
    const Vec3<N> n31 = -cross(u, l3.d);
    const N a2 = dot(a, l2.m);
    const N u2 = dot(u, l2.m);
    const N a3 = dot(a, l3.m);
    const N u3 = dot(u, l3.m);
    return {PluckerOf<N>{cross(n20, n30), a3 * n20 - a2 * n30},
            PluckerOf<N>{cross(n20, n31) + cross(n21, n30),
                         (a3 * n21 + u3 * n20) - (a2 * n31 + u2 * n30)},
            PluckerOf<N>{cross(n21, n31), u3 * n21 - u2 * n31}};
}

template <typename N>
std::array<PluckerOf<N>, 3> Curve::compute() const {
    const auto point_on = [&](EdgeId e) -> const Vec3<N>& {
        return forms_->point<N>(forms_->scene()[e].source);
    };
    switch (kind_) {
        case CurveKind::vertex_pencil: {
            N one{};
            if constexpr (std::is_same_v<N, Real>) {
                one = Real(1.0);
            } else {
                one = 1;
            }
            return pencil_through(forms_->point<N>(vertex_), one);
        }
        case CurveKind::contact_pencil: {
            const auto [p, w] = crossing(forms_->line<N>(edges_[1].index()), point_on(edges_[1]),
                                         forms_->line<N>(edges_[2].index()), point_on(edges_[2]));
            return pencil_through(p, w);
        }
        case CurveKind::plane_pencil: {
            const auto [p, w] = piercing(forms_->line<N>(edges_[2].index()),
                                         plane_of_edges<N>(*forms_, edges_[0], vertex_));
            return pencil_through(p, w);
        }
        case CurveKind::regulus:
            break;
    }
    return ruling<N>();
}

bool Curve::vanishes(const Quadratic<Real>& q, const EventForm& form) const {
    for (const Real* x : {&q.q0, &q.q1, &q.q2}) {
        if (x->sign().value_or(Sign::zero) != Sign::zero) return false;
    }
    if (policy_->arithmetic == Arithmetic::double_) {
        return q.q0.value() == 0 && q.q1.value() == 0 && q.q2.value() == 0;
    }
    if (policy_->arithmetic == Arithmetic::interval) return true;
    const Quadratic<Integer> e = evaluate<Integer>(form);
    return sgn(e.q0) == 0 && sgn(e.q1) == 0 && sgn(e.q2) == 0;
}

std::optional<EventForm> Curve::vertex_form(VertexId v, EdgeId of) const {
    if (kind_ == CurveKind::regulus) {
        // v is on one line of the opposite ruling; with another one it spans a plane that the base
        // crosses where the family passes v.
        EventForm form{EventForm::Kind::vertex_plane, 0, 0, v, 0};
        form.line = (of == edges_[1] ? edges_[2] : edges_[1]).value;
        if (of == base()) return std::nullopt;  // t is 0 or 1 there
        return form;
    }
    if (!is_in_plane(v)) return std::nullopt;
    EventForm best{EventForm::Kind::vertex_axis, 0, 0, v, 0};
    double size = -1;
    for (int axis = 0; axis < 3; ++axis) {
        const EventForm form{EventForm::Kind::vertex_axis, 0, 0, v, axis};
        const Quadratic<Real> q = evaluate<Real>(form);
        if (std::abs(q.q1.value()) <= size && size >= 0) continue;
        if (vanishes(q, form)) continue;
        size = std::abs(q.q1.value());
        best = form;
    }
    if (size < 0) return std::nullopt;
    return best;
}

bool Curve::is_in_plane(VertexId v) const {
    const auto height = [&]<typename N>(const N&) {
        const Vec3<N>& a = forms_->point<N>(forms_->scene()[base()].source);
        const Vec3<N> n = cross(coefficients<N>()[0].d, forms_->line<N>(base().index()).d);
        return dot<N>(forms_->point<N>(v) - a, n);
    };
    return policy_->sign(Predicate::line_form3, height(Real{}),
                         [&] { return sign_of_integer(height(Integer{})); }) == Sign::zero;
}

}  // namespace sightline::detail
