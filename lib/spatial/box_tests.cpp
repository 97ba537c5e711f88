// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/box_tests.hpp"

#include <algorithm>

#include "arith/interval_cgal.hpp"
#include "spatial/separation.hpp"

namespace sightline {
namespace {

using detail::half_difference;
using detail::IntervalNumber;
using detail::Normal3;
using detail::product_above;
using detail::product_below;
using detail::proposed_normal;
using detail::RoundingUp;
using detail::scaled_normal;

using Vector = std::array<IntervalNumber, 3>;

IntervalNumber number(const Interval& x) { return {x.lower, x.upper}; }
Vector numbers(const std::array<Interval, 3>& v) {
    return {number(v[0]), number(v[1]), number(v[2])};
}
Vector exactly(const Point3& p) { return {p.x, p.y, p.z}; }
Vector range(const Box3& box) {
    return {number({box.low[0], box.high[0]}), number({box.low[1], box.high[1]}),
            number({box.low[2], box.high[2]})};
}

// NaN, from infinities, may be anything.
bool may_vanish(const IntervalNumber& x) { return !(x.inf() > 0) && !(x.sup() < 0); }

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector negated(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
IntervalNumber dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The cone of one half of a wedge, against a box seen from its apex.
struct HalfWedge {
    Vector a;
    Vector b;

    // Whether n·x <= 0 for the half wedge and n·x > 0 for the box; n is a real vector in the intervals
    // for which the first has been shown.
    static bool keeps_out(const Vector& n, const Vector& box) { return dot(n, box).inf() > 0; }

    // For directions whose product with a is exactly zero: oriented by b.
    static bool separates(const Vector& n, const Vector& other, const Vector& box) {
        const IntervalNumber side = dot(n, other);
        return (side.sup() <= 0 && keeps_out(n, box)) ||
               (side.inf() >= 0 && keeps_out(negated(n), box));
    }

    [[nodiscard]] bool may_meet(const Vector& box) const {
        const Vector normal = cross(a, b);
        if (!may_vanish(dot(normal, box))) return false;
        if (separates(cross(normal, a), b, box) || separates(cross(normal, b), a, box)) {
            return false;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vector e{0.0, 0.0, 0.0};
            e[axis] = IntervalNumber(1.0);
            if (separates(cross(a, e), b, box) || separates(cross(b, e), a, box)) return false;
            // The box's own directions: all of the cone on one side of a coordinate plane.
            if (a[axis].sup() <= 0 && b[axis].sup() <= 0 && box[axis].inf() > 0) return false;
            if (a[axis].inf() >= 0 && b[axis].inf() >= 0 && box[axis].sup() < 0) return false;
        }
        return true;
    }
};

// Not inlined, so that no double operation strays into the scopes that round upward.

[[gnu::noinline]] bool plane_may_meet(const Box3& box, const PlaneBounds3& plane) {
    const RoundingUp scope;
    return may_vanish(dot(numbers(plane.normal), range(box)) - number(plane.offset));
}

[[gnu::noinline]] bool line_may_meet(const Box3& box, const LineBounds3& line) {
    const RoundingUp scope;
    // Component i of x × d - m, which is zero on the line, has no x of axis i.
    const Vector d = numbers(line.direction);
    const Vector m = numbers(line.moment);
    const Vector off = minus(cross(range(box), d), m);
    return may_vanish(off[0]) && may_vanish(off[1]) && may_vanish(off[2]);
}

[[gnu::noinline]] bool wedge_may_meet(const Box3& box, const Wedge3& wedge) {
    const RoundingUp scope;
    const Vector apex = exactly(wedge.apex);
    const Vector x = minus(range(box), apex);
    const HalfWedge front{minus(exactly(wedge.a), apex), minus(exactly(wedge.b), apex)};
    const HalfWedge back{negated(front.a), negated(front.b)};
    return front.may_meet(x) || back.may_meet(x);
}

[[gnu::noinline]] bool quadric_may_meet(const Box3& box, const Point3& middle,
                                        const QuadricBounds3& quadric) {
    const RoundingUp scope;
    const Vector square = numbers(quadric.square);
    const Vector mixed = numbers(quadric.mixed);
    const Vector linear = numbers(quadric.linear);
    const Vector c = exactly(middle);
    const Vector h = minus(range(box), c);
    // f(c + h) = f(c) + Σ hᵢ ∂ᵢf(c) + the quadratic part at h.
    IntervalNumber value = number(quadric.constant);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        value += square[i] * CGAL::square(c[i]) + mixed[i] * c[j] * c[k] + linear[i] * c[i];
        const IntervalNumber slope =
            IntervalNumber(2.0) * square[i] * c[i] + mixed[j] * c[k] + mixed[k] * c[j] + linear[i];
        value += slope * h[i] + square[i] * CGAL::square(h[i]) + mixed[i] * h[j] * h[k];
    }
    return may_vanish(value);
}

bool separates(const Normal3& n, const Box3& box, const std::array<Point3, 3>& points) {
    const Point3 nearest{n[0] > 0 ? box.low[0] : box.high[0], n[1] > 0 ? box.low[1] : box.high[1],
                         n[2] > 0 ? box.low[2] : box.high[2]};
    const double low = product_below(n, nearest);
    return std::all_of(points.begin(), points.end(),
                       [&](const Point3& p) { return product_above(n, p) < low; });
}

bool separates_either_way(const Normal3& n, const Box3& box, const std::array<Point3, 3>& points) {
    return separates(n, box, points) || separates({-n[0], -n[1], -n[2]}, box, points);
}

}  // namespace

bool may_meet(const Box3& box, const PlaneBounds3& plane) { return plane_may_meet(box, plane); }

bool may_meet(const Box3& box, const LineBounds3& line) { return line_may_meet(box, line); }

bool may_meet(const Box3& box, const Point3& a, const Point3& b, const Point3& c) {
    if (!box.meets(Box3::of(a, b, c))) return false;
    const std::array<Point3, 3> points{a, b, c};
    const std::array<Normal3, 3> edges{half_difference(b, a), half_difference(c, b),
                                       half_difference(a, c)};
    if (separates_either_way(proposed_normal(edges[0], edges[1]), box, points)) return false;
    for (const Normal3& d : edges) {
        const std::array<Normal3, 3> across{Normal3{0, d[2], -d[1]}, Normal3{-d[2], 0, d[0]},
                                            Normal3{d[1], -d[0], 0}};
        for (const Normal3& n : across) {
            if (separates_either_way(scaled_normal(n), box, points)) return false;
        }
    }
    return true;
}

bool may_meet(const Box3& box, const Wedge3& wedge) { return wedge_may_meet(box, wedge); }

bool may_meet(const Box3& box, const QuadricBounds3& quadric) {
    const Point3 middle{box.low[0] / 2 + box.high[0] / 2, box.low[1] / 2 + box.high[1] / 2,
                        box.low[2] / 2 + box.high[2] / 2};
    return quadric_may_meet(box, middle, quadric);
}

}  // namespace sightline
