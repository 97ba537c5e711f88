// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial/local_cone.hpp"

#include <algorithm>
#include <optional>

namespace sightline::detail {

namespace {

using Where = LocalState::Where;

Sign facing(const SceneForms& forms, const Line& line, FaceId f, Heading heading) {
    const Sign sign = line.sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
        return dot(forms.plane<N>(f).n, l.d);
    });
    return heading == Heading::forward ? sign : -sign;
}

LocalState on(FaceId f) { return {Where::on, {f, FaceId::none()}, EdgeShape::convex}; }
LocalState off(bool is_in) { return {is_in ? Where::in : Where::out, {}, EdgeShape::convex}; }

LocalState wedge_state(const Edge3& edge, EdgeShape shape, Sign left, Sign right) {
    if (shape == EdgeShape::convex) {
        if (left == Sign::positive || right == Sign::positive) return off(false);
        if (left == Sign::zero) return on(edge.faces[0]);
        if (right == Sign::zero) return on(edge.faces[1]);
        return off(true);
    }
    if (left == Sign::negative || right == Sign::negative) return off(true);
    if (left == Sign::zero) return on(edge.faces[0]);
    if (right == Sign::zero) return on(edge.faces[1]);
    return off(false);
}

/// Faces all bent one way: the cone is convex (or its complement is).
LocalState simple_vertex_state(const SceneForms& forms, const Line& line, VertexId v,
                               Heading heading, Sign outside) {
    LocalState state = off(outside == Sign::positive);
    std::size_t zeros = 0;
    std::array<FaceId, 2> on_faces{FaceId::none(), FaceId::none()};
    for (const FaceId f : forms.faces_at(v)) {
        const Sign sign = facing(forms, line, f, heading);
        if (sign == outside) return off(outside != Sign::positive);
        if (sign == Sign::zero && zeros < 2) on_faces[zeros++] = f;
    }
    if (zeros > 0) {
        state.where = Where::on;
        state.faces = on_faces;
        state.shape = outside == Sign::positive ? EdgeShape::convex : EdgeShape::reflex;
    }
    return state;
}

/// A face's corner at a vertex: it fills the turn from `next` to `previous`, counter-clockwise about n.
struct Sector {
    FaceId face;
    Vec3<Integer> n, next, previous;

    [[nodiscard]] Sign turn(const Vec3<Integer>& a, const Vec3<Integer>& b) const {
        return sign_of_integer(dot(n, cross(a, b)));
    }
    /// For x in the plane: whether the closed corner contains it.
    [[nodiscard]] bool contains(const Vec3<Integer>& x) const {
        const Sign opening = turn(next, previous);
        const Sign from = turn(next, x);
        const Sign to = turn(x, previous);
        if (opening == Sign::zero) return from != Sign::negative;
        if (opening == Sign::positive) {
            return from != Sign::negative && to != Sign::negative &&
                   !(from == Sign::zero && to == Sign::zero);
        }
        return from != Sign::negative || to != Sign::negative;
    }
    [[nodiscard]] Vec3<Integer> inner(int weight) const {
        const Sign opening = turn(next, previous);
        if (opening == Sign::zero) return cross(n, next) + Integer(weight - 1) * next;
        const Vec3<Integer> sum = Integer(weight) * next + previous;
        return opening == Sign::positive ? sum : -sum;
    }
};

bool is_zero(const Vec3<Integer>& x) { return sgn(x[0]) == 0 && sgn(x[1]) == 0 && sgn(x[2]) == 0; }

bool same_direction(const Vec3<Integer>& a, const Vec3<Integer>& b) {
    return is_zero(cross(a, b)) && sgn(dot(a, b)) > 0;
}

