// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/line_family3.hpp"

#include <algorithm>

namespace sightline::reference::detail {
namespace {

// Appends the roots of c2 s² + c1 s + c0, unless it is zero.
void add_roots(const Rational& c2, const Rational& c1, const Rational& c0,
               std::vector<Surd>& roots) {
    if (is_zero(c2)) {
        if (!is_zero(c1)) roots.emplace_back(-c0 / c1);
        return;
    }
    const Rational half = -c1 / (2 * c2);
    const Rational discriminant = half * half - c0 / c2;
    if (discriminant.sign() == Sign::negative) return;
    roots.emplace_back(half, 1, discriminant);
    if (!is_zero(discriminant)) roots.emplace_back(half, -1, discriminant);
}

// Whether a plane that has the ends of a segment on these sides meets the segment.
bool is_between(Sign source, Sign target) { return source * target != Sign::positive; }

template <typename T>
void sort_unique(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The direction of the line through p that meets the lines of a and b.
template <typename T>
Triple<T> transversal(const Triple<T>& p, const Triple<T>& a_direction, const Triple<T>& a_moment,
                      const Triple<T>& b_direction, const Triple<T>& b_moment) {
    return cross(minus(a_moment, cross(p, a_direction)), minus(b_moment, cross(p, b_direction)));
}

}  // namespace

LineFamily::LineFamily(const ExactScene& scene, ExactEdge base, RationalTriple point)
    : scene_(&scene), base_(std::move(base)), point_(std::move(point)) {
    plane_ = plane_of(*point_, base_);
}

LineFamily::LineFamily(const ExactScene& scene, EdgeId base, RationalTriple point)
    : LineFamily(scene, scene.edges[base.index()], std::move(point)) {
    edges_.push_back(base);
}

LineFamily::LineFamily(const ExactScene& scene, EdgeId base, EdgeId second, EdgeId third)
    : scene_(&scene), base_(scene.edges[base.index()]), edges_{base, second, third} {}

ExactLine LineFamily::line_at(const Surd& s) const {
    const SurdTriple p = plus(to_surd(base_.source), times(s, to_surd(base_.direction)));
    if (point_) return {p, minus(p, to_surd(*point_))};
    const ExactEdge& a = scene_->edges[edges_[1].index()];
    const ExactEdge& b = scene_->edges[edges_[2].index()];
    return {p, transversal(p, to_surd(a.direction), to_surd(a.moment), to_surd(b.direction),
                           to_surd(b.moment))};
}

std::array<RationalTriple, 2> LineFamily::rational_line(const Rational& s) const {
    const RationalTriple p = base_point(s);
    if (point_) return {p, minus(p, *point_)};
    const ExactEdge& a = scene_->edges[edges_[1].index()];
    const ExactEdge& b = scene_->edges[edges_[2].index()];
    return {p, transversal(p, a.direction, a.moment, b.direction, b.moment)};
}

// Of degree 1 in s for a pencil, 2 for a regulus (mathematics: swath of three lines).
Rational LineFamily::side(const Rational& s, const ExactEdge& e) const {
    const auto [p, d] = rational_line(s);
    return dot(d, e.moment) + dot(cross(p, d), e.direction);
}

LineFamily::Linear LineFamily::distance(const ExactEdge& line, const RationalTriple& p) const {
    const auto at = [&](const Rational& s) {
        const RationalTriple q = base_point(s);
        return dot(minus(line.moment, cross(q, line.direction)), minus(p, q));
    };
    const Rational constant = at(0);
    return {constant, at(1) - constant};
}

std::vector<std::array<Rational, 2>> LineFamily::live() const {
    if (point_) return {{0, 1}};
    // The plane of the base's point and one edge cuts the other between its ends.
    std::vector<std::array<Linear, 2>> distances;
    std::vector<Rational> cuts{0, 1};
    for (std::size_t i = 1; i <= 2; ++i) {
        const ExactEdge& plane = scene_->edges[edges_[i].index()];
        const ExactEdge& cut = scene_->edges[edges_[3 - i].index()];
        distances.push_back({distance(plane, cut.source), distance(plane, cut.target)});
        for (const Linear& d : distances.back()) {
            if (is_zero(d.slope)) continue;
            const Rational root = -d.constant / d.slope;
            if (root > 0 && root < 1) cuts.push_back(root);
        }
    }
    sort_unique(cuts);
    std::vector<std::array<Rational, 2>> result;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Rational s = (cuts[i] + cuts[i + 1]) / 2;
        const auto sign = [&](const Linear& d) { return (d.constant + s * d.slope).sign(); };
        const bool meets_all = std::ranges::all_of(
            distances, [&](const auto& d) { return sign(d[0]) * sign(d[1]) == Sign::negative; });
        if (meets_all) result.push_back({cuts[i], cuts[i + 1]});
    }
    return result;
}

void LineFamily::add_meetings(const ExactEdge& e, std::vector<Surd>& events) const {
    if (point_) {
        if (!is_between(height(plane_, e.source).sign(), height(plane_, e.target).sign())) return;
        const Rational at_0 = side(0, e);
        add_roots(0, side(1, e) - at_0, at_0, events);
        return;
    }
    const Rational at_0 = side(0, e);
    const Rational at_1 = side(1, e);
    // Three values give a polynomial of degree 2.
    const Rational at_minus = side(-1, e);
    std::vector<Surd> roots;
    add_roots((at_1 + at_minus) / 2 - at_0, (at_1 - at_minus) / 2, at_0, roots);
    if (roots.empty()) return;
    // The line lies in the plane of the base's point and the second edge; e must meet that plane.
    const ExactEdge& second = scene_->edges[edges_[1].index()];
    const Linear from = distance(second, e.source);
    const Linear to = distance(second, e.target);
    for (Surd& s : roots) {
        const auto sign = [&](const Linear& d) { return (d.constant + s * d.slope).sign(); };
        if (is_between(sign(from), sign(to))) events.push_back(std::move(s));
    }
}

void LineFamily::add_point(const RationalTriple& p, std::vector<Surd>& events) const {
    std::vector<Surd> roots;
    if (point_) {
        // The planes of p and the line's coordinate projections: linear forms in s.
        if (!is_zero(height(plane_, p)) || p == *point_) return;
        const RationalTriple to_p = minus(p, *point_);
        const RationalTriple at_0 = cross(minus(base_.source, *point_), to_p);
        const RationalTriple slope = cross(base_.direction, to_p);
        for (std::size_t i = 0; i < 3; ++i) add_roots(0, slope[i], at_0[i], roots);
    } else {
        for (std::size_t i = 1; i <= 2; ++i) {
            const Linear d = distance(scene_->edges[edges_[i].index()], p);
            add_roots(0, d.slope, d.constant, roots);
        }
    }
    for (const Surd& s : roots) {
        const auto [q, d] = rational_line(s.rational_part());
        if (is_zero(cross(minus(p, q), d))) events.push_back(s);
    }
}

std::vector<Surd> LineFamily::events(const Rational& first, const Rational& last) const {
    std::vector<Surd> result;
    for (const ExactEdge& e : scene_->edges) add_meetings(e, result);
    for (const RationalTriple& p : scene_->points) add_point(p, result);
    std::erase_if(result, [&](const Surd& s) { return s <= first || s >= last; });
    sort_unique(result);
    return result;
}

bool LineFamily::is_family_of(const Freedom& freedom) const {
    if (freedom.dimension != 1) return false;
    if (!point_) return !freedom.pencil;
    return freedom.pencil == Freedom::Pencil{*point_, plane_};
}

}  // namespace sightline::reference::detail
