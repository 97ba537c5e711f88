// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <ostream>
#include <vector>

#include "sightline/geom/point.hpp"

namespace sightline {

/// A closed chain of vertices; the edge from the last to the first is implied.
using Ring2 = std::vector<Point2>;

/// An outer ring and the rings of its holes, in any orientation, as read: nothing is checked.
struct Polygon2 {
    Ring2 outer;
    std::vector<Ring2> holes;

    friend bool operator==(const Polygon2&, const Polygon2&) = default;
};

/// A closed line segment; a single point when its ends are equal. Predicates: predicates2.hpp.
struct Segment2 {
    Point2 source;
    Point2 target;

    friend bool operator==(const Segment2&, const Segment2&) = default;
    friend std::partial_ordering operator<=>(const Segment2&, const Segment2&) = default;
    /// "(x, y)--(x, y)".
    friend std::ostream& operator<<(std::ostream& out, const Segment2& s) {
        return out << s.source << "--" << s.target;
    }
};

[[nodiscard]] inline Segment2 reversed(const Segment2& s) { return {s.target, s.source}; }

}  // namespace sightline
