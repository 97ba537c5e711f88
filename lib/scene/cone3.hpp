// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the triangles that contain one point look like from there, drawn on a small sphere round it. Private.
///
/// A triangle leaves an arc on the sphere for each of its sides that does not pass through the point. An arc of a
/// solid has the solid's outside on its left, seen from outside of the sphere. Surfaces are valid near the point when
/// no two arcs cross, when each arc's inside is covered once and everything else at most once, and when no arc of a
/// sheet runs where a solid covers the sphere. Where two solids touch, their arcs coincide; each is thought to be
/// a bit on its own inner side.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/exact3.hpp"

namespace sightline::detail {

struct ConeTriangle {
    std::array<Point3, 3> corners;
    std::uint32_t id = 0;
    std::uint32_t vertex = 0;  ///< number of the corner at the point, when it is one
    bool is_sheet = false;
};

struct ConeFault {
    enum class Kind : std::uint8_t {
        crossing,  ///< the triangles cross
        overlap,   ///< what the triangles bound overlaps
        inside,    ///< the second, of a sheet, lies inside of what the first bounds
    };
    Kind kind = Kind::crossing;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

struct ConeReport {
    std::optional<ConeFault> fault;
    /// The triangles are one fan round one common vertex (solids: a closed one), and touch nowhere else.
    bool is_regular = false;
    /// The triangles are one piece of surface that does not touch itself in the point, wherever on it that is.
    bool is_simple = false;
};

/// The triangles are all those of the scene that contain the point.
[[nodiscard]] ConeReport look_around(const Point3& point, std::span<const ConeTriangle> triangles);
[[nodiscard]] ConeReport look_around(const RationalPoint3& point,
                                     std::span<const ConeTriangle> triangles);

}  // namespace sightline::detail
