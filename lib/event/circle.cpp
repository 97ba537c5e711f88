// SPDX-License-Identifier: GPL-3.0-or-later
#include "event/circle.hpp"

#include <algorithm>

namespace sightline::detail {

namespace {

const CirclePoint infinity{1, 0};

bool is_infinite(const CirclePoint& p) { return p.y.sign() == Sign::zero; }

// Upward from minus infinity, which comes last.
bool is_before(const CirclePoint& p, const CirclePoint& q) {
    if (is_infinite(p) || is_infinite(q)) return !is_infinite(p) && is_infinite(q);
    return p.x < q.x;
}

void sort_and_unite(std::vector<CirclePoint>& points) {
    std::sort(points.begin(), points.end(), is_before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

// A point strictly between p and q, going upward from p; between p and p: any other.
CirclePoint between(const CirclePoint& p, const CirclePoint& q) {
    if (is_infinite(p)) return is_infinite(q) ? CirclePoint{0, 1} : CirclePoint{q.x - 1, 1};
    if (is_infinite(q)) return {p.x + 1, 1};
    if (p.x < q.x) return {(p.x + q.x) / 2, 1};
    return infinity;
}

bool all_hold(const std::vector<CircleConstraint>& constraints, const CirclePoint& at) {
    return std::ranges::all_of(constraints, [&](const auto& c) { return c.holds_at(at); });
}

std::vector<CirclePoint> roots_of(const std::vector<CircleConstraint>& constraints) {
    std::vector<CirclePoint> roots;
    for (const CircleConstraint& c : constraints) {
        for (const LinearForm* form : {&c.f, &c.g}) {
            if (!form->is_zero()) roots.push_back(circle_point(-form->q, form->p));
        }
    }
    sort_and_unite(roots);
    return roots;
}

// The runs of places that belong, where even places are points and odd ones the gaps behind them.
CircleSet runs(const std::vector<CirclePoint>& points, const std::vector<bool>& belongs) {
    const std::size_t n = belongs.size();
    const auto point = [&](std::size_t place) { return points[place % n / 2]; };
    CircleSet result;
    for (std::size_t start = 0; start < n; ++start) {
        if (!belongs[start] || belongs[(start + n - 1) % n]) continue;
        std::size_t end = start;  // one behind the run
        while (belongs[end % n]) ++end;
        const std::size_t last = end - 1;
        if (start == last && start % 2 == 0) {
            result.points.push_back(point(start));
            continue;
        }
        const bool has_from = start % 2 == 0;
        const bool has_to = last % 2 == 0;
        const std::size_t gap = has_from ? start + 1 : start;
        result.arcs.push_back({point(start), between(point(gap), point(gap + 1)),
                               point(has_to ? last : last + 1), has_from, has_to});
    }
    return result;
}

}  // namespace

CirclePoint circle_point(const Rational& x, const Rational& y) {
    if (y.sign() == Sign::zero) return infinity;
    return {x / y, 1};
}

CircleSet solve(const std::vector<CircleConstraint>& constraints) {
    const std::vector<CirclePoint> roots = roots_of(constraints);
    if (roots.empty()) return {all_hold(constraints, infinity), {}, {}};
    std::vector<bool> belongs;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        belongs.push_back(all_hold(constraints, roots[i]));
        belongs.push_back(all_hold(constraints, between(roots[i], roots[(i + 1) % roots.size()])));
    }
    if (std::ranges::all_of(belongs, [](bool b) { return b; })) return {true, {}, {}};
    return runs(roots, belongs);
}

std::vector<CircleArc> cut(const CircleArc& arc, const std::vector<CirclePoint>& points) {
    // Places in the order in which they are met from arc.from on.
    std::vector<CirclePoint> inside;
    const auto is_met_before = [&](const CirclePoint& p, const CirclePoint& q) {
        const bool p_wraps = !is_before(arc.from, p);
        const bool q_wraps = !is_before(arc.from, q);
        return p_wraps != q_wraps ? q_wraps : is_before(p, q);
    };
    for (const CirclePoint& p : points) {
        if (p != arc.from && p != arc.to && (arc.from == arc.to || is_met_before(p, arc.to))) {
            inside.push_back(p);
        }
    }
    std::sort(inside.begin(), inside.end(), is_met_before);
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    inside.push_back(arc.to);
    std::vector<CircleArc> pieces;
    CirclePoint from = arc.from;
    for (const CirclePoint& to : inside) {
        pieces.push_back({from, between(from, to), to, true, true});
        from = to;
    }
    pieces.front().has_from = arc.has_from;
    pieces.back().has_to = arc.has_to;
    return pieces;
}

std::vector<CircleArc> cut_all(const std::vector<CirclePoint>& points) {
    return cut({points.front(), {}, points.front(), true, true}, points);
}

}  // namespace sightline::detail
