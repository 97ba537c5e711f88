// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "sightline/arith/interval.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/spatial/box3.hpp"

/// Conservative tests of boxes against the loci of visual events. Each is false only when the box,
/// closed, has no point in common with the set, exactly; near misses and contacts are true. Where
/// coefficients are intervals, they stand for every choice of numbers in them. Boxes are not empty,
/// and finite.

namespace sightline {

/// All planes normal · x = offset with coefficients in the intervals.
struct PlaneBounds3 {
    std::array<Interval, 3> normal;
    Interval offset;
};

/// All lines with Plücker coordinates in the intervals: moment = p × direction for points p of the line.
struct LineBounds3 {
    std::array<Interval, 3> direction;
    std::array<Interval, 3> moment;
};

/// All quadrics Σ square[i] xᵢ² + Σ mixed[i] xⱼxₖ (i, j, k different) + Σ linear[i] xᵢ + constant = 0.
struct QuadricBounds3 {
    std::array<Interval, 3> square;
    std::array<Interval, 3> mixed;
    std::array<Interval, 3> linear;
    Interval constant;
};

/// All lines through the apex and a point of the segment ab: a planar double wedge (the locus of an EV
/// event), unbounded on both sides; the lines that pass through both when apex, a and b are
/// collinear. When a or b is the apex, it is the line through the other.
struct Wedge3 {
    Point3 apex;
    Point3 a;
    Point3 b;
};

/// Whether some plane may meet the box. Cost: 3 interval products.
[[nodiscard]] bool may_meet(const Box3& box, const PlaneBounds3& plane);

/// Whether some line may meet the box: its three projections are tested, which is sharp. A direction
/// whose intervals all hold zero excludes nothing.
[[nodiscard]] bool may_meet(const Box3& box, const LineBounds3& line);

/// Whether the closed triangle abc may meet the box: 13 separating directions, which is sharp. The
/// triangle may be degenerate.
[[nodiscard]] bool may_meet(const Box3& box, const Point3& a, const Point3& b, const Point3& c);

/// Whether the wedge may meet the box: separating directions of each half.
[[nodiscard]] bool may_meet(const Box3& box, const Wedge3& wedge);

/// Whether some quadric may meet the box: its polynomial is expanded about the box's middle, so the
/// test gets sharp as boxes get small.
[[nodiscard]] bool may_meet(const Box3& box, const QuadricBounds3& quadric);

}  // namespace sightline
