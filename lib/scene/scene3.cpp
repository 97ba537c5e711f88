// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/scene3.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/features3.hpp"

namespace sightline {
namespace {

using detail::Mesh3;

/// A body for each component, the world's components together.
std::vector<BodyId> make_bodies(const Mesh3& mesh, std::vector<Body3>& bodies) {
    std::vector<BodyId> of_component;
    BodyId world = BodyId::none();
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.component_of_face[f] < of_component.size()) continue;
        const BodyId next{static_cast<std::uint32_t>(bodies.size())};
        if (mesh.is_world(f)) {
            of_component.push_back(world.is_none() ? next : world);
            if (!world.is_none()) continue;
            world = next;
        } else {
            of_component.push_back(next);
        }
        const std::uint32_t m = mesh.mesh_of_face[f];
        bodies.push_back({mesh.input->meshes[m].kind, mesh.is_world(f), m});
    }
    return of_component;
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

    Scene3 scene;
    const std::vector<BodyId> of_component = make_bodies(mesh, scene.bodies_);
    Result<detail::Features3> features = detail::find_features(mesh, of_component);
    if (!features) return tl::unexpected(std::move(features.error()));
    for (std::uint32_t f = 0; f < features->faces.size(); ++f) {
        const auto triangles = detail::triangulate(mesh.vertices, features->faces[f]);
        if (triangles.empty()) {
            return fail(Errc::self_intersection,
                        fmt::format("{}: its boundary crosses itself; split or remove the face",
                                    mesh.name_of_face(features->faces[f].input_faces.front())));
        }
        for (const auto& corners : triangles) scene.triangles_.push_back({corners, FaceId{f}});
    }
    scene.vertices_ = std::move(mesh.vertices);
    scene.edges_ = std::move(features->edges);
    scene.faces_ = std::move(features->faces);
    scene.index_edges();
    scene.touching_ = scene.bodies_.size() > 1;
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
