// SPDX-License-Identifier: GPL-3.0-or-later
// All lines that meet up to four elements: the elements are reduced until their lines are distinct,
// then two coplanar ones split the problem into lines in their plane and lines through their
// common point; without such a pair the lines are those of a regulus, or at most two of one.
#include "sightline/event/transversals.hpp"

#include <algorithm>
#include <ostream>
#include <tuple>

#include "event/pencil.hpp"
#include "event/swath_polynomials.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

namespace {

using detail::Findings;
using detail::holds;
using detail::lies_in;
using Elements = std::vector<TransversalElement>;
using Kind = TransversalElement::Kind;
using Family = TransversalComponent::Kind;

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

bool is_point(const TransversalElement& e) { return e.kind() == Kind::point; }

// A segment as it does not depend on its direction.
TransversalElement directed_up(const TransversalElement& e) {
    if (e.kind() != Kind::segment || e.source() < e.target()) return e;
    return TransversalElement::segment(e.target(), e.source());
}

// What two elements on one line have in common; empty when that is nothing.
std::optional<TransversalElement> common_piece(const TransversalElement& e,
                                               const TransversalElement& f) {
    if (e.kind() == Kind::line) return f;
    if (f.kind() == Kind::line) return e;
    const auto [e0, e1] = std::minmax(e.source(), e.target());
    const auto [f0, f1] = std::minmax(f.source(), f.target());
    const RationalPoint3& low = std::max(e0, f0);
    const RationalPoint3& high = std::min(e1, f1);
    if (high < low) return std::nullopt;
    return TransversalElement::segment(low, high);
}

// Elements of which none lies on the line of another; or the one line that can meet all.
struct Reduced {
    std::optional<RationalPoint3> point;
    Elements extended;
    std::optional<RationalLine3> forced;
};

class Reducer {
public:
    explicit Reducer(const Elements& elements) : rest_(elements) {}

    Reduced run() {
        while (!result_.forced && !rest_.empty()) {
            const TransversalElement next = directed_up(rest_.back());
            rest_.pop_back();
            if (is_point(next)) {
                add_point(next.source());
            } else {
                add_extended(next);
            }
        }
        return std::move(result_);
    }

private:
    void add_point(const RationalPoint3& p) {
        if (result_.point && *result_.point != p) {
            result_.forced = line_through(*result_.point, p);
        }
        result_.point = p;
        // Those on whose line the point lies are to be judged again.
        const auto on_line = [&](const TransversalElement& e) { return is_on(e.carrier(), p); };
        std::ranges::copy_if(result_.extended, std::back_inserter(rest_), on_line);
        std::erase_if(result_.extended, on_line);
    }
    void add_extended(const TransversalElement& e) {
        const RationalLine3 carrier = e.carrier();
        if (result_.point && is_on(carrier, *result_.point)) {
            if (!holds(e, *result_.point)) result_.forced = carrier;
            return;
        }
        for (auto other = result_.extended.begin(); other != result_.extended.end(); ++other) {
            if (!is_on(carrier, other->source()) || !is_on(carrier, other->target())) continue;
            const auto piece = common_piece(e, *other);
            if (piece) {
                rest_.push_back(*piece);
                result_.extended.erase(other);
            } else {
                result_.forced = carrier;
            }
            return;
        }
        result_.extended.push_back(e);
    }

    Elements rest_;
    Reduced result_;
};

Findings solve(const Elements& elements);

Findings one_line(const RationalLine3& line) { return {{line}, {}}; }

TransversalComponent bundle(const RationalPoint3& center) {
    TransversalComponent result;
    result.kind = Family::bundle;
    result.point = center;
    return result;
}

TransversalComponent product(Family kind, Elements pieces) {
    TransversalComponent result;
    result.kind = kind;
    std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
        return std::pair(a.source(), a.target()) < std::pair(b.source(), b.target());
    });
    result.pieces = std::move(pieces);
    return result;
}

// Lines through a point that meet elements whose lines don't hold it.
Findings solve_through(const RationalPoint3& center, const Elements& elements) {
    if (elements.empty()) return {{}, {bundle(center)}};
    const Plane3 plane = detail::scaled(plane_through(center, elements[0].carrier()));
    for (const TransversalElement& e : elements) {
        if (lies_in(plane, e)) continue;
        return one_line(line_of(plane, plane_through(center, e.carrier())));
    }
    return detail::solve_pencil(detail::Pencil(center, plane), elements);
}

