// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// One-parameter families of lines with their generators: L(t) is a polynomial of degree 1 or 2 in the
/// position t on one edge, 0 at its source, 1 at its target (mathematics: Swath of three lines).
/// Private.

#include <array>
#include <optional>
#include <vector>

#include "sightline/scene/scene3.hpp"
#include "spatial/exact_line.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

/// q₀ + q₁t + q₂t².
template <typename N>
struct Quadratic {
    N q0{}, q1{}, q2{};
};

/// A function of the line at t whose roots are events.
struct EventForm {
    enum class Kind : std::uint8_t {
        line,          ///< side of line(t) to a line of the scene's forms
        vertex_axis,   ///< a component of the normal from a vertex: of degree 1 on a pencil
        vertex_plane,  ///< whether the base point lies in the plane of a vertex and a line
        edge_plane,    ///< whether the direction is parallel to two lines' plane
        crossing_axis  ///< as vertex_axis, from the point where two edges cross
    };
    Kind kind = Kind::line;
    std::uint32_t line = 0;   ///< of line, vertex_plane, edge_plane, crossing_axis
    std::uint32_t other = 0;  ///< the second line of edge_plane, crossing_axis
    VertexId vertex;          ///< of vertex_axis, vertex_plane
    int axis = 0;
};

enum class CurveKind : std::uint8_t {
    vertex_pencil,   ///< lines through a vertex that meet an edge
    contact_pencil,  ///< lines through the point where two edges cross that meet a third
    plane_pencil,    ///< lines in the plane of two edges through the point where a third pierces it
    face_pencil,     ///< the same in a contact plane, of which only one edge need be met
    border_pencil,  ///< lines in a contact plane through a vertex or crossing on the contact's border
    regulus         ///< lines that meet three pairwise skew edges
};

class Curve {
public:
    /// Empty when v lies on the line of e.
    [[nodiscard]] static std::optional<Curve> pencil(const SceneForms& forms, const Policy& policy,
                                                     VertexId v, EdgeId e);
    /// Lines through the crossing of the edges a and b that meet e; empty when it lies on e's line.
    [[nodiscard]] static std::optional<Curve> contact_pencil(const SceneForms& forms,
                                                             const Policy& policy, EdgeId a,
                                                             EdgeId b, EdgeId e);
    /// Lines that meet three edges in different points; empty when these are no one-parameter family or
    /// the family is a pencil through a vertex or through a point where edges cross.
    [[nodiscard]] static std::optional<Curve> through_edges(const SceneForms& forms,
                                                            const Policy& policy,
                                                            std::array<EdgeId, 3> edges);

    /// Lines in the plane of a face, through edge a, which lies in it, and the point where c pierces it;
    /// empty when c does not, inside.
    [[nodiscard]] static std::optional<Curve> in_face(const SceneForms& forms, const Policy& policy,
                                                      FaceId f, EdgeId a, EdgeId c);
    /// The two halves of the pencil of lines in the plane of a face through a vertex, with two edges of
    /// that plane through it; the edges are not parallel.
    [[nodiscard]] static std::array<Curve, 2> on_border(const SceneForms& forms,
                                                        const Policy& policy, FaceId f, VertexId v,
                                                        std::array<EdgeId, 2> edges);
    /// The same through the point where the edges cross.
    [[nodiscard]] static std::array<Curve, 2> on_border(const SceneForms& forms,
                                                        const Policy& policy, FaceId f,
                                                        std::array<EdgeId, 2> edges);

    [[nodiscard]] CurveKind kind() const { return kind_; }
    /// Of a pencil through a vertex.
    [[nodiscard]] bool has_vertex() const {
        return kind_ == CurveKind::vertex_pencil || kind_ == CurveKind::border_pencil;
    }
    /// The face whose plane must be a contact's for the lines to be a family.
    [[nodiscard]] FaceId contact() const { return contact_; }
    /// Of a vertex pencil, or of a border pencil; then none when it goes through a crossing.
    [[nodiscard]] VertexId vertex() const { return vertex_; }
    /// The edge that carries t first, then the others; of a border pencil those that cross.
    [[nodiscard]] const std::vector<EdgeId>& edges() const { return edges_; }
    [[nodiscard]] EdgeId base() const { return edges_.front(); }
    [[nodiscard]] const SceneForms& forms() const { return *forms_; }
    [[nodiscard]] const Policy& policy() const { return *policy_; }
    [[nodiscard]] int degree() const { return kind_ == CurveKind::regulus ? 2 : 1; }

    /// Coefficients of L(t).
    template <typename N>
    [[nodiscard]] const std::array<PluckerOf<N>, 3>& coefficients() const {
        if constexpr (std::is_same_v<N, Real>) {
            return real_;
        } else {
            if (!exact_) exact_ = compute<Integer>();
            return *exact_;
        }
    }

