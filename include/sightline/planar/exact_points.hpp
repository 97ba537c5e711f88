// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/planar/visibility_polygon.hpp"

namespace sightline {

/// The exact coordinates of a visibility polygon's vertices, as fractions that are not reduced, so that
/// a vertex costs a few integer products. Vertex i of the ring is
///
///   (origin.x + step · x/w, origin.y + step · y/w),   w ≠ 0;   or the direction (x, y) when w == 0.
///
/// Fractions of 128 bits exist where the scene lies on a grid of s bits (at most 26) and the viewpoint on
/// one that is finer by at most 123 − 3 s bits; elsewhere the coordinates are kept as rational numbers.
class ExactPoints {
public:
    __extension__ using Integer = __int128;
    struct Fraction {
        Integer x = 0;
        Integer y = 0;
        Integer w = 1;
    };

    ExactPoints() = default;
    ExactPoints(const Point2& origin, double step, std::vector<Fraction> fractions)
        : origin_(origin), step_(step), fractions_(std::move(fractions)) {}
    explicit ExactPoints(std::vector<ViewPoint> rationals) : rationals_(std::move(rationals)) {}

    [[nodiscard]] std::size_t size() const noexcept {
        return fractions_.size() + rationals_.size();
    }
    /// Whether `fractions` hold the coordinates.
    [[nodiscard]] bool is_fractions() const noexcept { return rationals_.empty(); }
    [[nodiscard]] const std::vector<Fraction>& fractions() const noexcept { return fractions_; }
    [[nodiscard]] const Point2& origin() const noexcept { return origin_; }
    [[nodiscard]] double step() const noexcept { return step_; }
    /// Vertex i with reduced rational coordinates (a direction's scale is arbitrary but for infinity's
    /// canonical one: the larger of |x| and |y| is 1). Cost: rational arithmetic.
    [[nodiscard]] ViewPoint operator[](std::size_t i) const;

private:
    Point2 origin_;
    double step_ = 1;
    std::vector<Fraction> fractions_;
    std::vector<ViewPoint> rationals_;
};

}  // namespace sightline
