// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The sign of any polynomial under any arithmetic. Private.
///
/// `evaluate` is a generic lambda []<typename Number>() -> Number that evaluates the polynomial.

#include <optional>

#include "arith/interval_cgal.hpp"
#include "geom/error_bounded.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline::detail {

// Not inlined, so that no double operation strays into the scope that rounds upward.
template <typename Evaluate>
[[gnu::noinline]] std::optional<Sign> interval_sign_of(const Evaluate& evaluate) {
    const RoundingUp scope;
    return certain_sign(evaluate.template operator()<IntervalNumber>());
}

template <typename Evaluate>
[[nodiscard]] Sign exact_sign_of(const Evaluate& evaluate) {
    return evaluate.template operator()<Rational>().sign();
}

/// The sign of the polynomial, and the tier that decided it. Inputs are finite doubles.
template <typename Evaluate>
[[nodiscard]] CertifiedSign polynomial_sign(Arithmetic arithmetic, const Evaluate& evaluate) {
    switch (arithmetic) {
        case Arithmetic::filtered:
            if (const auto sign = evaluate.template operator()<ErrorBounded>().sign()) {
                return {*sign, Tier::filter};
            }
            if (const auto sign = interval_sign_of(evaluate)) return {*sign, Tier::interval};
            break;
        case Arithmetic::interval:
            if (const auto sign = interval_sign_of(evaluate)) return {*sign, Tier::interval};
            return {};
        case Arithmetic::double_:
            return { sign_of(evaluate.template operator()<double>()), Tier::filter };
        case Arithmetic::exact:
            break;
    }
    return {exact_sign_of(evaluate), Tier::exact};
}

}  // namespace sightline::detail
