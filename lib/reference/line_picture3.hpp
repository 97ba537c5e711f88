// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/exact3.hpp"
#include "sightline/arith/interval.hpp"

namespace sightline::reference::detail {

/// The line of the points base + t·direction; the direction's first nonzero coordinate, `axis`, is 1,
/// and base[axis] is 0: so t is the coordinate `axis` of the point.
struct ExactLine {
    /// The line through p along d, which is not zero.
    ExactLine(const SurdTriple& p, const SurdTriple& d);

    [[nodiscard]] SurdTriple at(const Surd& t) const { return plus(base, times(t, direction)); }

    std::size_t axis = 0;
    SurdTriple base;
    SurdTriple direction;
};

/// The scene projected along a line, which becomes the origin of the plane: a line meets what covers the
/// origin. Signs are taken from intervals where these are certain, and else from exact numbers.
class LinePicture {
public:
    LinePicture(const ExactScene& scene, const ExactLine& line);

    /// The projection of a vector: it has the coordinates (axis + 1, axis + 2) mod 3, and looking against
    /// the line's direction counter-clockwise is counter-clockwise.
    [[nodiscard]] std::array<Surd, 2> projected(const SurdTriple& vector) const;

    [[nodiscard]] const ExactLine& line() const { return line_; }
    /// Whether the vertex is on the line.
    [[nodiscard]] bool is_at(VertexId v) const { return sign(v, 0) == 0 && sign(v, 1) == 0; }
    /// t of a vertex (or of its projection to the axis).
    [[nodiscard]] const Rational& height(VertexId v) const {
        return scene_->vertices[v.index()][line_.axis];
    }
    /// Where the line crosses the relative interior of a segment that is not along it, if it does.
    [[nodiscard]] std::optional<Surd> crossing(VertexId a, VertexId b) const;
    /// False when the closed segment is certainly not met.
    [[nodiscard]] bool may_meet(VertexId a, VertexId b) const;
    /// An enclosure of where the line crosses the segment's line; everything when there is doubt.
    [[nodiscard]] Interval approx_crossing(VertexId a, VertexId b) const;

    /// Where the line meets a closed triangle: one point, or an interval when the line is in its plane.
    [[nodiscard]] std::optional<std::array<Surd, 2>> trace(const Triangle3& t) const;
    /// Whether the line, moved by (ε, ε²) in the projection, crosses the triangle: so it meets no vertex
    /// or edge, and whoever counts its crossings knows what is inside.
    [[nodiscard]] bool is_crossed_when_moved(const Triangle3& t) const;
    /// Whether the triangle certainly is crossed in its interior at a t in between these.
    [[nodiscard]] bool certainly_blocks(const Triangle3& t, const Interval& between) const;

    /// Sign of the turn a → b round the line.
    [[nodiscard]] int turn(VertexId a, VertexId b) const;
    /// Sign of a coordinate of a projected vertex.
    [[nodiscard]] int sign(VertexId v, std::size_t coordinate) const;

private:
    using Point = std::array<Surd, 2>;
    [[nodiscard]] const Point& exact(VertexId v) const;
    [[nodiscard]] Surd exact_turn(VertexId a, VertexId b) const;
    [[nodiscard]] int turn_when_moved(VertexId a, VertexId b) const;
    [[nodiscard]] std::optional<std::array<Surd, 2>> trace_in_plane(const Triangle3& t) const;

    const ExactScene* scene_;
    ExactLine line_;
    std::vector<std::array<Interval, 2>> rounded_;
    mutable std::vector<std::optional<Point>> exact_;
};

}  // namespace sightline::reference::detail