/// The link of a vertex as a polygon on the sphere of directions.
class VertexLink {
public:
    VertexLink(const SceneForms& forms, VertexId v) : forms_(forms), v_(v) {
        const Vec3<Integer>& apex = forms.point<Integer>(v);
        for (const FaceId f : forms.faces_at(v)) {
            for (const auto& ring : forms.scene()[f].rings) {
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    if (ring[i] != v) continue;
                    const VertexId next = ring[(i + 1) % ring.size()];
                    const VertexId previous = ring[(i + ring.size() - 1) % ring.size()];
                    sectors_.push_back({f, forms.plane<Integer>(f).n,
                                        forms.point<Integer>(next) - apex,
                                        forms.point<Integer>(previous) - apex});
                }
            }
        }
    }

    [[nodiscard]] LocalState state(const Vec3<Integer>& direction) const {
        if (const auto edge = edge_along(direction)) {
            return {Where::on, forms_.scene()[*edge].faces, forms_.shape(*edge)};
        }
        for (const Sector& s : sectors_) {
            if (sgn(dot(s.n, direction)) == 0 && s.contains(direction)) return on(s.face);
        }
        for (const Sector& s : sectors_) {
            for (const int weight : {1, 2, 3}) {
                if (const auto inside = is_inside(direction, s.inner(weight))) return off(*inside);
            }
        }
        return off(false);
    }

private:
    [[nodiscard]] std::optional<EdgeId> edge_along(const Vec3<Integer>& x) const {
        for (const EdgeId e : forms_.scene().edges_at(v_)) {
            if (same_direction(ray(e), x)) return e;
        }
        return std::nullopt;
    }
    [[nodiscard]] Vec3<Integer> ray(EdgeId e) const {
        const Edge3& edge = forms_.scene()[e];
        const VertexId other = edge.source == v_ ? edge.target : edge.source;
        return forms_.point<Integer>(other) - forms_.point<Integer>(v_);
    }

    /// Follows the great circle from x towards t, a direction inside a face, to the first point of
    /// the surface, and reads the side there. Empty when x and t are opposite.
    [[nodiscard]] std::optional<bool> is_inside(const Vec3<Integer>& x,
                                                const Vec3<Integer>& t) const {
        if (is_zero(cross(x, t))) return std::nullopt;
        // Hits are x + λt, λ = numerator / denominator, the smallest wins.
        Integer numerator = 1;
        Integer denominator = 0;
        Vec3<Integer> first;
        const Sector* hit = nullptr;
        const auto offer = [&](const Sector& s, const Integer& num, const Integer& den) {
            if (hit != nullptr && num * denominator >= numerator * den) return;
            const Vec3<Integer> at = den * x + num * t;
            if (!s.contains(at)) return;
            hit = &s;
            numerator = num;
            denominator = den;
            first = at;
        };
        for (const Sector& s : sectors_) {
            const Integer fx = dot(s.n, x);
            const Integer ft = dot(s.n, t);
            if (sgn(fx) != 0 && sgn(ft) != sgn(fx)) {
                offer(s, Integer(abs(fx)), Integer(abs(ft)));
            }
            // In the sector's plane: the arc can only enter it at a ray. The other face at that ray
            // reports it, for two faces at a ray are not coplanar.
        }
        if (hit == nullptr) return std::nullopt;
        if (const auto edge = edge_along(first)) {
            const auto& faces = forms_.scene()[*edge].faces;
            if (faces[0].is_none() || faces[1].is_none()) return std::nullopt;
            const Sign left = sign_of_integer(dot(forms_.plane<Integer>(faces[0]).n, x));
            const Sign right = sign_of_integer(dot(forms_.plane<Integer>(faces[1]).n, x));
            if (forms_.shape(*edge) == EdgeShape::convex) {
                return left == Sign::negative && right == Sign::negative;
            }
            return left == Sign::negative || right == Sign::negative;
        }
        return sgn(dot(hit->n, x)) < 0;
    }

    const SceneForms& forms_;
    VertexId v_;
    std::vector<Sector> sectors_;
};

bool is_border_vertex(const SceneForms& forms, VertexId v) {
    return std::ranges::any_of(forms.scene().edges_at(v),
                               [&](EdgeId e) { return forms.shape(e) == EdgeShape::border; });
}

}  // namespace

LocalState state_at(const SceneForms& forms, const Line& line, FaceId f, Heading heading) {
    return off(facing(forms, line, f, heading) == Sign::negative);
}

LocalState state_at(const SceneForms& forms, const Line& line, EdgeId e, Heading heading) {
    const Edge3& edge = forms.scene()[e];
    const EdgeShape shape = forms.shape(e);
    if (shape == EdgeShape::border) {
        const FaceId face = edge.faces[0].is_none() ? edge.faces[1] : edge.faces[0];
        if (facing(forms, line, face, heading) != Sign::zero) return {Where::open, {}, shape};
        const Sign into = line.sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
            return dot(cross(forms.plane<N>(face).n, forms.line<N>(e.index()).d), l.d);
        });
        const bool leftwards = (into == Sign::positive) == (heading == Heading::forward);
        const bool is_left = !edge.faces[0].is_none();
        return leftwards == is_left ? on(face) : LocalState{Where::open, {}, shape};
    }
    return wedge_state(edge, shape, facing(forms, line, edge.faces[0], heading),
                       facing(forms, line, edge.faces[1], heading));
}

