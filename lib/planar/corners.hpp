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

private:
    [[nodiscard]] Corner classify(Place p) const;

    const Triangulation* t_;
    General general_;
    std::vector<Corner> corners_;
};

}  // namespace sightline::detail
