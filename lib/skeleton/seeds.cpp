// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/seeds.hpp"

#include <algorithm>

#include "spatial/line_box.hpp"

namespace sightline::detail {

VertexSight::VertexSight(const SceneForms& forms, const Policy& policy)
    : forms_(forms), policy_(policy) {
    const Scene3& scene = forms.scene();
    side_of_face_.resize(scene.faces().size());
    hidden_by_.resize(scene.vertices().size());
    is_asked_.resize(scene.vertices().size());
    triangles_of_.resize(scene.faces().size());
    for (std::uint32_t t = 0; t < scene.triangles().size(); ++t) {
        triangles_of_[scene.triangles()[t].face.index()].push_back(t);
    }
    find_convex_faces();
}

void VertexSight::find_convex_faces() {
    for (const Face3& face : forms_.scene().faces()) {
        const PlaneOf<Integer>& plane =
            forms_.plane<Integer>(FaceId{static_cast<std::uint32_t>(is_convex_.size())});
        bool convex = face.rings.size() == 1;
        const auto& ring = face.rings.front();
        for (std::size_t i = 0; convex && i < ring.size(); ++i) {
            const auto& a = forms_.point<Integer>(ring[i]);
            const auto& b = forms_.point<Integer>(ring[(i + 1) % ring.size()]);
            const auto& c = forms_.point<Integer>(ring[(i + 2) % ring.size()]);
            convex = sgn(dot(plane.n, cross<Integer>(b - a, c - b))) >= 0;
        }
        is_convex_.push_back(convex);
    }
}

Sign VertexSight::height(VertexId w, FaceId f) const {
    const auto of = [&]<typename N>(const N&) {
        const PlaneOf<N>& plane = forms_.plane<N>(f);
        return N(dot(plane.n, forms_.point<N>(w)) - plane.k);
    };
    return policy_.sign(Predicate::line_form3, of(Real{}),
                        [&] { return sign_of_integer(of(Integer{})); });
}

const std::vector<EdgeId>& VertexSight::edges_from(VertexId v) {
    v_ = v;
    edges_.clear();
    for (std::uint32_t f = 0; f < side_of_face_.size(); ++f)
        side_of_face_[f] = height(v, FaceId{f});
    std::fill(is_asked_.begin(), is_asked_.end(), false);
    last_ = FaceId::none();
    const auto edges = forms_.scene().edges();
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const EdgeId e{i};
        if (is_turned_away(e) || leaves_into_own_body(e)) continue;
        const FaceId hides = hiding_face(edges[i].source);
        if (!hides.is_none() && surely_hides(hides, edges[i].target)) continue;
        const FaceId also = hiding_face(edges[i].target);
        if (!also.is_none() && surely_hides(also, edges[i].source)) continue;
        edges_.push_back(e);
    }
    return edges_;
}

/// Whether lines from the viewpoint reach the edge through the inside of its own body.
bool VertexSight::is_turned_away(EdgeId e) const {
    const Edge3& edge = forms_.scene()[e];
    const auto behind = [&](std::size_t i) {
        return side_of_face_[edge.faces[i].index()] == Sign::negative;
    };
    switch (forms_.shape(e)) {
        case EdgeShape::convex:
            return forms_.scene()[edge.body].kind == SurfaceKind::solid && behind(0) && behind(1);
        case EdgeShape::reflex:
            return forms_.scene()[edge.body].kind == SurfaceKind::solid && (behind(0) || behind(1));
        default:
            return false;
    }
}

/// Whether all lines from the viewpoint to the edge begin inside the viewpoint's body.
bool VertexSight::leaves_into_own_body(EdgeId e) const {
    const Edge3& edge = forms_.scene()[e];
    const auto behind = [&](FaceId f) {
        return height(edge.source, f) == Sign::negative && height(edge.target, f) == Sign::negative;
    };
    const auto& faces = forms_.faces_at(v_);
    if (forms_.shape(v_) == VertexShape::convex) return std::ranges::all_of(faces, behind);
    if (forms_.shape(v_) == VertexShape::reflex) return std::ranges::any_of(faces, behind);
    return false;
}

bool VertexSight::surely_crosses(std::uint32_t triangle, const PluckerOf<Real>& line,
                                 VertexId w) const {
    const FaceId f = forms_.scene().triangles()[triangle].face;
    const Sign here = side_of_face_[f.index()];
    if (here == Sign::zero) return false;
    std::optional<Sign> all;
    for (const TriangleSide& s : forms_.sides(triangle)) {
        auto sign = side(line, forms_.line<Real>(s.line)).sign();
        if (!sign || *sign == Sign::zero) return false;
        if (s.reversed) sign = -*sign;
        if (all && *all != *sign) return false;
        all = sign;
    }
    const PlaneOf<Real>& plane = forms_.plane<Real>(f);
    return (dot(plane.n, forms_.point<Real>(w)) - plane.k).sign() == -here;
}

bool VertexSight::surely_hides(FaceId f, VertexId w) const {
    const PluckerOf<Real> line = line_through(forms_.point<Real>(v_), forms_.point<Real>(w));
    return std::ranges::any_of(triangles_of_[f.index()],
                               [&](std::uint32_t t) { return surely_crosses(t, line, w); });
}

FaceId VertexSight::hiding_face(VertexId w) {
    if (is_asked_[w.index()]) return hidden_by_[w.index()];
    is_asked_[w.index()] = true;
    FaceId& result = hidden_by_[w.index()];
    result = FaceId::none();
    if (forms_.place(w) == forms_.place(v_)) return result;
    if (!last_.is_none() && surely_hides(last_, w)) return result = last_;
    const PluckerOf<Real> line = line_through(forms_.point<Real>(v_), forms_.point<Real>(w));
    const Box3 reach = Box3::of(forms_.scene()[v_], forms_.scene()[w]);
    const LineBoxTest meets(line);
    forms_.triangles().traverse([&](const Box3& box) { return reach.meets(box) && meets(box); },
                                [&](std::uint32_t t) {
                                    const FaceId f = forms_.scene().triangles()[t].face;
                                    if (!is_convex_[f.index()] || !surely_crosses(t, line, w))
                                        return true;
                                    result = f;
                                    return false;
                                });
    if (!result.is_none()) last_ = result;
    return result;
}

}  // namespace sightline::detail