LocalState state_at(const SceneForms& forms, const Line& line, VertexId v, Heading heading) {
    switch (forms.shape(v)) {
        case VertexShape::convex:
            return simple_vertex_state(forms, line, v, heading, Sign::positive);
        case VertexShape::reflex:
            return simple_vertex_state(forms, line, v, heading, Sign::negative);
        default:
            break;
    }
    const ExactLine& exact = line.exact();
    const Vec3<Integer> direction = heading == Heading::forward ? exact.a.d : -exact.a.d;
    LocalState state = VertexLink(forms, v).state(direction);
    if (forms.shape(v) == VertexShape::sheet && is_border_vertex(forms, v) &&
        state.where != Where::on) {
        state.where = Where::open;
    }
    return state;
}

namespace {

/// A sector round the line, from one ray to another, counter-clockwise about the line's direction.
struct Wedge {
    Vec3<Integer> from, to;
};

/// Rays across the line d, up to multiples of d: turning from a to b is the sign of d·(a × b).
bool turns_left(const Vec3<Integer>& d, const Vec3<Integer>& a, const Vec3<Integer>& b) {
    return sgn(dot(d, cross(a, b))) > 0;
}

bool same_ray(const Vec3<Integer>& d, const Vec3<Integer>& a, const Vec3<Integer>& b) {
    if (sgn(dot(d, cross(a, b))) != 0) return false;
    return sgn(dot(cross(d, a), cross(d, b))) > 0;
}

/// Whether the directions just after ray r, counter-clockwise, are inside the wedge.
bool covers_after(const Vec3<Integer>& d, const Wedge& w, const Vec3<Integer>& r) {
    if (same_ray(d, r, w.from)) return true;
    if (same_ray(d, r, w.to)) return false;
    const bool after_from = turns_left(d, w.from, r);
    const bool before_to = turns_left(d, r, w.to);
    const Integer opening = dot(d, cross(w.from, w.to));
    if (sgn(opening) > 0) return after_from && before_to;
    if (sgn(opening) < 0) return after_from || before_to;
    return after_from;  // half a turn
}

Wedge section(const SceneForms& forms, const Vec3<Integer>& d, const LocalState& state) {
    const Vec3<Integer>& n = forms.plane<Integer>(state.faces[0]).n;
    const Vec3<Integer> across = cross(d, n);
    // The half plane behind the face: counter-clockwise from the ray at the left of −n's right.
    if (state.faces[1].is_none()) return {across, -across};
    const Vec3<Integer>& other = forms.plane<Integer>(state.faces[1]).n;
    const Vec3<Integer> across_other = cross(d, other);
    // Behind a half plane runs from d × n to n × d; both half planes meet, or join, in a wedge.
    const bool other_is_later = sgn(dot(d, cross(n, other))) > 0;
    const bool meet = state.shape == EdgeShape::convex;
    return other_is_later == meet ? Wedge{across_other, -across} : Wedge{across, -across_other};
}

}  // namespace

bool is_sealed(const SceneForms& forms, const Line& line, const std::vector<LocalState>& along) {
    // An irrational line lies in rational planes only along both of its parts.
    const ExactLine& exact = line.exact();
    const auto is_zero = [](const Integer& x) { return sgn(x) == 0; };
    const Vec3<Integer>& d = std::ranges::all_of(exact.a.d, is_zero) ? exact.b.d : exact.a.d;
    std::vector<Wedge> wedges;
    for (const LocalState& state : along) {
        if (!state.faces[1].is_none() && state.shape != EdgeShape::convex &&
            state.shape != EdgeShape::reflex) {
            continue;  // a sheet covers nothing
        }
        wedges.push_back(section(forms, d, state));
    }
    if (wedges.empty()) return false;
    return std::ranges::all_of(wedges, [&](const Wedge& w) {
        return std::ranges::any_of(
            wedges, [&](const Wedge& other) { return covers_after(d, other, w.to); });
    });
}

}  // namespace sightline::detail
