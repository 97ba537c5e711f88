// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/shaft.hpp"

#include <algorithm>
#include <bit>

#include "sightline/scene/result.hpp"
#include "spatial/separation.hpp"

namespace sightline {

using detail::half_difference;
using detail::magnitude;
using detail::Normal3;
using detail::product;
using detail::product_above;
using detail::product_below;
using detail::product_error;
using detail::proposed_normal;
using detail::scaled_normal;

Convex3::Convex3(const Box3& box) : shape_(Shape::box), size_(8) {
    SIGHTLINE_EXPECT(!box.is_empty());
    for (unsigned i = 0; i < 8; ++i) corners_[i] = box.corner(i);
}

/// Proposes planes and keeps those that support the hull, as far as doubles can tell: which planes a
/// shaft has decides how sharp it is, and their offsets are certain for any normal.
class ShaftBuilder {
public:
    ShaftBuilder(Shaft& shaft, const Convex3& from, const Convex3& to)
        : shaft_(shaft), sets_{&from, &to} {
        for (const Convex3* set : sets_) {
            for (const Point3& p : set->corners()) {
                points_.push_back(p);
                shaft.bounds_.include(p);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            reach_[i] = std::max(std::abs(shaft.bounds_.low[i]), std::abs(shaft.bounds_.high[i]));
        }
        for (std::size_t i = 0; i < 2; ++i) find_edges(i);
    }

    void build() {
        const bool boxes =
            sets_[0]->shape() == Convex3::Shape::box && sets_[1]->shape() == Convex3::Shape::box;
        // All facets of two boxes' hull are parallel to an axis.
        if (!boxes) propose_facets();
        propose_parallel_to_axes();
    }

private:
    using Pair = std::array<std::size_t, 2>;  // of places in points_

    [[nodiscard]] std::size_t first(std::size_t set) const {
        return set == 0 ? 0 : sets_[0]->corners().size();
    }

    void find_edges(std::size_t set) {
        const std::size_t n = sets_[set]->corners().size();
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                const std::size_t changed = i ^ j;
                const bool is_edge =
                    sets_[set]->shape() != Convex3::Shape::box || (changed & (changed - 1)) == 0;
                if (is_edge) edges_[set].push_back({first(set) + i, first(set) + j});
            }
        }
    }

    [[nodiscard]] Normal3 difference(std::size_t to, std::size_t from) const {
        return half_difference(points_[to], points_[from]);
    }

    void propose_facets() {
        for (std::size_t set = 0; set < 2; ++set) {
            const std::size_t other = 1 - set;
            for (const Pair& e : edges_[set]) {
                for (std::size_t k = 0; k < sets_[other]->corners().size(); ++k) {
                    propose_through(e[0], e[1], first(other) + k);
                }
            }
            if (sets_[set]->shape() == Convex3::Shape::triangle) {
                propose_through(first(set), first(set) + 1, first(set) + 2);
            }
        }
    }

    void propose_through(std::size_t i, std::size_t j, std::size_t k) {
        propose(proposed_normal(difference(j, i), difference(k, i)),
                {1U << i | 1U << j | 1U << k, no_axis});
    }

    // The edges of the hull's projection along each axis.
    void propose_parallel_to_axes() {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < points_.size(); ++i) {
                for (std::size_t j = i + 1; j < points_.size(); ++j) {
                    if (is_hidden_along(axis, i) || is_hidden_along(axis, j)) continue;
                    const Normal3 d = difference(j, i);
                    Normal3 n{};
                    n[(axis + 1) % 3] = d[(axis + 2) % 3];
                    n[(axis + 2) % 3] = -d[(axis + 1) % 3];
                    // The box of all tests these already.
                    if (n[(axis + 1) % 3] == 0 || n[(axis + 2) % 3] == 0) continue;
                    propose(scaled_normal(n), {1U << i | 1U << j, axis});
                }
            }
        }
    }

    // Half of a box's corners lie behind others of it.
    [[nodiscard]] bool is_hidden_along(std::size_t axis, std::size_t i) const {
        const std::size_t set = i < first(1) ? 0 : 1;
        return sets_[set]->shape() == Convex3::Shape::box && ((i - first(set)) >> axis & 1U) != 0;
    }

    /// Points that, together with the axis it is parallel to, if any, determine a plane.
    struct Through {
        unsigned points;
        std::size_t axis;
    };
    static constexpr std::size_t no_axis = 3;

    void propose(const Normal3& n, const Through& through) {
        if (n == Normal3{}) return;
        propose_oriented(n, through);
        propose_oriented({-n[0], -n[1], -n[2]}, through);
    }

    void propose_oriented(const Normal3& n, const Through& through) {
        for (const Kept& kept : kept_) {
            if (kept.axis == through.axis && (kept.on & through.points) == through.points &&
                dot(kept.normal, n) > 0) {
                return;
            }
        }
        double top = -Box3::infinite;
        double above = -Box3::infinite;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            above = std::max(above, product_above(n, points_[i]));
            if ((through.points >> i & 1U) != 0) top = std::max(top, product_above(n, points_[i]));
        }
        unsigned on = through.points;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (product_below(n, points_[i]) > top) return;  // cuts the hull
            if (product_above(n, points_[i]) >= product_below(n, points_[lowest(through.points)])) {
                on |= 1U << i;
            }
        }
        kept_.push_back({n, on, through.axis});
        const double error = product_error(magnitude(n, {reach_[0], reach_[1], reach_[2]}));
        // Twice: for the products of the box's corner, and for the sum.
        shaft_.planes_.push_back({n, above + 2 * error, above});
    }

    [[nodiscard]] static std::size_t lowest(unsigned mask) {
        return static_cast<std::size_t>(std::countr_zero(mask));
    }
    [[nodiscard]] static double dot(const Normal3& a, const Normal3& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    struct Kept {
        Normal3 normal;
        unsigned on;  // the points that may lie on the plane
        std::size_t axis;
    };

    Shaft& shaft_;
    std::array<const Convex3*, 2> sets_;
    std::vector<Point3> points_;
    std::array<double, 3> reach_{};
    std::array<std::vector<Pair>, 2> edges_;
    std::vector<Kept> kept_;
};

Shaft::Shaft(const Convex3& from, const Convex3& to) { ShaftBuilder(*this, from, to).build(); }

bool Shaft::may_meet(const Box3& box) const {
    if (!bounds_.meets(box)) return false;
    // What lies outside of the bounds is outside of the shaft. Clipping bounds the errors, too.
    std::array<double, 3> low;
    std::array<double, 3> high;
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::max(bounds_.low[i], box.low[i]);
        high[i] = std::min(bounds_.high[i], box.high[i]);
    }
    for (const Plane& plane : planes_) {
        const auto& n = plane.normal;
        const Point3 nearest{n[0] > 0 ? low[0] : high[0], n[1] > 0 ? low[1] : high[1],
                             n[2] > 0 ? low[2] : high[2]};
        if (product(n, nearest) > plane.offset) return false;
    }
    return true;
}

bool Shaft::may_meet(std::span<const Point3> points) const {
    Box3 box;
    for (const Point3& p : points) box.include(p);
    if (!bounds_.meets(box)) return false;
    return std::none_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
        return std::all_of(points.begin(), points.end(), [&](const Point3& p) {
            return product_below(plane.normal, p) > plane.corner_offset;
        });
    });
}

}  // namespace sightline
