// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial/scene_forms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "sightline/spatial/scene_boxes.hpp"

namespace sightline::detail {

namespace {

/// The exponent of the least significant bit of x ≠ 0.
int last_bit(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    auto bits = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
    exponent -= 53;
    while ((bits & 1) == 0) {
        bits >>= 1;
        ++exponent;
    }
    return exponent;
}

Integer scaled(double x, int exponent) {
    if (x == 0) return 0;
    int power = 0;
    const double mantissa = std::frexp(x, &power);
    Integer result(std::ldexp(mantissa, 53));
    const int shift = power - 53 + exponent;
    if (shift >= 0) {
        mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    } else {
        mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
    }
    return result;
}

}  // namespace

SceneForms::SceneForms(const Scene3& scene) : scene_(&scene) {
    find_points();
    find_lines();
    find_planes();
    find_shapes();
    find_places();
    find_boxes();
    find_contacts();
}

void SceneForms::find_points() {
    int least = std::numeric_limits<int>::max();
    for (const Point3& p : scene_->vertices()) {
        for (const double x : {p.x, p.y, p.z}) {
            if (x != 0) least = std::min(least, last_bit(x));
        }
    }
    scale_exponent_ = least == std::numeric_limits<int>::max() ? 0 : -least;
    for (const Point3& p : scene_->vertices()) {
        real_points_.push_back({Real(p.x), Real(p.y), Real(p.z)});
        exact_points_.push_back({scaled(p.x, scale_exponent_), scaled(p.y, scale_exponent_),
                                 scaled(p.z, scale_exponent_)});
    }
}

void SceneForms::find_lines() {
    std::map<std::pair<VertexId, VertexId>, std::uint32_t> known;
    const auto add = [&](VertexId a, VertexId b) {
        real_lines_.push_back(line_through(point<Real>(a), point<Real>(b)));
        exact_lines_.push_back(line_through(point<Integer>(a), point<Integer>(b)));
        // Edges with the same ends (folds, touching surfaces) have ids of their own; a triangle's
        // side finds the one of its own faces below.
    };
    for (const Edge3& e : scene_->edges()) add(e.source, e.target);
    std::map<std::tuple<VertexId, VertexId, FaceId>, std::uint32_t> edge_of;
    for (std::uint32_t e = 0; e < scene_->edges().size(); ++e) {
        const Edge3& edge = scene_->edges()[e];
        for (const FaceId f : edge.faces) {
            if (!f.is_none()) edge_of.insert({{edge.source, edge.target, f}, e});
        }
    }
    for (const Triangle3& t : scene_->triangles()) {
        std::array<TriangleSide, 3> sides;
        for (std::size_t i = 0; i < 3; ++i) {
            VertexId a = t.corners[i];
            VertexId b = t.corners[(i + 1) % 3];
            sides[i].reversed = b < a;
            if (b < a) std::swap(a, b);
            if (const auto edge = edge_of.find({a, b, t.face}); edge != edge_of.end()) {
                sides[i].line = edge->second;
                continue;
            }
            const auto next = static_cast<std::uint32_t>(real_lines_.size());
            const auto [diagonal, is_new] = known.insert({{a, b}, next});
            if (is_new) add(a, b);
            sides[i].line = diagonal->second;
        }
        sides_.push_back(sides);
    }
}

void SceneForms::find_planes() {
    for (const Face3& f : scene_->faces()) {
        const auto& [a, b, c] = f.plane;
        real_planes_.push_back(plane_through(point<Real>(a), point<Real>(b), point<Real>(c)));
        exact_planes_.push_back(
            plane_through(point<Integer>(a), point<Integer>(b), point<Integer>(c)));
    }
}

void SceneForms::find_shapes() {
    faces_at_.resize(scene_->vertices().size());
    vertex_shapes_.assign(scene_->vertices().size(), VertexShape::none);
    for (std::uint32_t f = 0; f < scene_->faces().size(); ++f) {
        for (const auto& ring : scene_->faces()[f].rings) {
            for (const VertexId v : ring) {
                auto& faces = faces_at_[v.index()];
                if (std::ranges::find(faces, FaceId{f}) == faces.end()) faces.push_back(FaceId{f});
            }
        }
    }
    face_edges_.resize(scene_->faces().size());
    body_edges_.resize(scene_->bodies().size());
    for (std::uint32_t e = 0; e < scene_->edges().size(); ++e) {
        const Edge3& edge = scene_->edges()[e];
        body_edges_[edge.body.index()].push_back(EdgeId{e});
        for (const FaceId f : edge.faces) {
            if (!f.is_none()) face_edges_[f.index()].push_back(EdgeId{e});
        }
    }
    for (const Edge3& e : scene_->edges()) {
        const bool is_sheet = (*scene_)[e.body].kind == SurfaceKind::sheet;
        EdgeShape shape = EdgeShape::border;
        if (!e.faces[0].is_none() && !e.faces[1].is_none()) {
            const Vec3<Integer> along = point<Integer>(e.target) - point<Integer>(e.source);
            // The left face lies on the side n₀ × along of the edge.
            const Vec3<Integer> into = cross(plane<Integer>(e.faces[0]).n, along);
            const Integer turn = dot(plane<Integer>(e.faces[1]).n, into);
            shape = sgn(turn) < 0   ? EdgeShape::convex
                    : sgn(turn) > 0 ? EdgeShape::reflex
                                    : EdgeShape::fold;
        }
        edge_shapes_.push_back(shape);
        for (const VertexId v : {e.source, e.target}) {
            VertexShape& at = vertex_shapes_[v.index()];
            const auto here = is_sheet                     ? VertexShape::sheet
                              : shape == EdgeShape::convex ? VertexShape::convex
                              : shape == EdgeShape::reflex ? VertexShape::reflex
                                                           : VertexShape::mixed;
            at = at == VertexShape::none || at == here ? here : VertexShape::mixed;
        }
    }
}

void SceneForms::find_places() {
    std::map<Point3, VertexId> first;
    for (std::uint32_t v = 0; v < scene_->vertices().size(); ++v) {
        const VertexId id{v};
        if (!scene_->is_feature(id)) {
            places_.push_back(id);
            continue;
        }
        const VertexId place = first.insert({(*scene_)[id], id}).first->second;
        places_.push_back(place);
        if (place == id) continue;
        auto& shared = shared_places_[place];
        if (shared.empty()) shared.push_back(place);
        shared.push_back(id);
    }
}

void SceneForms::find_boxes() {
    triangles_ = Bvh(triangle_boxes(*scene_));
    edges_ = Bvh(edge_boxes(*scene_));
}

}  // namespace sightline::detail
