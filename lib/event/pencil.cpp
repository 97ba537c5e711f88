// SPDX-License-Identifier: GPL-3.0-or-later
#include "event/pencil.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace sightline::detail {

namespace {

using Kind = TransversalElement::Kind;

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

bool is_line_through(const TransversalElement& element, const RationalPoint3& p) {
    return is_on(element.carrier(), p);
}

// In the plane with normal n: positive when w lies to the left of v.
Rational turn(const Vector3& n, const Vector3& v, const Vector3& w) { return determinant(n, v, w); }

// Of the sum and the difference of two scaled directions, the one that lies on the same side of
// the pair as `sample`.
Vector3 canonical_between(const Vector3& n, const Vector3& from, const Vector3& to,
                          const Vector3& sample) {
    const auto side_of = [&](const Vector3& v) {
        return turn(n, v, from).sign() * turn(n, v, to).sign();
    };
    const Vector3 sum = from + to;
    return side_of(sum) == side_of(sample) ? sum : from - to;
}

}  // namespace

void Findings::add(Findings&& other) {
    std::move(other.lines.begin(), other.lines.end(), std::back_inserter(lines));
    std::move(other.components.begin(), other.components.end(), std::back_inserter(components));
}

Plane3 scaled(const Plane3& plane) {
    const Vector3& n = plane.normal;
    const Rational by = Rational(1) / (!is_zero(n.x) ? n.x : !is_zero(n.y) ? n.y : n.z);
    return {by * n, by * plane.offset};
}

bool lies_in(const Plane3& plane, const RationalLine3& line) {
    return is_zero(dot(plane.normal, line.d)) && is_zero(plane.height(foot_of_origin(line)));
}

bool lies_in(const Plane3& plane, const TransversalElement& element) {
    return is_zero(plane.height(element.source())) && is_zero(plane.height(element.target()));
}

bool holds(const TransversalElement& element, const RationalPoint3& p) {
    if (element.kind() == Kind::point) return element.source() == p;
    if (!is_line_through(element, p)) return false;
    if (element.kind() == Kind::line) return true;
    // On one line places are ordered like their coordinates.
    const auto [low, high] = std::minmax(element.source(), element.target());
    return low <= p && p <= high;
}

TransversalRange ordered(TransversalRange range) {
    if (range.to < range.from) {
        std::swap(range.from, range.to);
        std::swap(range.has_from, range.has_to);
    }
    return range;
}

Pencil::Pencil(RationalPoint3 center, const Plane3& plane)
    : center_(std::move(center)), plane_(scaled(plane)) {
    const Vector3& n = plane_.normal;
    // Two different products with axes that are not parallel to the normal.
    if (!is_zero(n.x)) {
        first_ = {-n.y, n.x, 0};
        second_ = {-n.z, 0, n.x};
    } else if (!is_zero(n.y)) {
        first_ = {1, 0, 0};
        second_ = {0, -n.z, n.y};
    } else {
        first_ = {1, 0, 0};
        second_ = {0, 1, 0};
    }
}

RationalLine3 Pencil::line(const CirclePoint& at) const {
    return sightline::scaled(line_along(center_, at.x * first_ + at.y * second_));
}

CirclePoint Pencil::parameter_of(const Vector3& direction) const {
    // direction = x·first + y·second.
    return circle_point(turn(plane_.normal, direction, second_),
                        turn(plane_.normal, first_, direction));
}

LinearForm Pencil::across(const Vector3& v) const {
    return {turn(plane_.normal, first_, v), turn(plane_.normal, second_, v)};
}

CircleConstraint Pencil::constraint(const TransversalElement& element) const {
    if (element.kind() == Kind::line) {
        return {across(element.target() - element.source()), {}, true};
    }
    return {across(element.source() - center_), across(element.target() - center_), false};
}

TransversalRange Pencil::range(const CircleArc& arc) const {
    TransversalRange result{line(arc.from), line(arc.through), line(arc.to), arc.has_from,
                            arc.has_to};
    const Vector3& n = plane_.normal;
    const Vector3 middle = result.from == result.to
                               ? cross(n, result.from.d)
                               : canonical_between(n, result.from.d, result.to.d, result.through.d);
    result.through = sightline::scaled(line_along(center_, middle));
    return ordered(std::move(result));
}

TransversalComponent Pencil::component(const std::vector<CircleArc>& arcs) const {
    TransversalComponent result;
    result.kind = TransversalComponent::Kind::pencil;
    result.point = center_;
    result.plane = plane_;
    for (const CircleArc& arc : arcs) result.ranges.push_back(range(arc));
    std::sort(result.ranges.begin(), result.ranges.end(), [](const auto& a, const auto& b) {
        return std::tie(a.from, a.to, a.through) < std::tie(b.from, b.to, b.through);
    });
    return result;
}

CircleSet lines_of_pencil(const Pencil& pencil, const std::vector<TransversalElement>& elements) {
    std::vector<CircleConstraint> constraints;
    for (const TransversalElement& element : elements) {
        if (!is_line_through(element, pencil.center())) {
            constraints.push_back(pencil.constraint(element));
            continue;
        }
        // Through the centre, or else met by its own line only.
        if (holds(element, pencil.center())) continue;
        const CirclePoint own = pencil.parameter_of(element.target() - element.source());
        constraints.push_back({{own.y, -own.x}, {own.y, -own.x}, false});
    }
    return solve(constraints);
}

Findings solve_pencil(const Pencil& pencil, const std::vector<TransversalElement>& elements) {
    const CircleSet set = lines_of_pencil(pencil, elements);
    Findings findings;
    if (set.is_all || !set.arcs.empty()) findings.components.push_back(pencil.component(set.arcs));
    for (const CirclePoint& p : set.points) findings.lines.push_back(pencil.line(p));
    return findings;
}

}  // namespace sightline::detail
