// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/cone_signs.hpp"

namespace sightline::detail {

/// What decides whether a segment that ends at a place is locally tangent there: whether its straight
/// extension is locally free.
struct Corner {
    enum class Kind : std::uint8_t {
        open,    ///< neither B nor a wall: always
        convex,  ///< one sector of B below 180°: when both its edges lie on one closed side
        flat,    ///< one sector of 180°: along its edges only
        reflex,  ///< one sector above 180°: never
        general  ///< several sectors, or walls: by following the ray
    };
    Kind kind = Kind::open;
    /// The sector of B runs counter-clockwise from the edge towards `first` to the edge towards `last`.
    Place first = no_index;
    Place last = no_index;
    Point2 first_position{};  // beside the places, for the filter
    Point2 last_position{};
};

/// The corners of all scene places.
class Corners {
public:
    /// What counts at general corners: tangent directions, or (where a path may bend) any.
    enum class General : std::uint8_t { tangent, any_direction };

    explicit Corners(const Triangulation& t, General general = General::tangent);

    [[nodiscard]] const Corner& operator[](Place p) const noexcept { return corners_[p]; }
    /// Whether the visible segment v→w, extended beyond w, is locally free.
    [[nodiscard]] bool is_tangent(const Viewpoint& v, Place w, ConeSigns& signs) const;
    /// The same; the determinants that `bound` (of signs.bound(v)) decides are settled inline.
    [[nodiscard]] bool is_tangent(const Viewpoint& v, double bound, Place w,
                                  ConeSigns& signs) const {
        const Corner& c = corners_[w];
        if (c.kind == Corner::Kind::reflex) return false;
        if (c.kind == Corner::Kind::convex) {
            const Point2& p = t_->position(w);
            const double dx = p.x - v.position.x;
            const double dy = p.y - v.position.y;
            const double first =
                dx * (c.first_position.y - v.position.y) - dy * (c.first_position.x - v.position.x);
            const double last =
                dx * (c.last_position.y - v.position.y) - dy * (c.last_position.x - v.position.x);
            const bool left_of_first = first > bound;
            const bool left_of_last = last > bound;
            if ((left_of_first || first < -bound) && (left_of_last || last < -bound)) {
                signs.count(2);
                return left_of_first == left_of_last;
            }
        }
        return is_tangent(v, w, signs);
    }

private:
    [[nodiscard]] Corner classify(Place p) const;

    const Triangulation* t_;
    General general_;
    std::vector<Corner> corners_;
};

}  // namespace sightline::detail
