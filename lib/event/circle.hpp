// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sets of parameters on the projective line, bounded by rational points. Private.

#include <vector>

#include "sightline/arith/rational.hpp"

namespace sightline::detail {

/// A point x:y of the projective line; finite ones have y == 1, the one at infinity is 1:0.
struct CirclePoint {
    Rational x;
    Rational y;

    friend bool operator==(const CirclePoint&, const CirclePoint&) = default;
};

/// p·x + q·y.
struct LinearForm {
    Rational p;
    Rational q;

    [[nodiscard]] Sign sign_at(const CirclePoint& at) const { return (p * at.x + q * at.y).sign(); }
    [[nodiscard]] bool is_zero() const { return p.sign() == Sign::zero && q.sign() == Sign::zero; }
};

/// f·g <= 0, or f ≠ 0 where there is no g.
struct CircleConstraint {
    LinearForm f;
    LinearForm g;
    bool is_inequation = false;

    [[nodiscard]] bool holds_at(const CirclePoint& at) const {
        if (is_inequation) return f.sign_at(at) != Sign::zero;
        return f.sign_at(at) * g.sign_at(at) != Sign::positive;
    }
};

/// A piece of the projective line: the points met when one goes upward from `from` through
/// `through` to `to`, where infinity lies between the greatest and the least number.
struct CircleArc {
    CirclePoint from;
    CirclePoint through;
    CirclePoint to;
    bool has_from = true;
    bool has_to = true;
};

/// A closed or open subset: everything, or arcs and single points.
struct CircleSet {
    bool is_all = false;
    std::vector<CircleArc> arcs;
    std::vector<CirclePoint> points;
};

/// The parameters at which all constraints hold.
[[nodiscard]] CircleSet solve(const std::vector<CircleConstraint>& constraints);

/// Pieces of an arc, cut at those of the points that lie inside of it.
[[nodiscard]] std::vector<CircleArc> cut(const CircleArc& arc,
                                         const std::vector<CirclePoint>& points);

/// Pieces of the whole line, cut at points, of which there is at least one.
[[nodiscard]] std::vector<CircleArc> cut_all(const std::vector<CirclePoint>& points);

/// x:y with y == 1 or 1:0. Not both zero.
[[nodiscard]] CirclePoint circle_point(const Rational& x, const Rational& y);

}  // namespace sightline::detail
