// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "planar/cone_signs.hpp"

namespace sightline::detail {

/// Where a point lies in a triangulation.
struct Location {
    enum class Kind : std::uint8_t { triangle, edge, place };
    Kind kind = Kind::triangle;
    HalfEdge half_edge = no_index;  ///< of the triangle, on the edge, or leaving the place
};

/// Finds points in a triangulation: a grid over the scene gives a triangle nearby, an exact walk does
/// the rest. O(1) expected for evenly spread places, O(√n) otherwise.
class PointLocator {
public:
    explicit PointLocator(const Triangulation& t);

    /// The point must lie in the frame.
    [[nodiscard]] Location locate(const Viewpoint& point, Tally* tally = nullptr) const;

private:
    [[nodiscard]] HalfEdge start_near(const Point2& p) const;

    const Triangulation* t_;
    Point2 low_;
    double scale_x_ = 0;
    double scale_y_ = 0;
    std::uint32_t side_ = 1;
    std::vector<HalfEdge> start_;
};

}  // namespace sightline::detail
