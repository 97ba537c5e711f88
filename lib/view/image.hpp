// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The scene as a viewpoint sees it: signs of what a picture is made of. Private.
///
/// Every point x of space gets a vector r(x), affine in x, such that points on one line of sight have
/// parallel vectors of one sense, and a number w(x) such that of two such points, scaled to one vector, the
/// one with the larger w is nearer: r = x - p, w = 1 from a point p; from infinity, along d, r = (X, Y, -1)
/// with coordinates X, Y of the image plane, and w = -d·x. So both kinds of view are one.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/interval.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/vector3.hpp"
#include "sightline/view/view3.hpp"
#include "view/placed_scene.hpp"

namespace sightline::detail {

/// A number that differs from an exact one by at most `error`.
struct Near {
    double value = 0;
    double error = 0;
};

/// The plane through the viewpoint and two points a, b, by its normal, which points to the left of a→b as seen.
struct SightPlane {
    std::array<double, 3> normal{};
    std::array<double, 3> size{};  ///< of the normal's terms: what errors are relative to
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};

/// Points are numbered: the scene's vertices, then the cone's corners.
class Image {
public:
    Image(const PlacedScene& scene, const Viewpoint3& from, std::span<const RationalPoint3> corners,
          Arithmetic arithmetic, Tally* tally);

    [[nodiscard]] const PlacedScene& scene() const noexcept { return scene_; }
    [[nodiscard]] bool at_infinity() const noexcept { return from_.at_infinity; }
    [[nodiscard]] const Viewpoint3& from() const noexcept { return from_; }
    [[nodiscard]] std::uint32_t vertex_count() const noexcept { return vertices_; }
    [[nodiscard]] std::uint32_t point_count() const noexcept {
        return static_cast<std::uint32_t>(r_.size());
    }

    [[nodiscard]] SightPlane plane(std::uint32_t a, std::uint32_t b) const;
    /// On which side of a→b, as seen, c lies: positive on the left. Zero when a and b are on one line of sight.
    [[nodiscard]] Sign side(const SightPlane& plane, std::uint32_t c);
    [[nodiscard]] Sign orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return side(plane(a, b), c);
    }
    /// The value whose sign side() is.
    [[nodiscard]] Near near_side(const SightPlane& plane, std::uint32_t c) const;
    /// On which side of the plane of three vertices a fourth lies: positive where they are counter-clockwise.
    /// The viewpoint's own side is orientation(a, b, c).
    [[nodiscard]] Sign height(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x);
    [[nodiscard]] Near near_height(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                   std::uint32_t x) const;
    /// Component k of r(a) × r(b).
    [[nodiscard]] Near near_minor(std::uint32_t a, std::uint32_t b, std::size_t k) const;
    [[nodiscard]] Sign minor(std::uint32_t a, std::uint32_t b, std::size_t k);
    /// A component in which the plane's normal certainly does not vanish; empty when the normal is zero.
    [[nodiscard]] std::optional<std::size_t> main_axis(const SightPlane& plane);

    /// Whether points are certainly on one line of space, decided in doubles; false where these cannot tell, and under
    /// every arithmetic but `filtered`.
    [[nodiscard]] bool certainly_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    /// Whether two points are certainly one.
    [[nodiscard]] bool certainly_equal(std::uint32_t a, std::uint32_t b) const;

    /// Whether x is at the viewpoint.
    [[nodiscard]] bool is_here(std::uint32_t x);

    [[nodiscard]] const Vector3& exact(std::uint32_t x);
    [[nodiscard]] Rational exact_weight(std::uint32_t x) const;
    [[nodiscard]] Rational exact_side(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return determinant(exact(b), exact(a), exact(c));
    }
    [[nodiscard]] Rational exact_height(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                        std::uint32_t x);
    [[nodiscard]] Rational exact_minor(std::uint32_t a, std::uint32_t b, std::size_t k);
    [[nodiscard]] const std::array<double, 3>& rounded(std::uint32_t x) const { return r_[x]; }
    /// Bounds of the error of rounded(), divided by 2^-53.
    [[nodiscard]] const std::array<double, 3>& size(std::uint32_t x) const { return size_[x]; }

    /// A corner point of the cone, rounded.
    [[nodiscard]] Point3 corner(std::uint32_t x) const {
        return approx_point(corners_[x - vertices_]);
    }

    [[nodiscard]] Arithmetic arithmetic() const noexcept { return arithmetic_; }
    void count(Predicate predicate, Tier tier) {
        if (tally_ != nullptr) tally_->add(predicate, tier);
    }

private:
    void make_map();
    void round_points(std::span<const RationalPoint3> corners);
    [[nodiscard]] Vector3 exact_vector(const RationalPoint3& x) const;
    [[nodiscard]] Sign undecided_side(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    [[nodiscard]] std::optional<Sign> interval_side(std::uint32_t a, std::uint32_t b,
                                                    std::uint32_t c) const;

    const PlacedScene& scene_;
    Viewpoint3 from_;
    Arithmetic arithmetic_;
    Tally* tally_;
    std::uint32_t vertices_;
    std::vector<RationalPoint3> corners_;
    // r(x) = factor_ (map_ x + shift_) exactly; the same in enclosures, without the factor.
    std::array<Vector3, 3> map_;
    Vector3 shift_;
    Rational factor_;
    std::array<std::array<Interval, 4>, 3> enclosed_;
    std::vector<std::array<double, 3>> r_;
    std::vector<std::array<double, 3>> size_;
    std::vector<std::optional<Vector3>> exact_;
};

}  // namespace sightline::detail
