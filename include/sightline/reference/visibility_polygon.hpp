// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// A one-dimensional part of what is seen; `near` is where it leaves the regularised polygon.
struct SeenSegment {
    ViewPoint near;
    ViewPoint far;

    friend bool operator==(const SeenSegment&, const SeenSegment&) = default;
    friend std::strong_ordering operator<=>(const SeenSegment&, const SeenSegment&) = default;
};

/// What a point sees, in exact coordinates and canonical form.
struct PointView {
    RationalPoint2 from;
    std::vector<ViewPoint> ring;
    std::vector<SeenSegment> needles;  ///< ascending; empty unless asked for

    friend bool operator==(const PointView&, const PointView&) = default;
};

/// The visibility polygon of q by its definition (semantics 4.2): the closure of all p with pq free. Rays
/// are shot along all critical directions (through scene vertices, through crossings of walls, and along
/// the axes) and between them. Exact whatever `options.arithmetic` says.
///
/// Semantics
/// - q on the boundary of B or at a vertex: what free directions see; the ring passes through q, once for
///   each solid sector at q. q on a wall sees both sides.
/// - Errc::inside_body or Errc::outside_of_world when q is in the interior of B (a point of a contact of
///   two bodies along an edge is).
/// - The ring bounds the closure of the interior of what is seen; `needles` are the rest, e.g. what is seen
///   through a pinhole.
///
/// Canonical form of the ring
/// - Counter-clockwise; consecutive equal points and straight finite vertices removed (a vertex between two
///   vertices at infinity stays); from the lexicographically least finite vertex; of several such starts
///   the one with the least sequence. Finite vertices come before those at infinity.
/// - A maximal range of directions in which the view is unbounded gives the vertices at infinity of its
///   first and its last direction. When it spans 180° or more, those of the axis directions strictly
///   between the two are added; when it is the whole circle, it gives the four axis directions alone.
/// - A vertex at infinity has `at_infinity` set and as coordinates its direction from q, scaled so that the
///   larger of |x| and |y| is 1.
///
/// O((n + c) n) rational operations for n vertices and c crossings of walls.
[[nodiscard]] Result<PointView> visibility_polygon(const Scene2& scene, const RationalPoint2& q,
                                                   const VisibilityPolygonOptions& options = {});

/// The direction as a vertex at infinity: scaled so that the larger of |x| and |y| is 1.
[[nodiscard]] ViewPoint at_infinity(const RationalPoint2& direction);

/// The canonical form, as above, of any counter-clockwise ring (of which only the order of the vertices at
/// infinity is taken as it is).
[[nodiscard]] std::vector<ViewPoint> canonical_ring(std::vector<ViewPoint> ring);

/// Twice the signed area of a ring without vertices at infinity.
[[nodiscard]] Rational twice_area(const std::vector<ViewPoint>& ring);

}  // namespace sightline::reference
