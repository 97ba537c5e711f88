// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/scene3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/features3.hpp"
#include "scene/validate3.hpp"

namespace sightline {
namespace {

using detail::Mesh3;

/// A body for each component that bounds no cavity; the world's components are one.
std::vector<BodyId> make_bodies(const Mesh3& mesh, const std::vector<std::uint32_t>& owner,
                                std::vector<Body3>& bodies) {
    std::vector<std::uint32_t> first_face(mesh.component_count, detail::no_index);
    for (std::uint32_t f = mesh.face_count(); f-- > 0;) first_face[mesh.component_of_face[f]] = f;
    std::vector<BodyId> of_component(mesh.component_count);
    BodyId world;
    for (std::uint32_t c = 0; c < mesh.component_count; ++c) {
        const bool is_world = mesh.is_world(first_face[c]);
        if (owner[c] != c) continue;
        if (is_world && !world.is_none()) {
            of_component[c] = world;
            continue;
        }
        of_component[c] = BodyId{static_cast<std::uint32_t>(bodies.size())};
        if (is_world) world = of_component[c];
        const std::uint32_t m = mesh.mesh_of_face[first_face[c]];
        bodies.push_back({mesh.input->meshes[m].kind, is_world, m});
    }
    for (std::uint32_t c = 0; c < mesh.component_count; ++c)
        if (owner[c] != c) of_component[c] = of_component[owner[c]];
    return of_component;
}

/// Whether an input face's boundary crosses itself. Quadrangles are mostly convex, which is quickly seen.
bool crosses_itself(const Mesh3& mesh, std::uint32_t face) {
    const std::uint32_t first = mesh.first_half[face];
    const std::uint32_t n = mesh.first_half[face + 1] - first;
    if (n == 3) return false;
    const auto corner = [&](std::uint32_t i) { return mesh.halves[first + i % n].source; };
    const auto at = [&](std::uint32_t i) -> const Point3& { return mesh.vertices[corner(i)]; };
    std::uint32_t left_turns = 0;
    std::uint32_t least = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (mesh.planes[face].turn(at(i), at(i + 1), at(i + 2)) == Sign::positive) ++left_turns;
        if (at(i) < at(least)) least = i;
    }
    if (n == 4 && left_turns == 4) return false;
    Face3 outline;
    outline.plane = {VertexId{corner(least + n - 1)}, VertexId{corner(least)},
                     VertexId{corner(least + 1)}};
    auto& ring = outline.rings.emplace_back();
    for (std::uint32_t i = 0; i < n; ++i) ring.push_back(VertexId{corner(i)});
    return detail::triangulate(mesh.vertices, outline).empty();
}

Result<void> check_merged(const Mesh3& mesh, const Face3& face) {
    if (face.input_faces.size() == 1) return {};  // its rings are looked at
    for (const std::uint32_t f : face.input_faces) {
        if (!crosses_itself(mesh, f)) continue;
        return fail(
            Errc::self_intersection,
            mesh.name_of_face(f) + ": its boundary crosses itself; split or remove the face");
    }
    return {};
}

Result<std::vector<Triangle3>> triangulate_all(const Mesh3& mesh, const std::vector<Face3>& faces) {
    std::vector<Triangle3> all;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (auto ok = check_merged(mesh, faces[f]); !ok)
            return tl::unexpected(std::move(ok.error()));
        const auto triangles = detail::triangulate(mesh.vertices, faces[f]);
        if (triangles.empty()) {
            return fail(Errc::self_intersection,
                        fmt::format("{}: its boundary crosses itself; split or remove the face",
                                    mesh.name_of_face(faces[f].input_faces.front())));
        }
        for (const auto& corners : triangles) all.push_back({corners, FaceId{f}});
    }
    return all;
}

/// Numbers the edges in the order that Scene3 promises.
void sort_edges(std::vector<Edge3>& edges) {
    std::sort(edges.begin(), edges.end(), [](const Edge3& a, const Edge3& b) {
        return std::tie(a.source, a.target, a.body, a.faces) <
               std::tie(b.source, b.target, b.body, b.faces);
    });
}

}  // namespace

Result<Scene3> Scene3::make(const SceneInput3& input) {
    Result<Mesh3> laid_out = detail::lay_out(input);
    if (!laid_out) return tl::unexpected(std::move(laid_out.error()));
    Mesh3& mesh = *laid_out;
    if (input.world && input.meshes.front().kind == SurfaceKind::sheet) {
        return fail(Errc::bad_parameter,
                    "the first mesh bounds the world, so it cannot be a sheet; read it as a solid");
    }
    if (auto ok = detail::pair_edges(mesh); !ok) return tl::unexpected(std::move(ok.error()));
    if (auto ok = detail::check_places(mesh); !ok) return tl::unexpected(std::move(ok.error()));
    if (auto ok = detail::orient_sheets(mesh); !ok) return tl::unexpected(std::move(ok.error()));

    std::vector<BodyId> components;
    for (std::uint32_t c = 0; c < mesh.component_count; ++c) components.push_back(BodyId{c});
    Result<detail::Features3> features = detail::find_features(mesh, components);
    if (!features) return tl::unexpected(std::move(features.error()));
    Result<std::vector<Triangle3>> triangles = triangulate_all(mesh, features->faces);
    if (!triangles) return tl::unexpected(std::move(triangles.error()));
    const Result<detail::Nesting3> nesting = detail::validate(mesh, *features, *triangles);
    if (!nesting) return tl::unexpected(nesting.error());

    Scene3 scene;
    const std::vector<BodyId> body = make_bodies(mesh, nesting->owner, scene.bodies_);
    for (Edge3& edge : features->edges) edge.body = body[edge.body.index()];
    for (Face3& face : features->faces) face.body = body[face.body.index()];
    sort_edges(features->edges);
    scene.triangles_ = std::move(*triangles);
    scene.vertices_ = std::move(mesh.vertices);
    scene.edges_ = std::move(features->edges);
    scene.faces_ = std::move(features->faces);
    scene.index_edges();
    scene.touching_ = nesting->touching;
    return scene;
}

void Scene3::index_edges() {
    first_edge_.assign(vertices_.size() + 1, 0);
    for (const Edge3& edge : edges_) {
        ++first_edge_[edge.source.index() + 1];
        ++first_edge_[edge.target.index() + 1];
    }
    for (std::size_t v = 0; v < vertices_.size(); ++v) first_edge_[v + 1] += first_edge_[v];
    std::vector<std::uint32_t> next(first_edge_.begin(), first_edge_.end() - 1);
    vertex_edges_.resize(2 * edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        vertex_edges_[next[edges_[e].source.index()]++] = EdgeId{e};
        vertex_edges_[next[edges_[e].target.index()]++] = EdgeId{e};
    }
}

}  // namespace sightline
