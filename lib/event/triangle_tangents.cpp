// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/triangle_tangents.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "event/pencil.hpp"

namespace sightline {

namespace {

using Triangles = std::array<RationalTriangle3, 4>;
using Edges = std::array<std::uint8_t, 4>;
using Family = TransversalComponent::Kind;

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

Plane3 plane_of(const RationalTriangle3& t) {
    return detail::scaled(plane_through(t[0], t[1], t[2]));
}

TransversalElement element(const RationalTriangle3& t, std::size_t i) {
    return TransversalElement::segment(edge_of(t, i));
}

bool is_on_boundary(const RationalTriangle3& t, const RationalPoint3& p) {
    return detail::holds(element(t, 0), p) || detail::holds(element(t, 1), p) ||
           detail::holds(element(t, 2), p);
}

// The edge in a plane that does not hold the triangle.
std::optional<TransversalElement> edge_in(const RationalTriangle3& t, const Plane3& plane) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (detail::lies_in(plane, element(t, i))) return element(t, i);
    }
    return std::nullopt;
}

// Boundary points of a triangle in a plane: all corners there, and where edges cross it.
void add_special_points(const RationalTriangle3& t, const Plane3& plane,
                        std::set<RationalPoint3>& points) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_zero(plane.height(t[i]))) points.insert(t[i]);
        const Sign here = plane.height(t[i]).sign(), there = plane.height(t[(i + 1) % 3]).sign();
        if (here * there != Sign::negative) continue;
        const Vector3 v = meeting_point(element(t, i).carrier(), plane).divided();
        points.insert({v.x, v.y, v.z});
    }
}

class Tangents {
public:
    explicit Tangents(const Triangles& triangles) : triangles_(triangles) {}

    TriangleTangents run() {
        for_all_edges([&](const Edges& edges) { collect(edges); });
        for (const RationalTriangle3& t : triangles_) add_candidates(plane_of(t));
        cut_pencils();
        sort_and_unite();
        return {lines(), std::move(components_)};
    }

private:
    template <typename Function>
    static void for_all_edges(const Function& f) {
        for (int code = 0; code < 81; ++code) {
            f(Edges{static_cast<std::uint8_t>(code / 27), static_cast<std::uint8_t>(code / 9 % 3),
                    static_cast<std::uint8_t>(code / 3 % 3), static_cast<std::uint8_t>(code % 3)});
        }
    }
    [[nodiscard]] std::array<TransversalElement, 4> elements(const Edges& e) const {
        return {element(triangles_[0], e[0]), element(triangles_[1], e[1]),
                element(triangles_[2], e[2]), element(triangles_[3], e[3])};
    }

    void collect(const Edges& edges) {
        Transversals found = transversals(elements(edges));
        for (const TransversalLine& line : found.lines) candidates_.insert(line.line);
        for (TransversalComponent& c : found.components) {
            if (c.kind == Family::plane && holds_triangle(*c.plane)) continue;
            if (c.kind == Family::plane) regions_.push_back(*c.plane);
            components_.push_back(std::move(c));
        }
    }
    [[nodiscard]] bool holds_triangle(const Plane3& plane) const {
        return std::ranges::any_of(triangles_, [&](const auto& t) { return plane_of(t) == plane; });
    }

    // In the plane of a triangle tangents go through a corner, and through points of the others.
    void add_candidates(const Plane3& plane) {
        std::set<RationalPoint3> points;
        for (const RationalTriangle3& t : triangles_) add_special_points(t, plane, points);
        for (const RationalPoint3& p : points) {
            pencils_.emplace_back(p, plane);
            for (const RationalPoint3& q : points) {
                if (p < q) candidates_.insert(scaled(to_surd(line_through(p, q))));
            }
        }
    }

