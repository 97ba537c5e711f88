// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The composite planar predicates, each written once over a kernel and over the kinds of points
/// (Point2, ImplicitPoint2, EnclosedPoint2). Private.
///
/// A kernel has   Sign sign(Predicate counted_as, f)   for a ProductDifference<double> or a generic
/// lambda that evaluates a polynomial. Kernel2<arithmetic, Counter> fixes the arithmetic at compile
/// time, for loops; RunTimeKernel2 chooses it at run time.

#include <algorithm>
#include <concepts>

#include "geom/enclosed_point2.hpp"
#include "geom/orientation_tiers.hpp"
#include "geom/polynomial_sign.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/polygon2.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

/// Counts nothing and costs nothing.
struct NotCounted {
    void add(Predicate, Tier) const noexcept {}
};

/// Counts in a tally that outlives the kernel.
struct CountedIn {
    Tally* tally;
    void add(Predicate predicate, Tier tier) const noexcept { tally->add(predicate, tier); }
};

/// A kernel with its arithmetic fixed; `Counter` is NotCounted or CountedIn.
template <Arithmetic arithmetic, typename Counter = NotCounted>
struct Kernel2 {
    [[no_unique_address]] Counter counter{};

    [[nodiscard]] Sign sign(Predicate predicate, const ProductDifference<double>& f) const {
        return counted(predicate, sign_by<arithmetic>(f));
    }
    template <typename Evaluate>
    [[nodiscard]] Sign sign(Predicate predicate, const Evaluate& evaluate) const {
        return counted(predicate, polynomial_sign(arithmetic, evaluate));
    }

private:
    [[nodiscard]] Sign counted(Predicate predicate, const CertifiedSign& result) const {
        counter.add(predicate, result.decided_by);
        return result.sign;
    }
};

/// A kernel with its arithmetic chosen at run time; counts when there is a tally.
struct RunTimeKernel2 {
    Arithmetic arithmetic = Arithmetic::filtered;
    Tally* tally = nullptr;

    [[nodiscard]] Sign sign(Predicate predicate, const ProductDifference<double>& f) const {
        return counted(predicate,
                       with_arithmetic(arithmetic, [&](auto a) { return sign_by<a()>(f); }));
    }
    template <typename Evaluate>
    [[nodiscard]] Sign sign(Predicate predicate, const Evaluate& evaluate) const {
        return counted(predicate, polynomial_sign(arithmetic, evaluate));
    }

private:
    [[nodiscard]] Sign counted(Predicate predicate, const CertifiedSign& result) const {
        if (tally != nullptr) tally->add(predicate, result.decided_by);
        return result.sign;
    }
};

template <typename... Points>
concept AllInput = (std::same_as<Points, Point2> && ...);

/// Sign of (b - a) × (c - a), for points of any kind.
template <typename Kernel, typename A, typename B, typename C>
[[nodiscard]] Sign turn_in(const Kernel& kernel, Predicate counted_as, const A& a, const B& b,
                           const C& c) {
    if constexpr (AllInput<A, B, C>) {
        return kernel.sign(counted_as, orientation_polynomial<double>(a, b, c));
    } else {
        return kernel.sign(counted_as, [&]<typename Number>() -> Number {
            return homogeneous_orientation<Number>(a, b, c);
        });
    }
}

/// Sign of (b - a) · (q - p), for points of any kind.
template <typename Kernel, typename A, typename B, typename P, typename Q>
[[nodiscard]] Sign advance_in(const Kernel& kernel, Predicate counted_as, const A& a, const B& b,
                              const P& p, const Q& q) {
    if constexpr (AllInput<A, B, P, Q>) {
        return kernel.sign(counted_as, dot_polynomial<double>(a, b, p, q));
    } else {
        return kernel.sign(counted_as, [&]<typename Number>() -> Number {
            return homogeneous_dot<Number>(a, b, p, q);
        });
    }
}

template <typename... Points>
inline constexpr Predicate constructed_or(Predicate input) {
    return (std::same_as<Points, ImplicitPoint2> || ...) ? Predicate::constructed_order2 : input;
}

template <typename Kernel, typename A, typename B, typename C>
[[nodiscard]] Sign orientation_in(const Kernel& kernel, const A& a, const B& b, const C& c) {
    return turn_in(kernel, constructed_or<A, B, C>(Predicate::orientation2), a, b, c);
}

template <typename Kernel, typename A, typename B, typename P, typename Q>
[[nodiscard]] Sign order_along_in(const Kernel& kernel, const A& a, const B& b, const P& p,
                                  const Q& q) {
    return advance_in(kernel, constructed_or<A, B, P, Q>(Predicate::order_along_line2), a, b, q, p);
}

/// Lexicographic order of the places of two points, x first.
template <typename Kernel, typename P, typename Q>
[[nodiscard]] Sign compare_xy_in(const Kernel& kernel, const P& p, const Q& q) {
    const Sign x = kernel.sign(Predicate::constructed_order2, [&]<typename Number>() -> Number {
        return homogeneous_difference<Number>(p, q).first;
    });
    if (x != Sign::zero) return x;
    return kernel.sign(Predicate::constructed_order2, [&]<typename Number>() -> Number {
        return homogeneous_difference<Number>(p, q).second;
    });
}

