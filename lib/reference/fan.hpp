// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/sight_line.hpp"

namespace sightline::reference {

/// Cheap rejection for all sight lines from one vertex: the edges and points of a scene, dealt by
/// the rounded angle under which the vertex sees them into overlapping parts of the circle. Only
/// what certainly does not meet a line is left out of its candidates, so answers do not depend on
/// this.
class Fan {
public:
    Fan(const Scene2& scene, VertexId apex);

    /// All that may meet the segment from the apex to w.
    [[nodiscard]] Candidates towards(const Point2& w) const;

private:
    struct Part {
        std::vector<EdgeId> edges;
        std::vector<VertexId> points;
    };
    [[nodiscard]] double angle_of(const Point2& p) const;
    [[nodiscard]] std::size_t part_of(double angle) const;
    void deal(EdgeId edge, const Point2& a, const Point2& b);
    void deal(VertexId point, const Point2& p);

    Point2 apex_;
    Everything all_;
    std::vector<Part> parts_;
};

}  // namespace sightline::reference