    template <typename N>
    [[nodiscard]] Quadratic<N> evaluate(const EventForm& form) const;

    /// Whether the form vanishes for all t.
    [[nodiscard]] bool vanishes(const Quadratic<Real>& q, const EventForm& form) const;

    /// The form that is zero where the line passes through a vertex of an edge that all lines of the family
    /// meet; empty when they all pass through it.
    [[nodiscard]] std::optional<EventForm> vertex_form(VertexId v, EdgeId of) const;

    /// The form that is zero where the line of a pencil passes through the crossing of two edges in its plane;
    /// empty when all do.
    [[nodiscard]] std::optional<EventForm> crossing_form(EdgeId a, EdgeId b) const;

    /// Whether a vertex lies in the plane of a pencil.
    [[nodiscard]] bool is_in_plane(VertexId v) const;

private:
    Curve(const SceneForms& forms, const Policy& policy, CurveKind kind)
        : forms_(&forms), policy_(&policy), kind_(kind) {}

    template <typename N>
    [[nodiscard]] std::array<PluckerOf<N>, 3> compute() const;
    template <typename N>
    [[nodiscard]] std::array<PluckerOf<N>, 3> pencil_through(const Vec3<N>& p, const N& w) const;
    template <typename N>
    [[nodiscard]] std::array<PluckerOf<N>, 3> border_lines() const;
    template <typename N>
    [[nodiscard]] std::array<PluckerOf<N>, 3> ruling() const;
    [[nodiscard]] std::optional<EventForm> widest_form(EventForm form) const;

    const SceneForms* forms_;
    const Policy* policy_;
    CurveKind kind_;
    VertexId vertex_;  ///< the pencil's; of a plane pencil: what spans the plane with the base
    std::vector<EdgeId> edges_;
    FaceId contact_;
    std::array<EdgeId, 2> directions_;  ///< of a border pencil
    bool second_half_ = false;
    std::array<PluckerOf<Real>, 3> real_;
    mutable std::optional<std::array<PluckerOf<Integer>, 3>> exact_;
};

/// The point where two lines of one plane cross, homogeneous: point and weight. Zero when parallel.
template <typename N>
std::pair<Vec3<N>, N> crossing(const SceneForms& forms, EdgeId a, EdgeId b) {
    // p = on_a + s·a.d with (p − on_b) × b.d = 0: s = −((on_a − on_b) × b.d)·n / n·n, n = a.d × b.d.
    const PluckerOf<N>& first = forms.line<N>(a.index());
    const PluckerOf<N>& second = forms.line<N>(b.index());
    const Vec3<N>& on_first = forms.point<N>(forms.scene()[a].source);
    const Vec3<N>& on_second = forms.point<N>(forms.scene()[b].source);
    const Vec3<N> n = cross(first.d, second.d);
    const N weight = dot(n, n);
    const N s = N(-dot(cross<N>(on_first - on_second, second.d), n));
    return {weight * on_first + s * first.d, weight};
}

template <typename N>
Quadratic<N> Curve::evaluate(const EventForm& form) const {
    const auto& l = coefficients<N>();
    if (form.kind == EventForm::Kind::line) {
        const PluckerOf<N>& g = forms_->line<N>(form.line);
        return {side(l[0], g), side(l[1], g), side(l[2], g)};
    }
    if (form.kind == EventForm::Kind::edge_plane) {
        const Vec3<N> n = cross(forms_->line<N>(form.line).d, forms_->line<N>(form.other).d);
        return {dot(n, l[0].d), dot(n, l[1].d), dot(n, l[2].d)};
    }
    if (form.kind == EventForm::Kind::crossing_axis) {
        const auto [p, w] = crossing<N>(*forms_, EdgeId{form.line}, EdgeId{form.other});
        const auto normal = [&](const PluckerOf<N>& line) {
            const PluckerOf<N> scaled{line.d, w * line.m};
            return normal_from(scaled, p, form.axis);
        };
        return {normal(l[0]), normal(l[1]), normal(l[2])};
    }
    const Vec3<N>& v = forms_->point<N>(form.vertex);
    if (form.kind == EventForm::Kind::vertex_axis) {
        return {normal_from(l[0], v, form.axis), normal_from(l[1], v, form.axis),
                normal_from(l[2], v, form.axis)};
    }
    const PluckerOf<N>& g = forms_->line<N>(form.line);
    const Vec3<N> n = normal_from(g, v);
    const Edge3& e = forms_->scene()[base()];
    const Vec3<N>& a = forms_->point<N>(e.source);
    return {N(dot(n, a) - dot(g.m, v)), dot(n, forms_->line<N>(base().index()).d), N{}};
}

}  // namespace sightline::detail
