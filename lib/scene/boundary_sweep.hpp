// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

/// Who owns a piece of the plane: a body, the solid outside of the world, or
/// nobody.
using Owner = std::uint32_t;
inline constexpr Owner free_space = std::numeric_limits<Owner>::max();
inline constexpr Owner world_solid = free_space - 1;
inline constexpr std::uint32_t no_edge = std::numeric_limits<std::uint32_t>::max();

[[nodiscard]] inline Owner owner_of(const Edge2& e) noexcept {
    return e.kind == EdgeKind2::world ? world_solid : e.body.value;
}

/// Why a set of directed rings does not bound solids with disjoint interiors.
struct SweepFault {
    enum class Kind : std::uint8_t {
        crossing,     ///< `first` and `second` cross in a point inside both
        overlap,      ///< `first` and `second` share a piece, with the same solid or on
                      ///< the same side
        mismatch,     ///< `second` starts or passes just above `first`, where its lower
                      ///< side cannot be
        chains_cross  ///< rings of one body cross in the vertex `place`
    };
    Kind kind = Kind::crossing;
    std::uint32_t first = no_edge;   ///< an edge, or no_edge for "below everything"
    std::uint32_t second = no_edge;  ///< an edge, or no_edge for "above everything"
    VertexId place;                  ///< where the sweep stood
};

/// A place where more than two edge ends of bodies or the world meet, or one
/// lies on another edge.
struct SweepTouch {
    std::vector<VertexId> vertices;  ///< at this place, ascending
    std::vector<std::uint32_t>
        passing;  ///< edges that contain the place in their relative interior
};

/// A vertex without boundary edges (of a wall or a point) and the solid that it
/// is in.
struct SweepInside {
    VertexId vertex;
    Owner owner = free_space;
    bool on_boundary = false;  ///< on edges of B, but every side is solid (a sealed contact)
};

struct SweepResult {
    std::optional<SweepFault> fault;
    std::vector<SweepInside> inside;
    std::vector<SweepTouch> touches;  ///< only when asked for
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        overlaps;  ///< sealed pairs; when asked for
};

/// One plane sweep over the edges of kinds `body` and `world`, with B on the
/// left of each: either the first fault met, or the places of all other
/// vertices. Walls are ignored.
///
/// Between neighbours in the status the solid above the lower edge must be the
/// solid below the upper one; with no proper crossing that is the whole of
/// validity (disjoint interiors and right nesting). Touching edges, edges that
/// overlap from opposite sides and pinched rings need no special care: a place
/// is handled once, with all that ends, passes and starts there. Cost O((n + k)
/// log n), k the edges passing through vertices. Source: Shamos and Hoey 1976.
[[nodiscard]] SweepResult sweep_boundaries(std::span<const Point2> vertices,
                                           std::span<const Edge2> edges, bool has_world,
                                           bool collect_touches);

}  // namespace sightline::detail
