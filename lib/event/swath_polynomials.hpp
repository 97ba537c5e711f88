// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The lines that meet three lines, as polynomials in the place on the first. Private.

#include "sightline/geom/plucker.hpp"

namespace sightline::detail {

/// c0 + c1 t + c2 t².
template <typename Value>
struct Quadratic {
    Value c0;
    Value c1;
    Value c2;
};

/// The plane through p(t) = a + t u and a line (d, m): normal and offset, linear in t.
template <typename Number>
struct MovingPlane {
    BasicVector3<Number> n0, n1;
    Number k0, k1;
};

template <typename Number>
[[nodiscard]] MovingPlane<Number> moving_plane(const BasicVector3<Number>& a,
                                               const BasicVector3<Number>& u,
                                               const BasicLine3<Number>& line) {
    return {line.m - cross(a, line.d), -cross(u, line.d), dot(a, line.m), dot(u, line.m)};
}

/// L(t): the line through p(t) that meets two other lines. Its direction vanishes nowhere when the
/// three lines are pairwise skew.
template <typename Number>
struct Swath {
    Quadratic<BasicVector3<Number>> d;
    Quadratic<BasicVector3<Number>> m;
};

template <typename Number>
[[nodiscard]] Swath<Number> swath(const MovingPlane<Number>& p, const MovingPlane<Number>& q) {
    const auto moment = [](const Number& k, const BasicVector3<Number>& n, const Number& j,
                           const BasicVector3<Number>& o) { return k * n - j * o; };
    return {{cross(p.n0, q.n0), cross(p.n0, q.n1) + cross(p.n1, q.n0), cross(p.n1, q.n1)},
            {moment(q.k0, p.n0, p.k0, q.n0),
             moment(q.k0, p.n1, p.k0, q.n1) + moment(q.k1, p.n0, p.k1, q.n0),
             moment(q.k1, p.n1, p.k1, q.n1)}};
}

/// The side of L(t) to a line: zero where it meets that as well.
template <typename Number>
[[nodiscard]] Quadratic<Number> side_polynomial(const Swath<Number>& s,
                                                const BasicLine3<Number>& line) {
    const auto side_of = [&](const BasicVector3<Number>& d, const BasicVector3<Number>& m) {
        return dot(d, line.m) + dot(m, line.d);
    };
    return {side_of(s.d.c0, s.m.c0), side_of(s.d.c1, s.m.c1), side_of(s.d.c2, s.m.c2)};
}

/// L(t) for a rational t.
[[nodiscard]] inline RationalLine3 line_at(const Swath<Rational>& s, const Rational& t) {
    const auto value = [&](const Quadratic<Vector3>& f) { return f.c0 + t * f.c1 + t * t * f.c2; };
    return {value(s.d), value(s.m)};
}

}  // namespace sightline::detail
