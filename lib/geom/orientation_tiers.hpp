// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Orientation of three points tier by tier, for loops that call it millions of times. Private.
///
/// An algorithm is written once as a template on the Arithmetic, calls `orientation_by<A>`, and is
/// entered through `with_arithmetic`; the filter is then inlined into its loop.

#include <optional>
#include <type_traits>
#include <utility>

#include "geom/product_difference.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/sign.hpp"
#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// The double filter: the sign of orientation(a, b, c) when it is certain, else empty.
[[nodiscard]] inline std::optional<Sign> orientation_filter(const Point2& a, const Point2& b,
                                                            const Point2& c) {
    return filtered_sign(orientation_polynomial<double>(a, b, c));
}

/// What follows when the filter has not decided: intervals, then exact numbers. Not inlined.
[[nodiscard]] CertifiedSign orientation_after_filter(const Point2& a, const Point2& b,
                                                     const Point2& c);

/// All tiers in turn.
[[nodiscard]] inline CertifiedSign orientation(const Point2& a, const Point2& b, const Point2& c) {
    if (const auto sign = orientation_filter(a, b, c)) return {*sign, Tier::filter};
    return orientation_after_filter(a, b, c);
}

/// Orientation with a rational point, under an arithmetic chosen at run time. Not inlined.
[[nodiscard]] CertifiedSign orientation_to(Arithmetic arithmetic, const Point2& a, const Point2& b,
                                           const RationalPoint2& c);

/// The sign of a polynomial under an arithmetic fixed at compile time.
template <Arithmetic arithmetic>
[[nodiscard]] inline CertifiedSign sign_by(const ProductDifference<double>& f) {
    if constexpr (arithmetic == Arithmetic::filtered) {
        return certified_sign(f);
    } else if constexpr (arithmetic == Arithmetic::exact) {
        return {exact_sign(f), Tier::exact};
    } else if constexpr (arithmetic == Arithmetic::interval) {
        const auto sign = interval_sign(f);
        return sign ? CertifiedSign{*sign, Tier::interval} : CertifiedSign{};
    } else {
        return {sign_of(f.value()), Tier::filter};
    }
}

/// Orientation under an arithmetic fixed at compile time.
template <Arithmetic arithmetic>
[[nodiscard]] inline CertifiedSign orientation_by(const Point2& a, const Point2& b,
                                                  const Point2& c) {
    if constexpr (arithmetic == Arithmetic::filtered) {
        return detail::orientation(a, b, c);
    } else {
        return sign_by<arithmetic>(orientation_polynomial<double>(a, b, c));
    }
}

/// Calls function(std::integral_constant<Arithmetic, …>) for the arithmetic chosen at run time.
template <typename Function>
decltype(auto) with_arithmetic(Arithmetic arithmetic, Function&& function) {
    using enum Arithmetic;
    switch (arithmetic) {
        case exact:
            return function(std::integral_constant<Arithmetic, exact>{});
        case interval:
            return function(std::integral_constant<Arithmetic, interval>{});
        case double_:
            return function(std::integral_constant<Arithmetic, double_>{});
        case filtered:
            break;
    }
    return function(std::integral_constant<Arithmetic, filtered>{});
}

}  // namespace sightline::detail
