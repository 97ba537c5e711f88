// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sightline/geom/polygon2.hpp"
#include "sightline/scene/id.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

/// A chain of walls: consecutive points are joined by segments of zero thickness.
struct Polyline2 {
    std::vector<Point2> points;

    friend bool operator==(const Polyline2&, const Polyline2&) = default;
};

using SceneElement2 = std::variant<Polygon2, Polyline2, Point2>;

/// What a reader delivers and `Scene2::make` validates: elements in file order, unchecked.
struct SceneInput2 {
    std::vector<SceneElement2> elements;
    /// The first polygon is the free world: its outside and its holes are solid.
    bool world = false;
    /// Named in error messages; may be empty.
    std::string file;
    /// Line of each element in the file, or empty when unknown.
    std::vector<std::uint32_t> lines;
};

enum class EdgeKind2 : std::uint8_t {
    body,   ///< boundary of a body: B lies on the left of source→target
    world,  ///< outer boundary of the world: B lies on the left of source→target
    wall,   ///< zero thickness, free on both sides
};

/// A directed edge. Body and world edges have the interior of B on their left.
struct Edge2 {
    VertexId source;
    VertexId target;
    BodyId body;  ///< none for world edges and walls
    EdgeKind2 kind = EdgeKind2::body;

    friend bool operator==(const Edge2&, const Edge2&) = default;
};

/// A closed chain of consecutive edges: edges first … first + count − 1.
struct RingRange2 {
    EdgeId first;
    std::uint32_t count = 0;
    BodyId body;           ///< none for the world's outer ring
    bool is_hole = false;  ///< a hole of a body (free inside)

    friend bool operator==(const RingRange2&, const RingRange2&) = default;
};

/// A valid 2D scene (semantics: docs/structures/scene.md): bodies (polygons with holes) with disjoint
/// interiors, walls, points, optionally one outer boundary. Immutable; whoever holds one holds a valid one.
///
/// Vertices are numbered in input order, rings keep their vertices and only change direction (B on the
/// left). Vertices at one place keep their own ids. Bodies are numbered in input order; with a world,
/// the holes of the first polygon are the first bodies.
/// Bodies may touch; rings may touch themselves and each other in points. Walls may cross each other.
class Scene2 {
public:
    /// Validates; on failure the error names file, line, element, ring and vertex.
    /// Cost O((n + touching pairs) log n).
    [[nodiscard]] static Result<Scene2> make(const SceneInput2& input);

    [[nodiscard]] std::span<const Point2> vertices() const noexcept { return vertices_; }
    [[nodiscard]] std::span<const Edge2> edges() const noexcept { return edges_; }
    [[nodiscard]] std::span<const RingRange2> rings() const noexcept { return rings_; }
    /// Vertices of POINT elements and of with_points.
    [[nodiscard]] std::span<const VertexId> points() const noexcept { return points_; }

    [[nodiscard]] const Point2& operator[](VertexId v) const { return vertices_[v.index()]; }
    [[nodiscard]] const Edge2& operator[](EdgeId e) const { return edges_[e.index()]; }

    [[nodiscard]] std::size_t vertex_count() const noexcept { return vertices_.size(); }
    [[nodiscard]] std::size_t edge_count() const noexcept { return edges_.size(); }
    [[nodiscard]] std::size_t body_count() const noexcept { return body_count_; }
    [[nodiscard]] bool has_world() const noexcept { return has_world_; }

    /// The same scene with more point vertices, numbered after the existing ones.
    /// Fails with inside_body (or outside_of_world) when a point lies in the interior of B.
    [[nodiscard]] Result<Scene2> with_points(std::span<const Point2> added) const;

    friend bool operator==(const Scene2&, const Scene2&) = default;

private:
    std::vector<Point2> vertices_;
    std::vector<Edge2> edges_;
    std::vector<RingRange2> rings_;
    std::vector<VertexId> points_;
    std::size_t body_count_ = 0;
    bool has_world_ = false;
};

}  // namespace sightline
