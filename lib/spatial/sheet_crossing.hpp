// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether a line crosses sheets where it meets them, when more than one body is there: the law itself
/// (semantics 2.4), for contacts that no state machine of one body can judge. Private.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

#include "spatial/local_picture.hpp"

namespace sightline::detail {

/// A line along d at a maximal interval inside W: pictures of the points at which something changes, in
/// order; a single one where it does not run along W. Their cells, joined along the pieces between them,
/// stand for the neighbourhood of the interval.
template <typename Number>
class SheetCrossing {
public:
    using Vector = BasicVector3<Number>;

    /// Pictures with the borders of sheets.
    SheetCrossing(std::vector<LocalPicture<Number>> pictures, const Vector& d)
        : d_(d), pictures_(std::move(pictures)) {
        for (const auto& picture : pictures_) {
            offsets_.push_back(cell_count_);
            cell_count_ += picture.cells().size();
        }
    }

    /// The sheets that are crossed: those that would be without the others; when there is none, and W is
    /// crossed, all that are there. Empty when W is not crossed.
    [[nodiscard]] std::set<BodyId> crossed() const {
        std::set<BodyId> all;
        for (const auto& picture : pictures_) {
            for (const auto& wall : picture.walls()) {
                all.insert(wall.sheets.begin(), wall.sheets.end());
            }
        }
        if (may_pass(all) || !may_pass({})) return {};
        std::set<BodyId> alone;
        for (const BodyId b : all) {
            if (!may_pass({b})) alone.insert(b);
        }
        return alone.empty() ? all : alone;
    }

private:
    /// Union-find over all cells.
    class Components {
    public:
        explicit Components(std::size_t n) : parent_(n) {
            std::iota(parent_.begin(), parent_.end(), 0U);
        }
        void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
        [[nodiscard]] std::size_t find(std::size_t a) const {
            while (parent_[a] != a) a = parent_[a];
            return a;
        }

    private:
        std::vector<std::size_t> parent_;
    };

    // Whether some free cell in which the segment comes is joined to one in which it leaves, when only these
    // sheets are there.
    [[nodiscard]] bool may_pass(const std::set<BodyId>& sheets) const {
        const Components components = joined(sheets);
        const auto& first = pictures_.front();
        const auto& last = pictures_.back();
        for (const std::size_t i : first.cells_along(-d_)) {
            if (!first.cells()[i].solids.empty()) continue;
            for (const std::size_t j : last.cells_along(d_)) {
                if (last.cells()[j].solids.empty() &&
                    components.find(i) == components.find(offsets_.back() + j)) {
                    return true;
                }
            }
        }
        return false;
    }

    // Free cells, joined through walls that are not in the sheets, and along the pieces of the interval.
    [[nodiscard]] Components joined(const std::set<BodyId>& sheets) const {
        Components result(cell_count_);
        for (std::size_t k = 0; k < pictures_.size(); ++k) {
            const auto& cells = pictures_[k].cells();
            for (const auto& wall : pictures_[k].walls()) {
                const bool shut = std::any_of(wall.sheets.begin(), wall.sheets.end(),
                                              [&](BodyId b) { return sheets.contains(b); });
                const bool free =
                    cells[wall.first].solids.empty() && cells[wall.second].solids.empty();
                if (free && !shut)
                    result.unite(offsets_[k] + wall.first, offsets_[k] + wall.second);
            }
            if (k + 1 < pictures_.size()) join_along(k, result);
        }
        return result;
    }

    void join_along(std::size_t k, Components& result) const {
        const auto& here = pictures_[k];
        const auto& next = pictures_[k + 1];
        std::vector<Vector> normals;
        for (const auto* picture : {&here, &next}) {
            for (const Vector& n : picture->normals()) {
                if (sign_of(dot(n, d_)) == Sign::zero) normals.push_back(n);
            }
        }
        for (const Vector& w : LocalPicture<Number>::sectors(normals, d_)) {
            result.unite(offsets_[k] + here.cell_towards(d_, w),
                         offsets_[k + 1] + next.cell_towards(-d_, w));
        }
    }

    Vector d_;
    std::vector<LocalPicture<Number>> pictures_;
    std::vector<std::size_t> offsets_;  // of each picture's cells
    std::size_t cell_count_ = 0;
};

}  // namespace sightline::detail
