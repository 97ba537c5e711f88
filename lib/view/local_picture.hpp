// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is connected with what round a few neighbouring places on a line of sight. Private.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sightline/geom/vector3.hpp"

namespace sightline::detail {

/// Round a place of a line of sight, faces are cones; the planes of these cut a small sphere into cells. Cells
/// are one component where no face lies between them.
class LocalPicture {
public:
    /// A face through the place: its plane n·r + m w = 0, positive outside, and its corners (r, w).
    struct Triangle {
        Vector3 n;
        Rational m;
        bool is_sheet = false;
        std::vector<std::pair<Vector3, Rational>> corners;
    };
    using Cell = std::uint32_t;

    explicit LocalPicture(const Vector3& delta);

    /// Adds the next place, of weight w, away from the viewpoint.
    void add_place(const Rational& w, const std::vector<Triangle>& triangles);
    /// The cells of the last place round the direction to the viewpoint (or away from it), in which the given
    /// directions aside lie.
    [[nodiscard]] std::vector<Cell> cells_round(bool to_viewpoint, std::span<const Vector3> asides);
    void join(Cell a, Cell b);
    /// Whether some cell of the first list, outside of solids, is connected to one of the second.
    [[nodiscard]] bool connects(std::span<const Cell> from, std::span<const Cell> to);

private:
    struct Cone {
        Vector3 normal;
        bool is_sheet;
        std::vector<Vector3> rays;
    };
    [[nodiscard]] Vector3 chart(const Vector3& r, const Rational& w) const;
    [[nodiscard]] Cell cell(const std::string& key);
    [[nodiscard]] Cell root(Cell c);
    void cut_circle(std::size_t plane, const std::vector<Cone>& cones);
    void visit_arc(std::size_t plane, const Vector3& middle, const std::vector<Cone>& cones);

    Vector3 delta_;
    std::size_t axis_ = 0;
    Rational w_;
    std::uint32_t place_ = 0;
    std::vector<Vector3> planes_;
    std::map<std::string, Cell> names_;
    std::vector<Cell> parent_;
    std::vector<char> inside_;
};

}  // namespace sightline::detail