// Lines in a plane that meet elements, of which those across the plane count as points.
Findings solve_in(const Plane3& plane, const Elements& elements) {
    Elements flat;
    std::optional<RationalPoint3> point;
    for (const TransversalElement& e : elements) {
        if (lies_in(plane, e)) {
            flat.push_back(e);
            continue;
        }
        const auto crossing = meeting_point(e.carrier(), plane);
        if (!crossing.is_finite()) return {};
        const Vector3 v = crossing.divided();
        const RationalPoint3 p{v.x, v.y, v.z};
        if (!holds(e, p)) return {};
        if (point && *point != p) return one_line(line_through(*point, p));
        point = p;
    }
    if (point) return detail::solve_pencil(detail::Pencil(*point, plane), flat);
    return detail::solve_plane(plane, flat);
}

// Two elements on distinct coplanar lines: what meets both lies in their plane or goes through
// their common point. Lines through that point in the plane are found as lines of the plane.
Findings solve_coplanar(const Elements& elements, std::size_t i, std::size_t j) {
    const RationalLine3 first = elements[i].carrier(), second = elements[j].carrier();
    const auto meeting = meeting_point(first, second);
    const RationalPoint3& apart =
        is_on(first, elements[j].source()) ? elements[j].target() : elements[j].source();
    const Plane3 plane = detail::scaled(plane_through(apart, first));
    Findings findings = solve_in(plane, elements);
    if (!meeting.is_finite()) return findings;
    const Vector3 v = meeting.divided();
    const RationalPoint3 p{v.x, v.y, v.z};
    if (!holds(elements[i], p) || !holds(elements[j], p)) return findings;
    Elements through = elements;
    through.erase(through.begin() + static_cast<std::ptrdiff_t>(j));
    through[i] = TransversalElement::point(p);
    Findings others = solve(through);
    std::erase_if(others.lines, [&](const RationalLine3& l) { return lies_in(plane, l); });
    std::erase_if(others.components,
                  [&](const TransversalComponent& c) { return c.plane && *c.plane == plane; });
    findings.add(std::move(others));
    return findings;
}

// The parameters t at which L(t) meets an element, as the plane moves that holds p(t) and another
// line that all L(t) meet.
detail::CircleConstraint moving_constraint(const detail::MovingPlane<Rational>& plane,
                                           const TransversalElement& e) {
    const auto height = [&](const RationalPoint3& p) {
        const Vector3 v = vector_to(p);
        return detail::LinearForm{dot(plane.n1, v) - plane.k1, dot(plane.n0, v) - plane.k0};
    };
    if (e.kind() == Kind::segment) return {height(e.source()), height(e.target()), false};
    const Vector3 u = e.target() - e.source();
    return {{dot(plane.n1, u), dot(plane.n0, u)}, {}, true};
}

detail::CircleConstraint own_constraint(const TransversalElement& e) {
    if (e.kind() == Kind::segment) return {{1, 0}, {1, -1}, false};
    return {{0, 1}, {}, true};
}

// Three or four pairwise skew elements, with the lines through each place of the first.
class SkewSolver {
public:
    explicit SkewSolver(const Elements& elements)
        : elements_(elements),
          a_(vector_to(elements[0].source())),
          u_(elements[0].target() - elements[0].source()),
          over_second_(detail::moving_plane(a_, u_, elements[1].carrier())),
          over_third_(detail::moving_plane(a_, u_, elements[2].carrier())),
          swath_(detail::swath(over_second_, over_third_)) {}

    [[nodiscard]] Findings regulus() const {
        std::vector<detail::CircleConstraint> constraints{
            own_constraint(elements_[0]), moving_constraint(over_third_, elements_[1])};
        for (std::size_t i = 2; i < elements_.size(); ++i) {
            constraints.push_back(moving_constraint(over_second_, elements_[i]));
        }
        const detail::CircleSet set = detail::solve(constraints);
        Findings findings;
        if (set.is_all || !set.arcs.empty()) findings.components.push_back(component(set.arcs));
        for (const auto& p : set.points) findings.lines.push_back(line(p));
        return findings;
    }

    [[nodiscard]] bool fourth_is_generator() const {
        const auto f = detail::side_polynomial(swath_, elements_[3].carrier());
        return is_zero(f.c0) && is_zero(f.c1) && is_zero(f.c2);
    }

private:
    // Of the lines of a paraboloid one is at infinity; it has no direction, only a moment.
    [[nodiscard]] RationalLine3 line(const detail::CirclePoint& at) const {
        if (!is_zero(at.y)) return scaled(detail::line_at(swath_, at.x));
        if (!swath_.d.c2.is_zero()) return scaled(RationalLine3{swath_.d.c2, swath_.m.c2});
        return {{}, detail::scaled(Plane3{swath_.m.c2, 0}).normal};
    }
    [[nodiscard]] TransversalComponent component(const std::vector<detail::CircleArc>& arcs) const {
        TransversalComponent result;
        result.kind = Family::regulus;
        for (std::size_t i = 0; i < 3; ++i) {
            result.generators.push_back(scaled(elements_[i].carrier()));
        }
        std::sort(result.generators.begin(), result.generators.end());
        for (const detail::CircleArc& arc : arcs) {
            result.ranges.push_back(detail::ordered(
                {line(arc.from), line(arc.through), line(arc.to), arc.has_from, arc.has_to}));
        }
        std::sort(result.ranges.begin(), result.ranges.end(), [](const auto& a, const auto& b) {
            return std::tie(a.from, a.to, a.through) < std::tie(b.from, b.to, b.through);
        });
        return result;
    }

