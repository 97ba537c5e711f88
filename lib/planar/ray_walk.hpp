// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "planar/point_locator.hpp"

namespace sightline::detail {

/// A segment followed exactly through the triangulation, from one place through another and beyond,
/// under the blocking rules of semantics 2.4: the interior of B blocks, contact of codimension one is
/// sealed, pinholes are free, walls block where they separate and B alone does not.
class RayWalk {
public:
    /// Stands at v, looking along v→toward (a different place, in any distance).
    RayWalk(const Triangulation& t, Place v, Place toward)
        : t_(t), from_{t.position(v), v}, toward_{t.position(toward), toward}, at_(v) {}
    /// The same from any point, which lies at `start`, towards any other.
    RayWalk(const Triangulation& t, const Viewpoint& v, const Location& start, Place toward)
        : RayWalk(t, v, start, Viewpoint{t.position(toward), toward}) {}
    RayWalk(const Triangulation& t, const Viewpoint& v, const Location& start,
            const Viewpoint& toward)
        : t_(t), from_(v), toward_(toward), at_(v.place), start_(start) {}

    /// What the ray ran into when it did not come to another place: an edge, seen from this side; or
    /// no_index when it could not leave the last place.
    [[nodiscard]] HalfEdge stopped_by() const noexcept { return stopped_by_; }
    /// Moves on to the place w on the ray, which is visible, or which an arithmetic that may be wrong
    /// holds to be so. Without walls nothing before w matters there and the way is not walked.
    void skip_to(Place w);
    /// Goes on to the next place on the ray; no_index when the ray is blocked or leaves the frame.
    [[nodiscard]] Place next_place();
    /// Walks to the point `toward`; whether the segment up to there is free.
    [[nodiscard]] bool reaches_target();
    /// Whether the ray can go on beyond the place where it stands, however little.
    [[nodiscard]] bool can_leave();
    /// Whether the last step ran along a body's or the world's boundary.
    [[nodiscard]] bool ran_along_boundary() const noexcept { return along_boundary_; }

private:
    // What lies round the current place, as seen along the ray.
    struct Surroundings {
        HalfEdge out_edge = no_index;      ///< starts here and runs along the ray
        HalfEdge out_triangle = no_index;  ///< starts here; the ray enters its triangle
        bool wall_left = false, wall_right = false, wall_here = false;
        bool solid_left = false, solid_right = false;
        bool in_left_free = true, in_right_free = true;
    };
    [[nodiscard]] Surroundings look() const;
    void look_at(HalfEdge h, Surroundings& s) const;
    [[nodiscard]] Sign side(Place p) const;
    [[nodiscard]] bool is_ahead(Place p) const;
    [[nodiscard]] bool pass(const Surroundings& s);
    [[nodiscard]] Place cross_triangles(HalfEdge h);
    [[nodiscard]] std::optional<Place> leave_by(HalfEdge h);
    [[nodiscard]] Place first_place(const Location& start);
    [[nodiscard]] RationalPoint2 exact(const Viewpoint& v) const;

    const Triangulation& t_;
    Viewpoint from_;
    Viewpoint toward_;
    Place at_;  // no_index: at the start, which is no place
    Location start_{};
    HalfEdge stopped_by_ = no_index;
    bool along_boundary_ = false;
    // While the ray runs inside walls: is its left (right) side joined to where it came from, near the
    // run, in the complement of W ∪ B, and in the complement of B alone? `came_`: it came from outside.
    bool in_wall_ = false;
    bool came_ = false;
    bool left_ = true, right_ = true;
    bool left_of_solid_ = true, right_of_solid_ = true;
};

}  // namespace sightline::detail