// 0 for directions from the reference up to, not including, its opposite; 1 for the rest.
template <typename Kernel, typename Center>
[[nodiscard]] int half_turn_in(const Kernel& kernel, const Center& center, const Point2& reference,
                               const Point2& p) {
    constexpr auto counted_as = Predicate::order_of_directions2;
    const Sign side = turn_in(kernel, counted_as, center, reference, p);
    if (side != Sign::zero) return side == Sign::positive ? 0 : 1;
    return advance_in(kernel, counted_as, center, reference, center, p) == Sign::positive ? 0 : 1;
}

template <typename Kernel, typename Center>
[[nodiscard]] Sign order_of_directions_in(const Kernel& kernel, const Center& center,
                                          const Point2& reference, const Point2& p,
                                          const Point2& q) {
    const int p_half = half_turn_in(kernel, center, reference, p);
    const int q_half = half_turn_in(kernel, center, reference, q);
    if (p_half != q_half) return p_half < q_half ? Sign::negative : Sign::positive;
    return turn_in(kernel, Predicate::order_of_directions2, center, q, p);
}

template <typename Kernel, typename Center>
[[nodiscard]] bool is_same_direction_in(const Kernel& kernel, const Center& center, const Point2& p,
                                        const Point2& q) {
    constexpr auto counted_as = Predicate::order_of_directions2;
    return turn_in(kernel, counted_as, center, p, q) == Sign::zero &&
           advance_in(kernel, counted_as, center, p, center, q) == Sign::positive;
}

template <typename Kernel, typename Center>
[[nodiscard]] ConePosition cone_position_in(const Kernel& kernel, const Center& apex,
                                            const Point2& first, const Point2& second,
                                            const Point2& p) {
    if (is_at(apex, p)) return ConePosition::at_apex;
    if (is_same_direction_in(kernel, apex, first, p)) return ConePosition::on_first;
    if (is_same_direction_in(kernel, apex, first, second)) return ConePosition::inside;
    switch (order_of_directions_in(kernel, apex, first, p, second)) {
        case Sign::negative:
            return ConePosition::inside;
        case Sign::zero:
            return ConePosition::on_second;
        case Sign::positive:
            break;
    }
    return ConePosition::outside;
}

/// Whether p lies on the closed segment.
template <typename Kernel>
[[nodiscard]] bool is_on_in(const Kernel& kernel, const Segment2& s, const Point2& p) {
    const bool in_box =
        std::min(s.source.x, s.target.x) <= p.x && p.x <= std::max(s.source.x, s.target.x) &&
        std::min(s.source.y, s.target.y) <= p.y && p.y <= std::max(s.source.y, s.target.y);
    return in_box && orientation_in(kernel, s.source, s.target, p) == Sign::zero;
}

// For collinear points coordinates compare like places, so no arithmetic is left to do.
[[nodiscard]] SegmentCrossing collinear_crossing(const Segment2& s, const Segment2& t);

// What remains when the segments do not cross properly and do not lie on one line.
template <typename Kernel>
[[nodiscard]] SegmentCrossing touch_in(const Kernel& kernel, const Segment2& s, const Segment2& t) {
    if (s.source == t.source || s.source == t.target || s.target == t.source ||
        s.target == t.target) {
        return SegmentCrossing::end_to_end;
    }
    if (is_on_in(kernel, t, s.source) || is_on_in(kernel, t, s.target)) {
        return SegmentCrossing::first_ends_inside_second;
    }
    if (is_on_in(kernel, s, t.source) || is_on_in(kernel, s, t.target)) {
        return SegmentCrossing::second_ends_inside_first;
    }
    return SegmentCrossing::none;
}

template <typename Kernel>
[[nodiscard]] SegmentCrossing crossing_in(const Kernel& kernel, const Segment2& s,
                                          const Segment2& t) {
    const auto disjoint = [](double a, double b, double c, double d) {
        return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
    };
    if (disjoint(s.source.x, s.target.x, t.source.x, t.target.x) ||
        disjoint(s.source.y, s.target.y, t.source.y, t.target.y)) {
        return SegmentCrossing::none;
    }
    const Sign t0 = orientation_in(kernel, s.source, s.target, t.source);
    const Sign t1 = orientation_in(kernel, s.source, s.target, t.target);
    if (t0 * t1 == Sign::positive) return SegmentCrossing::none;
    const Sign s0 = orientation_in(kernel, t.source, t.target, s.source);
    const Sign s1 = orientation_in(kernel, t.source, t.target, s.target);
    if (s0 * s1 == Sign::positive) return SegmentCrossing::none;
    if (t0 * t1 == Sign::negative && s0 * s1 == Sign::negative) return SegmentCrossing::proper;
    const bool all_zero =
        t0 == Sign::zero && t1 == Sign::zero && s0 == Sign::zero && s1 == Sign::zero;
    return all_zero ? collinear_crossing(s, t) : touch_in(kernel, s, t);
}

}  // namespace sightline::detail