    const Elements& elements_;
    Vector3 a_;
    Vector3 u_;
    detail::MovingPlane<Rational> over_second_;
    detail::MovingPlane<Rational> over_third_;
    detail::Swath<Rational> swath_;
};

std::optional<std::pair<std::size_t, std::size_t>> coplanar_pair(const Elements& elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (std::size_t j = i + 1; j < elements.size(); ++j) {
            if (is_zero(side(elements[i].carrier(), elements[j].carrier()))) return {{i, j}};
        }
    }
    return std::nullopt;
}

// Families, and rational lines that may be isolated and may miss an element. Of four pairwise skew
// elements not on one regulus it finds nothing: their lines are irrational.
Findings solve(const Elements& elements) {
    const Reduced reduced = Reducer(elements).run();
    if (reduced.forced) return one_line(*reduced.forced);
    if (reduced.point) return solve_through(*reduced.point, reduced.extended);
    const Elements& extended = reduced.extended;
    if (extended.size() == 1) return {{}, {product(Family::segment, extended)}};
    if (const auto pair = coplanar_pair(extended)) {
        return solve_coplanar(extended, pair->first, pair->second);
    }
    if (extended.size() == 2) return {{}, {product(Family::congruence, extended)}};
    const SkewSolver solver(extended);
    if (extended.size() == 4 && !solver.fourth_is_generator()) return {};
    return solver.regulus();
}

// The lines of the four carriers, when there are finitely many.
std::optional<std::vector<SurdLine3>> carrier_lines(std::span<const TransversalElement> elements) {
    if (elements.size() != 4 || std::ranges::any_of(elements, is_point)) return std::nullopt;
    return lines_meeting({elements[0].carrier(), elements[1].carrier(), elements[2].carrier(),
                          elements[3].carrier()});
}

bool is_isolated(const SurdLine3& line, const std::vector<TransversalComponent>& components) {
    return std::ranges::none_of(components, [&](const TransversalComponent& c) {
        return c.kind != Family::plane && is_in_family(c, line);
    });
}

std::vector<TransversalLine> numbered(std::vector<SurdLine3> lines,
                                      const std::optional<std::vector<SurdLine3>>& carriers) {
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    const std::vector<SurdLine3>& all = carriers ? *carriers : lines;
    std::vector<TransversalLine> result;
    for (SurdLine3& line : lines) {
        const auto root = std::ranges::find(all, line) - all.begin();
        result.push_back({line, static_cast<std::uint8_t>(root)});
    }
    return result;
}

void sort_components(std::vector<TransversalComponent>& components) {
    const auto key = [](const TransversalComponent& c) {
        return std::tuple(c.kind, c.plane ? c.plane->normal : Vector3{},
                          c.plane ? c.plane->offset : Rational(),
                          c.point.value_or(RationalPoint3{}));
    };
    std::sort(components.begin(), components.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

}  // namespace

TransversalElement TransversalElement::line(const RationalPoint3& a, const RationalPoint3& b) {
    SIGHTLINE_EXPECT(a != b);
    return {Kind::line, a, b};
}

TransversalElement TransversalElement::segment(const RationalPoint3& a, const RationalPoint3& b) {
    return {a == b ? Kind::point : Kind::segment, a, b};
}

TransversalElement TransversalElement::point(const RationalPoint3& p) {
    return {Kind::point, p, p};
}

Transversals transversals(std::span<const TransversalElement> elements) {
    SIGHTLINE_EXPECT(!elements.empty() && elements.size() <= 4);
    Findings findings = solve({elements.begin(), elements.end()});
    std::vector<TransversalComponent>& components = findings.components;
    // Pencils of one bundle, which a plane through its centre cuts out.
    const auto in_bundle = [&](const TransversalComponent& c) {
        return c.kind == Family::pencil && std::ranges::any_of(components, [&](const auto& other) {
                   return other.kind == Family::bundle && other.point == c.point;
               });
    };
    std::erase_if(components, in_bundle);
    const auto carriers = carrier_lines(elements);
    std::vector<SurdLine3> lines;
    for (const RationalLine3& line : findings.lines) lines.push_back(scaled(to_surd(line)));
    if (carriers) lines = *carriers;
    std::erase_if(lines, [&](const SurdLine3& line) {
        return !verify(elements, line) || !is_isolated(line, components);
    });
    sort_components(components);
    return {numbered(std::move(lines), carriers), std::move(components)};
}

}  // namespace sightline
