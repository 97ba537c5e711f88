// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Segments in every number type, scaled to integers where that is cheap. Private.

#include <cstddef>
#include <span>
#include <vector>

#include "event/quadruple.hpp"
#include "sightline/event/transversals.hpp"

namespace sightline::detail {

/// A common scale changes no line's root and no sign, and integers multiply without division.
struct ScaledSegments {
    explicit ScaledSegments(std::span<const RationalSegment3> segments);

    std::vector<Ends<Rational>> exact;
    std::vector<Ends<ErrorBounded>> bounded;
    std::vector<Ends<double>> rounded;
    std::vector<Ends<Interval>> enclosed;
};

}  // namespace sightline::detail
