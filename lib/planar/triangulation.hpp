// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sightline/arith/sign.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/scene/scene2.hpp"

/// The constrained triangulation under every planar structure. Private to lib/planar.
namespace sightline::detail {

/// A location of the triangulation: one of the frame, a place where scene vertices lie, or a
/// constructed point (two walls cross there, or a query point that is no double).
using Place = std::uint32_t;
/// Half-edge 4 t + i is the edge from corner i to corner i + 1 (mod 3) of triangle t, t on its left.
using HalfEdge = std::uint32_t;

inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();
inline constexpr Place frame_places = 6;

[[nodiscard]] constexpr HalfEdge next(HalfEdge h) noexcept {
    return (h & 3U) == 2U ? h - 2 : h + 1;
}
[[nodiscard]] constexpr HalfEdge prev(HalfEdge h) noexcept {
    return (h & 3U) == 0U ? h + 2 : h - 1;
}

/// A constrained triangulation of a scene inside a frame that surrounds it: exact in all that matters
/// (orientation), nearly Delaunay for speed (the in-circle test is a certified filter: it may leave an
/// edge unflipped, never flips one wrongly, so flipping ends).
///
/// Places: 0…3 the frame's corners, 4 and 5 on its lower and upper side, then the scene's places along a space-filling curve, then constructed ones.
/// Every triangle is free or part of B; an edge can be crossed when it is no wall and both its triangles
/// are free.
class Triangulation {
public:
    explicit Triangulation(const Scene2& scene) : Triangulation(scene, {}) {}
    /// With a frame that also surrounds the points of `within`.
    Triangulation(const Scene2& scene, std::span<const Point2> within, unsigned threads = 1);

    // --- places
    [[nodiscard]] std::size_t place_count() const noexcept { return position_.size(); }
    /// The first constructed place; scene places are frame_places … first_constructed() − 1.
    [[nodiscard]] Place first_constructed() const noexcept { return first_constructed_; }
    [[nodiscard]] bool has_constructed() const noexcept {
        return first_constructed_ < position_.size();
    }
    [[nodiscard]] bool is_scene_place(Place p) const noexcept {
        return p >= frame_places && p < first_constructed_;
    }
    /// Coordinates; rounded for constructed places.
    [[nodiscard]] const Point2& position(Place p) const noexcept { return position_[p]; }
    [[nodiscard]] RationalPoint2 exact_position(Place p) const;
    [[nodiscard]] Place place_of(VertexId v) const noexcept { return place_of_[v.index()]; }
    [[nodiscard]] std::size_t vertex_count() const noexcept { return place_of_.size(); }
    /// The scene vertices at a scene place, ascending.
    [[nodiscard]] std::span<const VertexId> vertices_at(Place p) const noexcept {
        const std::size_t i = p - frame_places;
        return {vertices_at_.data() + first_vertex_[i], vertices_at_.data() + first_vertex_[i + 1]};
    }
    /// Whether several scene vertices share a place somewhere.
    [[nodiscard]] bool has_shared_places() const noexcept {
        return vertices_at_.size() != first_constructed_ - frame_places;
    }
    /// Whether B meets the neighbourhood of p in two or more sectors: a pinhole may lead through p.
    [[nodiscard]] bool is_pinch(Place p) const noexcept { return (pinch_[p] & pinch_bit) != 0; }
    /// Whether a ray through p may go on there although both of its sides end: a pinch, or a wall that
    /// leaves p between two others.
    [[nodiscard]] bool is_knot(Place p) const noexcept { return pinch_[p] != 0; }
    [[nodiscard]] bool has_walls() const noexcept { return has_walls_; }

