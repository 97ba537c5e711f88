// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bodies of a scene touch: edges that cross, vertices on edges, faces on faces.
#include <algorithm>

#include "spatial/scene_forms.hpp"

namespace sightline::detail {

namespace {

bool is_zero(const Vec3<Integer>& x) { return sgn(x[0]) == 0 && sgn(x[1]) == 0 && sgn(x[2]) == 0; }

/// Whether each of two edges has its ends on both sides of the other, in the plane of both.
bool cross_inside(const SceneForms& forms, EdgeId a, EdgeId b) {
    if (sgn(side(forms.line<Integer>(a.index()), forms.line<Integer>(b.index()))) != 0)
        return false;
    const auto separates = [&](EdgeId by, EdgeId ends) {
        const PluckerOf<Integer>& line = forms.line<Integer>(by.index());
        const Edge3& edge = forms.scene()[ends];
        return sgn(dot(normal_from(line, forms.point<Integer>(edge.source)),
                       normal_from(line, forms.point<Integer>(edge.target)))) < 0;
    };
    return separates(a, b) && separates(b, a);
}

/// Whether v lies between the ends of e.
bool is_inside(const SceneForms& forms, VertexId v, EdgeId e) {
    const Vec3<Integer>& p = forms.point<Integer>(v);
    if (!is_zero(normal_from(forms.line<Integer>(e.index()), p))) return false;
    const Edge3& edge = forms.scene()[e];
    return sgn(dot(p - forms.point<Integer>(edge.source), p - forms.point<Integer>(edge.target))) <
           0;
}

Box3 box_of(const Scene3& scene, const Edge3& e) {
    return Box3::of(scene.vertices()[e.source.index()], scene.vertices()[e.target.index()]);
}

}  // namespace

bool SceneForms::are_coplanar(FaceId f, FaceId g) const {
    const PluckerOf<Integer> meet = line_of(plane<Integer>(f), plane<Integer>(g));
    return is_zero(meet.d) && is_zero(meet.m);
}

bool SceneForms::are_parallel(EdgeId a, EdgeId b) const {
    return is_zero(cross(line<Integer>(a.index()).d, line<Integer>(b.index()).d));
}

void SceneForms::find_contacts() {
    if (!scene_->has_touching_bodies()) return;
    find_edge_contacts();
    find_face_contacts();
}

void SceneForms::find_edge_contacts() {
    crossing_edges_.resize(edge_count());
    edges_through_.resize(scene_->vertices().size());
    vertices_inside_.resize(edge_count());
    for (std::uint32_t i = 0; i < edge_count(); ++i) {
        const Edge3& edge = scene_->edges()[i];
        const Box3 box = box_of(*scene_, edge);
        const auto check = [&](std::uint32_t other) {
            if (scene_->edges()[other].body == edge.body) return;
            for (const VertexId v : {edge.source, edge.target}) {
                if (!is_inside(*this, v, EdgeId{other})) continue;
                auto& through = edges_through_[v.index()];
                if (std::ranges::find(through, EdgeId{other}) != through.end()) continue;
                through.push_back(EdgeId{other});
                vertices_inside_[other].push_back(v);
            }
            if (!cross_inside(*this, EdgeId{i}, EdgeId{other})) return;
            crossing_edges_[i].push_back(EdgeId{other});
            if (other < i) crossings_.emplace_back(EdgeId{other}, EdgeId{i});
        };
        edges_.traverse([&](const Box3& other) { return box.meets(other); }, check);
    }
    std::ranges::sort(crossings_);
}

void SceneForms::find_face_contacts() {
    const auto triangles = scene_->triangles();
    const auto is_solid = [&](FaceId f) {
        return (*scene_)[(*scene_)[f].body].kind == SurfaceKind::solid;
    };
    const auto are_pressed = [&](FaceId f, FaceId g) {
        if ((*scene_)[f].body == (*scene_)[g].body || !is_solid(f) || !is_solid(g)) return false;
        return sgn(dot(plane<Integer>(f).n, plane<Integer>(g).n)) < 0 && are_coplanar(f, g);
    };
    const auto add = [&](FaceId f, FaceId g) {
        auto known = std::ranges::find_if(
            contact_planes_, [&](const ContactPlane& p) { return are_coplanar(p.faces[0], f); });
        if (known == contact_planes_.end()) {
            contact_planes_.emplace_back();
            known = contact_planes_.end() - 1;
        }
        for (const FaceId x : {f, g}) {
            if (std::ranges::find(known->faces, x) == known->faces.end()) known->faces.push_back(x);
        }
    };
    for (const Triangle3& t : triangles) {
        const Box3 box =
            Box3::of((*scene_)[t.corners[0]], (*scene_)[t.corners[1]], (*scene_)[t.corners[2]]);
        triangles_.traverse([&](const Box3& other) { return box.meets(other); },
                            [&](std::uint32_t other) {
                                const FaceId g = triangles[other].face;
                                if (g < t.face && are_pressed(t.face, g)) add(t.face, g);
                            });
    }
    for (ContactPlane& plane : contact_planes_) {
        for (const FaceId f : plane.faces) {
            for (const EdgeId e : edges_of(f)) plane.edges.push_back(e);
        }
        std::ranges::sort(plane.edges);
        const auto repeated = std::ranges::unique(plane.edges);
        plane.edges.erase(repeated.begin(), repeated.end());
    }
}

}  // namespace sightline::detail
