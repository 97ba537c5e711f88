// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/scene/scene2.hpp"

namespace sightline {

/// Where a point is with respect to B (semantics: docs/structures/scene.md).
enum class PlaceKind2 : std::uint8_t {
    free,          ///< not in B; it may lie on a wall
    boundary,      ///< on the boundary of B
    inside_body,   ///< in the interior of B, sealed contacts included
    outside_world  ///< outside of the world
};

struct Location2 {
    PlaceKind2 kind = PlaceKind2::free;
    /// inside_body: the body, the least one when the point lies on a sealed contact.
    BodyId body;
    /// The least scene vertex at the point, or none.
    VertexId vertex;
    /// The least edge of the scene that contains the point, walls included, or none.
    EdgeId edge;

    friend bool operator==(const Location2&, const Location2&) = default;
};

/// Locates a point; exact. Cost O(n), with exact arithmetic only for edges near the point's x.
[[nodiscard]] Location2 locate(const Scene2& scene, const RationalPoint2& p);
/// The same for a point with double coordinates.
[[nodiscard]] Location2 locate(const Scene2& scene, const Point2& p);

}  // namespace sightline