    // --- triangles
    [[nodiscard]] std::size_t triangle_count() const noexcept { return solid_.size(); }
    [[nodiscard]] Place origin(HalfEdge h) const noexcept { return origin_[h]; }
    [[nodiscard]] Place target(HalfEdge h) const noexcept { return origin_[next(h)]; }
    [[nodiscard]] Place apex(HalfEdge h) const noexcept { return origin_[prev(h)]; }
    /// The same edge seen from the other side, or no_index on the frame.
    [[nodiscard]] HalfEdge twin(HalfEdge h) const noexcept { return twin_[h]; }
    /// A half-edge that starts at p; round one of the frame, the clockwise-most one.
    [[nodiscard]] HalfEdge leaving(Place p) const noexcept { return leaving_[p]; }
    /// Whether the triangle of h lies outside B.
    [[nodiscard]] bool is_free(HalfEdge h) const noexcept { return solid_[h >> 2U] == 0; }
    [[nodiscard]] bool is_wall(HalfEdge h) const noexcept { return (kind_[h] & wall_bit) != 0; }
    [[nodiscard]] bool is_constrained(HalfEdge h) const noexcept { return kind_[h] != 0; }
    /// Whether a segment can cross from the triangle of h to the other side.
    [[nodiscard]] bool is_open(HalfEdge h) const noexcept {
        return kind_[h] == 0 && twin_[h] != no_index && is_free(h);
    }
    /// The scene edge along h that bounds the triangle of h: that it sees when free, or whose inside it is.
    [[nodiscard]] EdgeId scene_edge(HalfEdge h) const noexcept { return scene_edge_[h]; }
    [[nodiscard]] bool is_boundary(HalfEdge h) const noexcept {
        return (kind_[h] & boundary_bit) != 0;
    }
    /// The next half-edge that starts at the same place, counter-clockwise; no_index at the frame.
    [[nodiscard]] HalfEdge rotate_ccw(HalfEdge h) const noexcept { return twin_[prev(h)]; }

    // --- predicates on places, exact
    [[nodiscard]] Sign orientation(Place a, Place b, Place c) const;
    /// Lexicographic order of two places.
    [[nodiscard]] Sign compare(Place a, Place b) const;
    /// All coordinates, the frame's included, are small multiples of one power of two, so that the
    /// 2×2 determinants of their differences are exact in doubles.
    [[nodiscard]] bool is_on_exact_grid() const noexcept { return exact_grid_; }
    /// The step of that grid, a power of two; 0 when there is none.
    [[nodiscard]] double grid_step() const noexcept { return grid_step_; }
    /// Bound on the rounding error of such a determinant of any three places (0 on an exact grid).
    [[nodiscard]] double orientation_bound() const noexcept { return orientation_bound_; }
    /// The same with one point anywhere in the frame, its coordinates rounded once.
    [[nodiscard]] double rounded_point_bound() const noexcept { return rounded_point_bound_; }
    /// Whether p lies on the exact grid, inside the frame: as good as a place.
    [[nodiscard]] bool is_on_exact_grid(const Point2& p) const noexcept;
    [[nodiscard]] bool is_in_frame(const Point2& p) const noexcept {
        return position_[0].x < p.x && p.x < position_[2].x && position_[0].y < p.y &&
               p.y < position_[2].y;
    }

private:
    friend class TriangulationBuilder;
    friend class Delaunay;
    static constexpr std::uint8_t boundary_bit = 1;
    static constexpr std::uint8_t wall_bit = 2;
    static constexpr std::uint8_t pinch_bit = 1;
    static constexpr std::uint8_t knot_bit = 2;

    std::vector<Point2> position_;
    std::vector<RationalPoint2> constructed_;
    Place first_constructed_ = 0;
    std::vector<Place> place_of_;
    std::vector<std::uint32_t> first_vertex_;
    std::vector<VertexId> vertices_at_;
    std::vector<std::uint8_t> pinch_;

    std::vector<Place> origin_;   // 4 a triangle, the fourth unused
    std::vector<HalfEdge> twin_;  // likewise
    std::vector<HalfEdge> leaving_;
    std::vector<std::uint8_t> kind_;   // a half-edge
    std::vector<EdgeId> scene_edge_;   // a half-edge
    std::vector<std::uint8_t> solid_;  // a triangle
    bool has_walls_ = false;
    bool exact_grid_ = false;
    double orientation_bound_ = 0;
    double rounded_point_bound_ = 0;
    double grid_step_ = 0;
};

}  // namespace sightline::detail
