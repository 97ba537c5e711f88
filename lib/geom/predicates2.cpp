// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/predicates2.hpp"

#include "arith/interval_cgal.hpp"
#include "geom/orientation_tiers.hpp"
#include "geom/polynomials.hpp"

namespace sightline {

namespace detail {

CertifiedSign orientation_after_filter(const Point2& a, const Point2& b, const Point2& c) {
    return sign_after_filter(orientation_polynomial<double>(a, b, c));
}

}  // namespace detail

Sign orientation(const Point2& a, const Point2& b, const Point2& c) {
    return detail::orientation(a, b, c).sign;
}

Sign orientation(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
    return detail::orientation_polynomial<Rational>(a, b, c).value().sign();
}

Sign orientation(const Point2& a, const Point2& b, const RationalPoint2& c) {
    return orientation(to_rational(a), to_rational(b), c);
}

}  // namespace sightline