    // Pencils are solved once more, from what all triangles demand of lines through their centre.
    void cut_pencils() {
        for (const TransversalComponent& c : components_) {
            if (c.kind == Family::pencil && !is_region(*c.plane)) {
                pencils_.emplace_back(*c.point, *c.plane);
            }
        }
        std::erase_if(components_, [&](const TransversalComponent& c) {
            return c.kind == Family::pencil && !is_region(*c.plane);
        });
        for (const auto& [center, plane] : pencils_) solve_pencil(center, plane);
    }
    [[nodiscard]] bool is_region(const Plane3& plane) const {
        return std::ranges::find(regions_, plane) != regions_.end();
    }
    void solve_pencil(const RationalPoint3& center, const Plane3& plane) {
        const detail::Pencil pencil(center, plane);
        std::vector<detail::CircleConstraint> constraints;
        for (const RationalTriangle3& t : triangles_) {
            if (plane_of(t) == plane) {
                const auto corner = std::ranges::find(t, center) - t.begin();
                if (corner == 3) return;
                // Of the edge opposite to the corner both ends lie on one side.
                auto c = pencil.constraint(element(t, static_cast<std::size_t>(corner + 1) % 3));
                c.g = {-c.g.p, -c.g.q};
                constraints.push_back(c);
            } else if (!is_on_boundary(t, center)) {
                const auto edge = edge_in(t, plane);
                if (!edge || is_on(edge->carrier(), center)) return;
                constraints.push_back(pencil.constraint(*edge));
            }
        }
        const detail::CircleSet set = detail::solve(constraints);
        if (set.is_all || !set.arcs.empty()) components_.push_back(pencil.component(set.arcs));
        for (const auto& p : set.points) candidates_.insert(to_surd(pencil.line(p)));
    }

    void sort_and_unite() {
        const auto is_swallowed = [&](const TransversalComponent& c) {
            return c.kind == Family::pencil && std::ranges::any_of(components_, [&](const auto& o) {
                       return o.kind == Family::bundle && o.point == c.point;
                   });
        };
        std::erase_if(components_, is_swallowed);
        const auto key = [](const TransversalComponent& c) {
            return std::tuple(c.kind, c.plane ? c.plane->normal : Vector3{},
                              c.plane ? c.plane->offset : Rational(),
                              c.point.value_or(RationalPoint3{}), c.generators);
        };
        std::stable_sort(components_.begin(), components_.end(),
                         [&](const auto& a, const auto& b) { return key(a) < key(b); });
        std::vector<TransversalComponent> unique;
        for (TransversalComponent& c : components_) {
            if (std::ranges::find(unique, c) == unique.end()) unique.push_back(std::move(c));
        }
        components_ = std::move(unique);
    }

    [[nodiscard]] std::vector<TriangleTangents::Line> lines() const {
        std::vector<TriangleTangents::Line> result;
        for (const SurdLine3& line : candidates_) {
            const auto touches = [&](const auto& t) { return is_tangent(line, t); };
            const auto holds_line = [&](const TransversalComponent& c) {
                return c.kind != Family::plane && is_in_family(c, line);
            };
            if (std::ranges::all_of(triangles_, touches) &&
                std::ranges::none_of(components_, holds_line)) {
                result.push_back(supported(line));
            }
        }
        std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
            return std::tie(a.edges, a.line) < std::tie(b.edges, b.line);
        });
        return result;
    }
    [[nodiscard]] TriangleTangents::Line supported(const SurdLine3& line) const {
        TriangleTangents::Line result{{}, 0, line};
        for (std::size_t k = 0; k < 4; ++k) {
            while (!meets(line, element(triangles_[k], result.edges[k]))) ++result.edges[k];
        }
        const auto e = elements(result.edges);
        const auto all =
            lines_meeting({e[0].carrier(), e[1].carrier(), e[2].carrier(), e[3].carrier()});
        if (all)
            result.root = static_cast<std::uint8_t>(std::ranges::find(*all, line) - all->begin());
        return result;
    }

    const Triangles& triangles_;
    std::set<SurdLine3> candidates_;
    std::vector<TransversalComponent> components_;
    std::vector<Plane3> regions_;
    std::vector<std::pair<RationalPoint3, Plane3>> pencils_;
};

}  // namespace

RationalSegment3 edge_of(const RationalTriangle3& triangle, std::size_t i) {
    return {triangle[i], triangle[(i + 1) % 3]};
}

bool is_tangent(const SurdLine3& line, const RationalTriangle3& triangle) {
    const bool meets_boundary = meets(line, element(triangle, 0)) ||
                                meets(line, element(triangle, 1)) ||
                                meets(line, element(triangle, 2));
    if (!meets_boundary) return false;
    const SurdVector3 n = to_surd(plane_of(triangle).normal);
    if (sign_of(dot(n, line.d)) != Sign::zero) return true;
    // It meets the plane and is parallel to it: on which sides of it are the corners?
    bool sees_left = false, sees_right = false;
    for (const RationalPoint3& corner : triangle) {
        const Sign side = sign_of(dot(n, cross(to_surd(vector_to(corner)), line.d) - line.m));
        sees_left = sees_left || side == Sign::positive;
        sees_right = sees_right || side == Sign::negative;
    }
    return !(sees_left && sees_right);
}

TriangleTangents triangle_tangents(const std::array<RationalTriangle3, 4>& triangles) {
    return Tangents(triangles).run();
}

}  // namespace sightline
