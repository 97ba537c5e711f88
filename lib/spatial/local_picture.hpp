// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What there is round one point, exactly and by trying all planes. Private.

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "spatial/exact_triangles.hpp"

namespace sightline::detail {

/// The scene in a small enough ball round a point x: the cells into which the planes through x of all
/// triangles cut it, and the solids that each of them is in. With `sheet_borders` also the planes
/// through the edges of sheets' triangles at x, across them: then sheets consist of whole walls
/// between cells.
template <typename Number>
class LocalPicture {
public:
    using Vector = BasicVector3<Number>;
    using Signs = std::vector<Sign>;

    struct Cell {
        Signs signs;                 ///< on which side of each plane
        Vector direction;            ///< leads into the cell
        std::vector<BodyId> solids;  ///< that contain it
    };
    /// Two cells on the two sides of a wall, and the sheets in which the wall lies.
    struct Wall {
        std::size_t first;
        std::size_t second;
        std::vector<BodyId> sheets;
    };

    using Triangles = std::vector<const ExactTriangle*>;
    /// Says into which solids a direction leads, which lies in none of the planes.
    using Solids = std::function<std::vector<BodyId>(const Vector&)>;

    /// Of the triangles, at least those that contain x.
    LocalPicture(Triangles triangles, const Vector& x, bool sheet_borders, const Solids& solids)
        : triangles_(std::move(triangles)), x_(x), solids_(solids) {
        find_planes(sheet_borders);
        find_cells();
        if (sheet_borders) find_walls();
    }

    [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return cells_; }
    [[nodiscard]] const std::vector<Wall>& walls() const noexcept { return walls_; }
    [[nodiscard]] const std::vector<Vector>& normals() const noexcept { return normals_; }

    /// Whether x is in the interior of B.
    [[nodiscard]] bool is_interior() const {
        return std::none_of(cells_.begin(), cells_.end(),
                            [](const Cell& c) { return c.solids.empty(); });
    }
    /// The cells, of B or not, whose closure a short step along d lies in.
    [[nodiscard]] std::vector<std::size_t> cells_along(const Vector& d) const {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            bool agrees = true;
            for (std::size_t k = 0; k < normals_.size() && agrees; ++k) {
                const Sign side = sign_of(dot(normals_[k], d));
                agrees = side == Sign::zero || side == cells_[i].signs[k];
            }
            if (agrees) result.push_back(i);
        }
        return result;
    }
    /// The cell into which the direction d, turned a little towards w, leads; w is in no plane in which d is.
    [[nodiscard]] std::size_t cell_towards(const Vector& d, const Vector& w) const {
        return index_.at(signs_of(turned(normals_, d, w)));
    }

    /// d + t w for some t > 0 so small that d's nonzero signs on the planes do not change.
    static Vector turned(const std::vector<Vector>& normals, const Vector& d, const Vector& w) {
        Number t(1);
        for (const Vector& n : normals) {
            const Number at_d = dot(n, d);
            const Number at_w = dot(n, w);
            if (sign_of(at_d) * sign_of(at_w) == Sign::negative) shrink(t, at_d, at_w);
        }
        return d + t * w;
    }

    /// Directions into all sectors that planes, which all contain d, make round it; with no planes, one
    /// direction that is not along d.
    static std::vector<Vector> sectors(const std::vector<Vector>& normals, const Vector& d) {
        if (normals.empty()) {
            const Vector x{Number(1), Number(0), Number(0)};
            const Vector y{Number(0), Number(1), Number(0)};
            return {cross(x, d).is_zero() ? y : x};
        }
        std::vector<Vector> result;
        for (const Vector& n : normals) {
            const Vector along = cross(n, d);
            for (const Vector& ray : {along, -along}) {
                result.push_back(turned(normals, ray, n));
                result.push_back(turned(normals, ray, -n));
            }
        }
        return result;
    }

private:
    void add_plane(const Vector& n) {
        const bool known = std::any_of(normals_.begin(), normals_.end(), [&](const Vector& other) {
            return cross(n, other).is_zero();
        });
        if (!known) normals_.push_back(n);
    }

    void find_planes(bool sheet_borders) {
        for (const ExactTriangle* each : triangles_) {
            const ExactTriangle& t = *each;
            if (sign_of(height(t, x_)) != Sign::zero) continue;
            add_plane(over<Number>(t.normal));
            if (!sheet_borders || !t.is_sheet || !contains(t, x_)) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                if (sign_of(inward(t, i, x_)) != Sign::zero) continue;
                const Vector3 edge = t.corners[(i + 1) % 3] - t.corners[i];
                add_plane(over<Number>(cross(t.normal, edge)));
            }
        }
    }

    [[nodiscard]] Signs signs_of(const Vector& direction) const {
        Signs signs;
        for (const Vector& n : normals_) signs.push_back(sign_of(dot(n, direction)));
        return signs;
    }

    // Every cell has a ray in which two planes meet, or there are no two planes.
    void find_cells() {
        if (normals_.empty()) add_cell({});
        if (normals_.size() == 1) {
            add_cell(normals_[0]);
            add_cell(-normals_[0]);
        }
        std::vector<Vector> rays;
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) rays.push_back(cross(normals_[i], normals_[j]));
        }
        for (const Vector& ray : rays) {
            std::vector<Vector> through;
            for (const Vector& n : normals_) {
                if (sign_of(dot(n, ray)) == Sign::zero) through.push_back(n);
            }
            for (const Vector& w : sectors(through, ray)) {
                add_cell(turned(normals_, ray, w));
                add_cell(turned(normals_, -ray, w));
            }
        }
    }

    void add_cell(const Vector& direction) {
        const Signs signs = signs_of(direction);
        if (!index_.emplace(signs, cells_.size()).second) return;
        cells_.push_back({signs, direction, solids_(direction)});
    }

    void find_walls() {
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            for (std::size_t k = 0; k < normals_.size(); ++k) {
                if (cells_[i].signs[k] != Sign::positive) continue;
                Signs across = cells_[i].signs;
                across[k] = Sign::negative;
                const auto other = index_.find(across);
                if (other != index_.end()) add_wall(i, other->second, normals_[k]);
            }
        }
    }

    void add_wall(std::size_t i, std::size_t j, const Vector& normal) {
        const Vector& d = cells_[i].direction;
        const Vector& e = cells_[j].direction;
        // A direction into the wall: where the step from one cell to the other passes its plane.
        const Vector c = dot(normal, d) * e - dot(normal, e) * d;
        std::vector<BodyId> sheets;
        for (const ExactTriangle* each : triangles_) {
            const ExactTriangle& t = *each;
            if (t.is_sheet && cross(over<Number>(t.normal), normal).is_zero() && contains(t, x_) &&
                leads_into(t, x_, c)) {
                sheets.push_back(t.body);
            }
        }
        walls_.push_back({i, j, sheets});
    }

    Triangles triangles_;
    Vector x_;
    Solids solids_;
    std::vector<Vector> normals_;
    std::vector<Cell> cells_;
    std::vector<Wall> walls_;
    std::map<Signs, std::size_t> index_;
};

}  // namespace sightline::detail
