// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The surfaces of a 3D scene as half-edges, checked element by element. Private.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "scene/exact3.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::detail {

inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// A side of an input face, in the direction that has the face on its left seen from outside.
struct HalfEdge3 {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
    std::uint32_t face = 0;
    std::uint32_t next = 0;
};

/// Two half-edges that follow each other round an edge: the sector between them is inside of a solid, or lies
/// between neighbouring faces of a sheet. `right` is none for the border of a sheet.
struct EdgePair3 {
    std::uint32_t left = no_index;
    std::uint32_t right = no_index;
    bool flat = false;        ///< coplanar, on opposite sides of the edge
    bool same_sense = false;  ///< both run in one direction: a sheet without a common front
};

/// The input with numbers through all meshes; the world's faces are turned.
struct Mesh3 {
    const SceneInput3* input = nullptr;
    std::vector<Point3> vertices;
    std::vector<std::uint32_t> first_vertex;  ///< a mesh, and the end
    std::vector<std::uint32_t> first_face;    ///< a mesh, and the end
    std::vector<std::uint32_t> mesh_of_face;
    std::vector<HalfEdge3> halves;
    std::vector<std::uint32_t> first_half;  ///< a face, and the end
    std::vector<Plane3> planes;             ///< a face
    std::vector<EdgePair3> pairs;
    std::vector<std::uint32_t> component_of_face;  ///< joined along edges; numbered by least face
    std::uint32_t component_count = 0;

    [[nodiscard]] std::uint32_t face_count() const {
        return static_cast<std::uint32_t>(mesh_of_face.size());
    }
    [[nodiscard]] std::uint32_t mesh_of_vertex(std::uint32_t v) const;
    [[nodiscard]] bool is_sheet(std::uint32_t face) const {
        return input->meshes[mesh_of_face[face]].kind == SurfaceKind::sheet;
    }
    [[nodiscard]] bool is_world(std::uint32_t face) const {
        return input->world && mesh_of_face[face] == 0;
    }
    /// For messages: "a.off:12: face 3", numbers as in the file.
    [[nodiscard]] std::string name_of_face(std::uint32_t face) const;
    /// "a.off:12: vertex 3 (0, 0, 1)".
    [[nodiscard]] std::string name_of_vertex(std::uint32_t v) const;
    /// The same without file and line, for the rest of a message.
    [[nodiscard]] std::string short_name_of_face(std::uint32_t face) const;
    [[nodiscard]] std::string short_name_of_vertex(std::uint32_t v) const;
    [[nodiscard]] std::string short_name_of_edge(std::uint32_t half) const;
};

/// Numbers the input and checks coordinates, indices, and that each face is a planar polygon of some area.
[[nodiscard]] Result<Mesh3> lay_out(const SceneInput3& input);

/// Fills in pairs and components; checks that solids are closed and oriented.
[[nodiscard]] Result<void> pair_edges(Mesh3& mesh);

/// Refuses two vertices of one component at one place.
[[nodiscard]] Result<void> check_places(const Mesh3& mesh);

}  // namespace sightline::detail
