// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the predicates need of a scene, computed once: points, lines of edges and triangle sides,
/// planes of faces, each for the filter and as integers, and the shape of the solids round edges and
/// vertices. Private.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/bvh.hpp"
#include "spatial/plucker_forms.hpp"

namespace sightline::detail {

/// How two faces meet at an edge, seen from outside.
enum class EdgeShape : std::uint8_t {
    convex,  ///< the solid is the common inside of both faces' half spaces
    reflex,  ///< the solid is the union of both half spaces
    fold,    ///< of a sheet: the two faces lie on each other
    border   ///< of a sheet: one face only
};

enum class VertexShape : std::uint8_t { none, convex, reflex, mixed, sheet };

/// A side of a triangle as a line of SceneForms, and whether it runs the other way.
struct TriangleSide {
    std::uint32_t line = 0;
    bool reversed = false;
};

class SceneForms {
public:
    explicit SceneForms(const Scene3& scene);

    [[nodiscard]] const Scene3& scene() const { return *scene_; }
    [[nodiscard]] std::size_t edge_count() const { return scene_->edges().size(); }

    /// Lines: first those of the feature edges, by id, then those of diagonals of faces.
    template <typename N>
    [[nodiscard]] const PluckerOf<N>& line(std::size_t i) const {
        if constexpr (std::is_same_v<N, Real>) {
            return real_lines_[i];
        } else {
            return exact_lines_[i];
        }
    }
    template <typename N>
    [[nodiscard]] const Vec3<N>& point(VertexId v) const {
        if constexpr (std::is_same_v<N, Real>) {
            return real_points_[v.index()];
        } else {
            return exact_points_[v.index()];
        }
    }
    template <typename N>
    [[nodiscard]] const PlaneOf<N>& plane(FaceId f) const {
        if constexpr (std::is_same_v<N, Real>) {
            return real_planes_[f.index()];
        } else {
            return exact_planes_[f.index()];
        }
    }
    [[nodiscard]] std::size_t line_count() const { return real_lines_.size(); }
    [[nodiscard]] const std::array<TriangleSide, 3>& sides(std::uint32_t triangle) const {
        return sides_[triangle];
    }
    [[nodiscard]] EdgeShape shape(EdgeId e) const { return edge_shapes_[e.index()]; }
    [[nodiscard]] VertexShape shape(VertexId v) const { return vertex_shapes_[v.index()]; }
    /// The faces that have v on their boundary.
    [[nodiscard]] const std::vector<FaceId>& faces_at(VertexId v) const {
        return faces_at_[v.index()];
    }
    /// The feature edges on the boundary of a face; those of a body.
    [[nodiscard]] const std::vector<EdgeId>& edges_of(FaceId f) const {
        return face_edges_[f.index()];
    }
    [[nodiscard]] const std::vector<EdgeId>& edges_of(BodyId b) const {
        return body_edges_[b.index()];
    }
    /// The body v belongs to; none when v is no feature.
    [[nodiscard]] BodyId body_of(VertexId v) const {
        const auto edges = scene_->edges_at(v);
        return edges.empty() ? BodyId::none() : (*scene_)[edges.front()].body;
    }
    /// A vertex's id stands for all feature vertices at its place: the least of them.
    [[nodiscard]] VertexId place(VertexId v) const { return places_[v.index()]; }
    /// The feature vertices at a place, when there are several; else empty.
    [[nodiscard]] std::span<const VertexId> vertices_at(VertexId place) const {
        const auto found = shared_places_.find(place);
        if (found == shared_places_.end()) return {};
        return found->second;
    }
    /// Pairs of edges of touching bodies that cross in a point inside both, ascending.
    [[nodiscard]] std::span<const std::pair<EdgeId, EdgeId>> crossings() const {
        return crossings_;
    }
    /// The edges that cross e inside both.
    [[nodiscard]] std::span<const EdgeId> crossing_edges(EdgeId e) const {
        if (crossing_edges_.empty()) return {};
        return crossing_edges_[e.index()];
    }
    /// The edges of other bodies that have v between their ends.
    [[nodiscard]] std::span<const EdgeId> edges_through(VertexId v) const {
        if (edges_through_.empty()) return {};
        return edges_through_[v.index()];
    }
    /// The vertices of other bodies between the ends of e.
    [[nodiscard]] std::span<const VertexId> vertices_inside(EdgeId e) const {
        if (vertices_inside_.empty()) return {};
        return vertices_inside_[e.index()];
    }
    /// Planes in which faces of two solids may be pressed on each other; with these faces and their edges.
    struct ContactPlane {
        std::vector<FaceId> faces;
        std::vector<EdgeId> edges;
    };
    [[nodiscard]] std::span<const ContactPlane> contact_planes() const { return contact_planes_; }
    [[nodiscard]] bool are_coplanar(FaceId f, FaceId g) const;
    [[nodiscard]] bool are_parallel(EdgeId a, EdgeId b) const;
    [[nodiscard]] const Bvh& triangles() const { return triangles_; }
    [[nodiscard]] const Bvh& edges() const { return edges_; }
    /// Exact coordinates are the input's times 2^scale_exponent.
    [[nodiscard]] int scale_exponent() const { return scale_exponent_; }

private:
    void find_points();
    void find_lines();
    void find_planes();
    void find_shapes();
    void find_places();
    void find_boxes();
    void find_contacts();
    void find_edge_contacts();
    void find_face_contacts();

    const Scene3* scene_;
    int scale_exponent_ = 0;
    std::vector<Vec3<Real>> real_points_;
    std::vector<Vec3<Integer>> exact_points_;
    std::vector<PluckerOf<Real>> real_lines_;
    std::vector<PluckerOf<Integer>> exact_lines_;
    std::vector<PlaneOf<Real>> real_planes_;
    std::vector<PlaneOf<Integer>> exact_planes_;
    std::vector<std::array<TriangleSide, 3>> sides_;
    std::vector<EdgeShape> edge_shapes_;
    std::vector<VertexShape> vertex_shapes_;
    std::vector<std::vector<FaceId>> faces_at_;
    std::vector<std::vector<EdgeId>> face_edges_;
    std::vector<std::vector<EdgeId>> body_edges_;
    std::vector<VertexId> places_;
    std::map<VertexId, std::vector<VertexId>> shared_places_;
    std::vector<std::pair<EdgeId, EdgeId>> crossings_;
    std::vector<std::vector<EdgeId>> crossing_edges_, edges_through_;  // empty when nothing touches
    std::vector<std::vector<VertexId>> vertices_inside_;
    std::vector<ContactPlane> contact_planes_;
    Bvh triangles_;
    Bvh edges_;
};

}  // namespace sightline::detail
