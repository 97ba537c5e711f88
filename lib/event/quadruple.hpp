// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which lines through three segments meet a fourth, each polynomial written once for any number
/// type. Private. triple.hpp says how lines are parametrised.

#include <array>
#include <optional>
#include <tuple>

#include "event/triple.hpp"

namespace sightline::detail {

/// (1-t)² q0 + t (1-t) q1 + t² q2.
template <typename Number>
struct BernsteinQuadratic {
    Number q0;
    Number q1;
    Number q2;

    /// The value at n/d, times d².
    [[nodiscard]] Number at(const Fraction<Number>& t) const {
        const Number rest = t.d - t.n;
        return rest * rest * q0 + rest * t.n * q1 + t.n * t.n * q2;
    }
    /// The derivative at n/d, times d.
    [[nodiscard]] Number slope_at(const Fraction<Number>& t) const {
        return (t.d - t.n) * (q1 - (q0 + q0)) + t.n * ((q2 + q2) - q1);
    }
    [[nodiscard]] Number leading() const { return q0 - q1 + q2; }
    [[nodiscard]] Number discriminant() const {
        const Number product = q0 * q2;
        return q1 * q1 - (product + product + product + product);
    }
};

template <typename Number>
[[nodiscard]] BernsteinQuadratic<Number> quadratic_of(const TripleOfSegments<Number>& k,
                                                      const TripleOfSegments<Number>& l) {
    const auto& [a, b] = std::tie(k.from_source, k.from_target);
    const auto& [c, d] = std::tie(l.from_source, l.from_target);
    return {a.at0 * d.at0 - b.at0 * c.at0,
            a.at0 * d.at1 + a.at1 * d.at0 - b.at0 * c.at1 - b.at1 * c.at0,
            a.at1 * d.at1 - b.at1 * c.at1};
}

/// Which of the two lines that meet the carriers meet the segments.
struct QuadrupleHits {
    bool smaller = false;        ///< that of the smaller t
    bool larger = false;         ///< that of the larger
    bool is_only = false;        ///< both are one, or one does not meet the first carrier
    bool needs_general = false;  ///< a family, or a case to be left to the general solution
    bool is_certain = true;

    [[nodiscard]] bool any() const noexcept { return smaller || larger; }
};

/// Counts roots of a quadratic in closed ranges of t.
template <typename Number>
class RootCounter {
public:
    RootCounter(const TripleOfSegments<Number>& k, const TripleOfSegments<Number>& l)
        : k_(k), l_(l) {}

    QuadrupleHits count() {
        for (int i = 0; i < k_.range_count && hits_.is_certain; ++i) {
            for (int j = 0; j < l_.range_count && hits_.is_certain; ++j) {
                meet(k_.ranges[i], l_.ranges[j]);
            }
        }
        return hits_;
    }
    /// Valid when there was a hit.
    [[nodiscard]] const BernsteinQuadratic<Number>& quadratic() const { return q_; }

private:
    void meet(const FractionRange<Number>& r, const FractionRange<Number>& s) {
        const auto is_before = [&](const Fraction<Number>& p, const Fraction<Number>& q) {
            return is_less(p, q, signs_);
        };
        if (is_before(s.high, r.low) || is_before(r.high, s.low)) return update();
        const Fraction<Number>& low = is_before(r.low, s.low) ? s.low : r.low;
        const Fraction<Number>& high = is_before(s.high, r.high) ? s.high : r.high;
        if (signs_.are_certain()) find_roots(low, high);
        update();
    }
    void update() { hits_.is_certain = signs_.are_certain(); }

