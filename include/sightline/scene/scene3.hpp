// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sightline/geom/point.hpp"
#include "sightline/scene/id.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

enum class SurfaceKind : std::uint8_t {
    solid,  ///< closed oriented surfaces: each component bounds a body
    sheet,  ///< surfaces of zero thickness, free on both sides
};

/// One file's polygons as a reader delivers them, unchecked: faces are cycles of indices into `vertices`,
/// counter-clockwise seen from outside.
struct MeshInput3 {
    std::vector<Point3> vertices;
    std::vector<std::vector<std::uint32_t>> faces;
    SurfaceKind kind = SurfaceKind::solid;
    /// Named in error messages; may be empty.
    std::string file;
    /// Line of each vertex and face in the file, or empty when unknown.
    std::vector<std::uint32_t> vertex_lines;
    std::vector<std::uint32_t> face_lines;
};

/// What `Scene3::make` validates. Vertices and faces are numbered through all meshes, in this order.
struct SceneInput3 {
    std::vector<MeshInput3> meshes;
    /// The first mesh bounds the free world: everything outside its closed inside is solid.
    bool world = false;
};

/// A feature edge: maximal straight piece between two feature vertices where a body's (or sheet's) surface
/// bends, ends, or is folded. source < target.
struct Edge3 {
    VertexId source;
    VertexId target;
    BodyId body;
    /// The face on the left of source→target, seen from outside, and the face on its right. A sheet's border
    /// has one face, in the place where it is, and none() in the other. Where more than two faces of a
    /// sheet meet, each pair of neighbours round the edge has an edge of its own.
    std::array<FaceId, 2> faces;

    friend bool operator==(const Edge3&, const Edge3&) = default;
};

/// A face: a maximal connected set of coplanar adjacent input faces of one body.
struct Face3 {
    BodyId body;
    /// Three vertices that are not collinear; counter-clockwise seen from outside (from the front, for sheets).
    std::array<VertexId, 3> plane;
    /// Feature vertices of the outer ring, counter-clockwise seen from outside, then of the holes, clockwise.
    /// Holes follow their outer ring; a face whose interior is connected has one outer ring.
    std::vector<std::vector<VertexId>> rings;
    /// Ids, in input order, of the input faces that were merged, ascending.
    std::vector<std::uint32_t> input_faces;

    friend bool operator==(const Face3&, const Face3&) = default;
};

/// A piece of a face; counter-clockwise seen from outside. The triangles of a face cover it without overlap
/// and have only its feature vertices as corners.
struct Triangle3 {
    std::array<VertexId, 3> corners;
    FaceId face;

    friend bool operator==(const Triangle3&, const Triangle3&) = default;
};

/// A component of a solid, a sheet's component, or the world.
struct Body3 {
    SurfaceKind kind = SurfaceKind::solid;
    bool is_world = false;
    std::uint32_t mesh = 0;  ///< index of the mesh it comes from

    friend bool operator==(const Body3&, const Body3&) = default;
};

/// A valid 3D scene (semantics: docs/structures/scene.md): solids with disjoint interiors and sheets, as
/// features. Immutable; whoever holds one holds a valid one.
///
/// Vertices keep their input numbers; those that are no feature (docs/structures/scene.md) keep their number
/// but no edge or ring mentions them. Feature edges are numbered in the order of (source, target), faces in the
/// order of their least input face. The world's faces are turned: outside, for them, is the free side.
/// Bodies may touch: share a vertex, a piece of an edge, a piece of a face. Coplanar faces of touching bodies
/// remain distinct. Sheets may touch bodies; sheets that cross each other must be split there.
class Scene3 {
public:
    /// Validates; on failure the error names file, line and element, and says what would mend it.
    /// Cost O((n + pairs of touching boxes) log n).
    [[nodiscard]] static Result<Scene3> make(const SceneInput3& input);

    [[nodiscard]] std::span<const Point3> vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::span<const Edge3> edges() const noexcept { return edges_; }
    [[nodiscard]] std::span<const Face3> faces() const noexcept { return faces_; }
    [[nodiscard]] std::span<const Triangle3> triangles() const noexcept { return triangles_; }
    [[nodiscard]] std::span<const Body3> bodies() const noexcept { return bodies_; }

    [[nodiscard]] const Point3& operator[](VertexId v) const { return vertices_[v.index()]; }
    [[nodiscard]] const Edge3& operator[](EdgeId e) const { return edges_[e.index()]; }
    [[nodiscard]] const Face3& operator[](FaceId f) const { return faces_[f.index()]; }
    [[nodiscard]] const Body3& operator[](BodyId b) const { return bodies_[b.index()]; }

    /// The feature edges that end at v, ascending; empty when v is no feature.
    [[nodiscard]] std::span<const EdgeId> edges_at(VertexId v) const {
        return {vertex_edges_.data() + first_edge_[v.index()],
                vertex_edges_.data() + first_edge_[v.index() + 1]};
    }
    [[nodiscard]] bool is_feature(VertexId v) const { return !edges_at(v).empty(); }

    /// For a pair of bodies (or one body twice) that share a point: sealing can only happen there.
    [[nodiscard]] bool has_touching_bodies() const noexcept { return touching_; }

    friend bool operator==(const Scene3&, const Scene3&) = default;

private:
    void index_edges();

    std::vector<Point3> vertices_;
    std::vector<Edge3> edges_;
    std::vector<Face3> faces_;
    std::vector<Triangle3> triangles_;
    std::vector<Body3> bodies_;
    std::vector<std::uint32_t> first_edge_;
    std::vector<EdgeId> vertex_edges_;
    bool touching_ = false;
};

}  // namespace sightline
