// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The interval arithmetic of the middle tier: CGAL's, the only one here whose rounding-mode
/// handling survives optimisation. Private; any source in lib/ may include it.
///
/// An IntervalNumber may only be computed with while a RoundingUp lives. Within that scope call no
/// library, allocate nothing, start no thread, and compute nothing else with doubles: keep the
/// scope in a function of its own that is not inlined, so that no double operation is moved into
/// it.

#include <CGAL/Interval_nt.h>

#include <optional>

#include "sightline/arith/interval.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline::detail {

using IntervalNumber = CGAL::Interval_nt<false>;
using RoundingUp = IntervalNumber::Protector;

/// The sign of every number in x; empty when they differ or when x is not a number.
[[nodiscard]] inline std::optional<Sign> certain_sign(const IntervalNumber& x) {
    return Interval{x.inf(), x.sup()}.sign();
}

}  // namespace sightline::detail