    void find_roots(const Fraction<Number>& low, const Fraction<Number>& high) {
        if (!has_quadratic_) q_ = quadratic_of(k_, l_);
        has_quadratic_ = true;
        const Sign at_low = signs_(q_.at(low));
        const Sign at_high = signs_(q_.at(high));
        if (!signs_.are_certain()) return;
        if (at_low * at_high == Sign::positive) {
            find_inner(at_low, low, high);
        } else if (at_low * at_high == Sign::negative) {
            add_crossing(at_high);
        } else {
            find_at_ends(at_low, at_high, low, high);
        }
    }
    // Of two roots between equal signs, one needs a slope toward zero at both ends.
    void find_inner(Sign sign, const Fraction<Number>& low, const Fraction<Number>& high) {
        if (signs_(q_.slope_at(low)) * sign != Sign::negative) return;
        if (signs_(q_.slope_at(high)) * sign != Sign::positive) return;
        const Sign discriminant = signs_(q_.discriminant());
        if (discriminant == Sign::negative) return;
        hits_.smaller = hits_.larger = true;
        hits_.is_only = discriminant == Sign::zero;
    }
    // The root where the sign becomes `after`.
    void add_crossing(Sign after) {
        const Sign leading = signs_(q_.leading());
        if (leading == Sign::zero) hits_.is_only = hits_.needs_general = true;
        (leading == after ? hits_.larger : hits_.smaller) = true;
    }
    void find_at_ends(Sign at_low, Sign at_high, const Fraction<Number>& low,
                      const Fraction<Number>& high) {
        const Sign leading = signs_(q_.leading());
        const Sign after_low = signs_(q_.slope_at(low));
        const Sign before_high = signs_(q_.slope_at(high));
        if (leading == Sign::zero) {
            hits_.needs_general = true;
            return;
        }
        const bool is_point = !is_less(low, high, signs_);
        const Sign slope = at_low == Sign::zero ? after_low : before_high;
        if (slope == Sign::zero) {
            hits_.smaller = hits_.larger = hits_.is_only = true;
            return;
        }
        (slope == leading ? hits_.larger : hits_.smaller) = true;
        if (is_point) return;
        const bool is_other_inside = at_low == Sign::zero
                                         ? at_high == Sign::zero || at_high != after_low
                                         : at_low == before_high;
        if (is_other_inside) hits_.smaller = hits_.larger = true;
    }

    const TripleOfSegments<Number>& k_;
    const TripleOfSegments<Number>& l_;
    BernsteinQuadratic<Number> q_{};
    bool has_quadratic_ = false;
    QuadrupleHits hits_;
    Signs signs_;
};

/// Whether the line of the smaller t comes first in the order of scaled Plücker vectors. Empty when
/// that is not certain, or is not decided by the first two coordinates.
template <typename Number>
[[nodiscard]] std::optional<bool> smaller_is_first(const Ends<Number>& i, const Ends<Number>& j,
                                                   const TripleOfSegments<Number>& k,
                                                   const BernsteinQuadratic<Number>& q) {
    // The direction is D(t) = h (p_j(0) - p_i(t)) + h(t, 0) (p_j(1) - p_j(0)), h = h(t, 0) - h(t, 1).
    const Number h0 = k.from_source.at0 - k.from_target.at0;
    const Number h1 = k.from_source.at1 - k.from_target.at1 - h0;
    const Number g0 = k.from_source.at0;
    const Number g1 = k.from_source.at1 - g0;
    const auto coefficients = [&](const Number& w, const Number& u, const Number& v) {
        return std::array<Number, 3>{h0 * w + g0 * v, h1 * w - h0 * u + g1 * v,
                                     Number(0.0) - h1 * u};
    };
    const auto w = j.source - i.source, u = i.target - i.source, v = j.target - j.source;
    const auto x = coefficients(w.x, u.x, v.x);
    const auto y = coefficients(w.y, u.y, v.y);
    const Number c0 = q.q0, c1 = q.q1 - (q.q0 + q.q0), c2 = q.leading();
    const auto minor = [&](int m, int n) { return y[m] * x[n] - x[m] * y[n]; };
    // y/x at the smaller root less that at the larger, up to squares: symmetric in the roots, whose
    // sum is -c1/c2 and whose product is c0/c2.
    const Number slope = c2 * minor(1, 0) - c1 * minor(2, 0) + c0 * minor(2, 1);
    const Number product = c2 * c2 * x[0] * x[0] - c2 * c1 * x[0] * x[1] + c2 * c0 * x[1] * x[1] +
                           x[0] * x[2] * (c1 * c1 - (c0 * c2 + c0 * c2)) - c1 * c0 * x[1] * x[2] +
                           c0 * c0 * x[2] * x[2];
    Signs signs;
    const Sign order = signs(slope) * signs(c2) * signs(product);
    if (!signs.are_certain() || order == Sign::zero) return std::nullopt;
    return order == Sign::positive;
}

}  // namespace sightline::detail
