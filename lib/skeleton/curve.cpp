// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/curve.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {

namespace {

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

template <typename N>
N one() {
    if constexpr (std::is_same_v<N, Real>) {
        return Real(1.0);
    } else {
        return 1;
    }
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

/// Whether edge c pierces a plane in its relative interior; `plane` gives it for a kind of number.
template <typename PlaneFor>
bool pierces_inside(const SceneForms& forms, const Policy& policy, const PlaneFor& plane_for,
                    EdgeId c) {
    const auto height = [&](VertexId w) {
        const auto of = [&]<typename N>(const N& kind) {
            const PlaneOf<N> plane = plane_for(kind);
            return N(dot(plane.n, forms.point<N>(w)) - plane.k);
        };
        return policy.sign(Predicate::line_form3, of(Real{}),
                           [&] { return sign_of_integer(of(Integer{})); });
    };
    const Edge3& e = forms.scene()[c];
    return height(e.source) * height(e.target) == Sign::negative;
}

/// Whether the plane passes through a point of c that some feature of another body fixes, too.
bool is_fixed_on(const SceneForms& forms, const PlaneOf<Integer>& plane, EdgeId c) {
    const auto has_vertex = [&](VertexId v) {
        return dot(plane.n, forms.point<Integer>(v)) == plane.k;
    };
    const auto has_crossing = [&](EdgeId e) {
        const auto [p, w] = crossing<Integer>(forms, c, e);
        return dot(plane.n, p) == plane.k * w;
    };
    return std::ranges::any_of(forms.vertices_inside(c), has_vertex) ||
           std::ranges::any_of(forms.crossing_edges(c), has_crossing);
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
    const auto [point, weight] = crossing<Integer>(forms, a, b);
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
    const auto plane = [&]<typename N>(const N&) { return plane_of_edges<N>(forms, a, end); };
    if (!pierces_inside(forms, policy, plane, edges[apart])) return std::nullopt;
    if (is_fixed_on(forms, plane(Integer{}), edges[apart])) return std::nullopt;
    Curve curve(forms, policy, CurveKind::plane_pencil);
    curve.vertex_ = end;
    curve.edges_ = {a, b, edges[apart]};
    curve.real_ = curve.compute<Real>();
    return curve;
}

std::optional<Curve> Curve::in_face(const SceneForms& forms, const Policy& policy, FaceId f,
                                    EdgeId a, EdgeId c) {
    const auto plane = [&]<typename N>(const N&) { return forms.plane<N>(f); };
    if (!pierces_inside(forms, policy, plane, c)) return std::nullopt;
    if (is_fixed_on(forms, plane(Integer{}), c)) return std::nullopt;
    if (side_of_edges(forms, policy, a, c) == Sign::zero) return std::nullopt;
    Curve curve(forms, policy, CurveKind::face_pencil);
    curve.edges_ = {a, c};
    curve.contact_ = f;
    curve.real_ = curve.compute<Real>();
    return curve;
}

std::array<Curve, 2> Curve::on_border(const SceneForms& forms, const Policy& policy, FaceId f,
                                      VertexId v, std::array<EdgeId, 2> edges) {
    Curve first(forms, policy, CurveKind::border_pencil);
    first.vertex_ = v;
    first.contact_ = f;
    first.directions_ = edges;
    Curve second = first;
    second.second_half_ = true;
    first.real_ = first.compute<Real>();
    second.real_ = second.compute<Real>();
    return {std::move(first), std::move(second)};
}

std::array<Curve, 2> Curve::on_border(const SceneForms& forms, const Policy& policy, FaceId f,
                                      std::array<EdgeId, 2> edges) {
    Curve first(forms, policy, CurveKind::border_pencil);
    first.contact_ = f;
    first.directions_ = edges;
    first.edges_ = {edges[0], edges[1]};
    Curve second = first;
    second.second_half_ = true;
    first.real_ = first.compute<Real>();
    second.real_ = second.compute<Real>();
    return {std::move(first), std::move(second)};
}

template <typename N>
std::array<PluckerOf<N>, 3> Curve::pencil_through(const Vec3<N>& p, const N& w) const {
    const Vec3<N>& a = forms_->point<N>(forms_->scene()[base()].source);
    const Vec3<N>& u = forms_->line<N>(base().index()).d;
    // From p/w to a + tu, times w.
    return {PluckerOf<N>{w * a - p, cross(p, a)}, PluckerOf<N>{w * u, cross(p, u)}, PluckerOf<N>{}};
}

// From one edge's direction to the other's, and on to the opposite of the first.
template <typename N>
std::array<PluckerOf<N>, 3> Curve::border_lines() const {
    const auto [p, w] = vertex_.is_none() ? crossing<N>(*forms_, edges_[0], edges_[1])
                                          : std::pair{forms_->point<N>(vertex_), one<N>()};
    const Vec3<N>& u = forms_->line<N>(directions_[0].index()).d;
    const Vec3<N>& v = forms_->line<N>(directions_[1].index()).d;
    const Vec3<N> from = second_half_ ? v : u;
    const Vec3<N> to = second_half_ ? -u : v;
    const Vec3<N> change = to - from;
    return {PluckerOf<N>{w * from, cross(p, from)}, PluckerOf<N>{w * change, cross(p, change)},
            PluckerOf<N>{}};
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
    switch (kind_) {
        case CurveKind::vertex_pencil:
            return pencil_through(forms_->point<N>(vertex_), one<N>());
        case CurveKind::contact_pencil: {
            const auto [p, w] = crossing<N>(*forms_, edges_[1], edges_[2]);
            return pencil_through(p, w);
        }
        case CurveKind::plane_pencil: {
            const auto [p, w] = piercing(forms_->line<N>(edges_[2].index()),
                                         plane_of_edges<N>(*forms_, edges_[0], vertex_));
            return pencil_through(p, w);
        }
        case CurveKind::face_pencil: {
            const auto [p, w] =
                piercing(forms_->line<N>(edges_[1].index()), forms_->plane<N>(contact_));
            return pencil_through(p, w);
        }
        case CurveKind::border_pencil:
            return border_lines<N>();
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
    return widest_form({EventForm::Kind::vertex_axis, 0, 0, v, 0});
}

std::optional<EventForm> Curve::crossing_form(EdgeId a, EdgeId b) const {
    return widest_form({EventForm::Kind::crossing_axis, a.value, b.value, VertexId::none(), 0});
}

/// The one of three forms, by axis, that changes most.
std::optional<EventForm> Curve::widest_form(EventForm form) const {
    EventForm best = form;
    double size = -1;
    for (int axis = 0; axis < 3; ++axis) {
        form.axis = axis;
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
    // Two lines of the pencil span its plane; their moments know the point.
    const auto height = [&]<typename N>(const N&) {
        const auto& l = coefficients<N>();
        return dot<N>(normal_from(l[0], forms_->point<N>(v)), l[1].d);
    };
    return policy_->sign(Predicate::line_form3, height(Real{}),
                         [&] { return sign_of_integer(height(Integer{})); }) == Sign::zero;
}

}  // namespace sightline::detail
