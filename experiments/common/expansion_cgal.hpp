// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "sightline/scene/scene2.hpp"

namespace sightline::experiments {

/// The yardstick: visibility polygons by CGAL's triangular expansion with exact coordinates
/// (Triangular_expansion_visibility_2 on EPECK). For scenes with a world and without walls.
///
/// CGAL wants to be told in which face of its arrangement a point lies; that is found out beforehand and
/// not counted. Building the arrangement is not counted either; attach() is.
class CgalExpansion {
public:
    explicit CgalExpansion(const Scene2& scene);
    ~CgalExpansion();
    CgalExpansion(const CgalExpansion&) = delete;
    CgalExpansion& operator=(const CgalExpansion&) = delete;

    /// Triangulates the arrangement: CGAL's preprocessing.
    void attach();
    /// The visibility polygons of all vertices, at a pinch one a sector; the number of their vertices.
    [[nodiscard]] std::size_t from_every_vertex();

    /// The points that `from_point` knows by index; they lie in open free space.
    void locate(std::span<const Point2> points);
    /// The visibility polygon of one of them; the number of its vertices.
    [[nodiscard]] std::size_t from_point(std::size_t index);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sightline::experiments
