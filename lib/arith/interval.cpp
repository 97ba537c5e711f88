// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace sightline {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// -1, 0, 1 as x is below, at or above the double d, which may be infinite.
int compare(const Rational& x, double d) {
    if (std::isinf(d)) return d > 0 ? -1 : 1;
    const auto order = x <=> Rational(d);
    return order < 0 ? -1 : order > 0 ? 1 : 0;
}

}  // namespace

bool Interval::contains(const Rational& x) const {
    return compare(x, lower) >= 0 && compare(x, upper) <= 0;
}

double Interval::approx_middle() const noexcept {
    if (std::isinf(lower) || std::isinf(upper)) {
        return std::isfinite(lower) ? lower : std::isfinite(upper) ? upper : 0;
    }
    return std::clamp(lower / 2 + upper / 2, lower, upper);
}

std::ostream& operator<<(std::ostream& out, const Interval& x) {
    const auto precision = out.precision(std::numeric_limits<double>::max_digits10);
    out << '[' << x.lower << ", " << x.upper << ']';
    out.precision(precision);
    return out;
}

Interval enclosure(const Rational& x) {
    const double nearest = x.approx_double();
    const int side = compare(x, nearest);
    if (side == 0) return {nearest, nearest};
    if (side > 0) return {nearest, std::nextafter(nearest, infinity)};
    return {std::nextafter(nearest, -infinity), nearest};
}

}  // namespace sightline
