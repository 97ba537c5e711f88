// SPDX-License-Identifier: GPL-3.0-or-later
// Points and lines of a small grid, where everything degenerate is common.
#pragma once

#include <rapidcheck.h>

#include "geom/points3.hpp"
#include "sightline/geom/plucker.hpp"

namespace sightline::testing {

inline RationalPoint3 any_point3(int size = 4) { return to_rational(*grid_points3(size)); }

inline RationalLine3 any_line3(int size = 4) {
    const RationalPoint3 p = any_point3(size);
    RationalPoint3 q = p;
    while (q == p) q = any_point3(size);
    return line_through(p, q);
}

inline Rational any_parameter() { return {*rc::gen::inRange(-9, 10), *rc::gen::inRange(1, 5)}; }

/// A point of a line that is given by two.
inline RationalPoint3 point_at(const RationalPoint3& p, const RationalPoint3& q,
                               const Rational& t) {
    return p + t * (q - p);
}

inline bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

}  // namespace sightline::testing
