// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "reference/directions2.hpp"
#include "reference/free_segments3.hpp"

namespace sightline::reference::detail {

/// Space near an interval of a line that lies in sheets (or near a point of it), cut into cells by the planes
/// of all faces that are met there. Which cells hang together says whether a sheet blocks (semantics 2.4).
class Surroundings {
public:
    /// Near what is between two points of the line.
    Surroundings(const LineCut& line, std::size_t first, std::size_t last);

    /// The sheets that the line crosses there: those of which each alone separates where it comes from
    /// where it leaves; if none does, all; empty when even all of them don't, or when solids do.
    [[nodiscard]] std::vector<BodyId> separating_sheets() const;

private:
    /// A cell of the planes through one point: on which side of each plane it lies.
    using Signs = std::vector<int>;
    /// A sector of a plane, between two cells.
    struct Wall {
        std::size_t front;
        std::size_t back;
        std::vector<BodyId> sheets;  ///< that cover it
        bool is_solid = false;       ///< covered by a solid's face
    };
    struct Point {
        std::vector<RationalTriple> normals;
        std::map<Signs, std::size_t> cells;
    };
    using Components = std::vector<std::size_t>;

    void add_point(std::size_t at);
    void add_walls(Point& point, std::size_t at, std::size_t plane);
    void add_wall(Point& point, std::size_t at, std::size_t plane, const RationalTriple& inner);
    std::size_t cell(Point& point, Signs signs);
    [[nodiscard]] bool covers(std::size_t triangle, std::size_t at,
                              const RationalTriple& direction) const;
    void join_along(const Point& a, const Point& b);
    [[nodiscard]] Signs signs_towards(const Point& point, int direction,
                                      const std::array<Rational, 2>& aside) const;

    [[nodiscard]] Components components(const std::vector<BodyId>& sheets) const;
    [[nodiscard]] std::vector<std::size_t> cells_along(const Point& point, int direction) const;
    [[nodiscard]] bool may_pass(const std::vector<BodyId>& sheets) const;

    const LineCut* line_;
    std::vector<Point> points_;
    std::size_t cell_count_ = 0;
    std::vector<Wall> walls_;
    std::vector<std::pair<std::size_t, std::size_t>> joints_;
    std::vector<std::size_t> solid_cells_;
};

}  // namespace sightline::reference::detail
