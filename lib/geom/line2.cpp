// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/line2.hpp"

#include "geom/product_difference.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {

Sign turn(const Line2& l, const Line2& m) {
    return detail::certified_sign(
               detail::cross_polynomial<double>(l.source, l.target, m.source, m.target))
        .sign;
}

bool is_same_line(const Line2& l, const Line2& m) {
    return orientation(l.source, l.target, m.source) == Sign::zero &&
           orientation(l.source, l.target, m.target) == Sign::zero;
}

std::ostream& operator<<(std::ostream& out, const Line2& line) {
    return out << line.source << " -> " << line.target;
}

std::ostream& operator<<(std::ostream& out, const ImplicitPoint2& p) {
    return out << '(' << p.first_ << ") x (" << p.second_ << ')';
}

std::optional<ImplicitPoint2> intersection(const Line2& l, const Line2& m) {
    switch (turn(l, m)) {
        case Sign::positive:
            return ImplicitPoint2(l, m);
        case Sign::negative:
            return ImplicitPoint2(l, reversed(m));
        case Sign::zero:
            break;
    }
    return std::nullopt;
}

RationalPoint2 to_rational(const ImplicitPoint2& p) {
    const auto h = detail::homogeneous<Rational>(p, p.first().source);
    return {Rational(p.first().source.x) + h.x / h.w, Rational(p.first().source.y) + h.y / h.w};
}

Point2 approx_point(const ImplicitPoint2& p) { return approx_point(to_rational(p)); }

}  // namespace sightline
