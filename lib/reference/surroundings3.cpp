// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/surroundings3.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace sightline::reference::detail {
namespace {

std::size_t find(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

// Sorted round the circle, without repetitions.
std::vector<std::size_t> round_the_circle(const std::vector<Direction>& directions) {
    std::vector<std::size_t> order(directions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto before = [&](std::size_t a, std::size_t b) {
        return comes_before(directions[0], directions[a], directions[b]);
    };
    std::ranges::sort(order, before);
    const auto same = [&](std::size_t a, std::size_t b) { return !before(a, b) && !before(b, a); };
    order.erase(std::unique(order.begin(), order.end(), same), order.end());
    return order;
}

}  // namespace

Surroundings::Surroundings(const LineCut& line, std::size_t first, std::size_t last)
    : line_(&line) {
    for (std::size_t at = first; at <= last; ++at) {
        add_point(at);
        if (at > first) join_along(points_[points_.size() - 2], points_.back());
    }
}

void Surroundings::add_point(std::size_t at) {
    const ExactScene& exact = *line_->scene_;
    std::set<Plane> planes;
    for (const auto& trace : line_->traces_) {
        if (trace.first <= at && at <= trace.last) planes.insert(exact.planes[trace.face.index()]);
    }
    // The border of a sheet's face is no other face's plane: one across is added.
    const SurdTriple x = line_->picture_->line().at(line_->points_[at]);
    for (std::size_t i = 0; i < exact.edges.size(); ++i) {
        const Edge3& edge = exact.scene.edges()[i];
        const ExactEdge& e = exact.edges[i];
        if (!line_->is_sheet(edge.body)) continue;
        const SurdTriple from_source = minus(x, to_surd(e.source));
        if (!is_zero(cross(from_source, to_surd(e.direction)))) continue;
        for (const FaceId f : edge.faces) {
            if (f.is_none()) continue;
            const RationalTriple& n = exact.normals[f.index()];
            planes.insert(plane_of(e.source, n, e.direction));
        }
    }
    Point point;
    for (const Plane& p : planes) point.normals.push_back(p.normal);
    for (std::size_t i = 0; i < point.normals.size(); ++i) add_walls(point, at, i);
    points_.push_back(std::move(point));
}

// The rays in which the other planes cut this one bound its sectors.
void Surroundings::add_walls(Point& point, std::size_t at, std::size_t plane) {
    const RationalTriple& n = point.normals[plane];
    std::vector<RationalTriple> rays;
    for (const RationalTriple& other : point.normals) {
        if (other == n) continue;
        rays.push_back(cross(n, other));
        rays.push_back(cross(other, n));
    }
    if (rays.empty()) {
        const RationalTriple aside{1, 0, 0};
        const RationalTriple inner = cross(n, aside);
        add_wall(point, at, plane, is_zero(inner) ? RationalTriple{0, 1, 0} : inner);
        return;
    }
    const std::size_t axis = is_zero(n[0]) ? (is_zero(n[1]) ? 2 : 1) : 0;
    std::vector<Direction> directions;
    for (const auto& r : rays) directions.push_back({r[(axis + 1) % 3], r[(axis + 2) % 3]});
    const auto order = round_the_circle(directions);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const RationalTriple& ray = rays[order[i]];
        const RationalTriple& next = rays[order[(i + 1) % order.size()]];
        add_wall(point, at, plane, order.size() == 2 ? cross(n, ray) : plus(ray, next));
    }
}

std::size_t Surroundings::cell(Point& point, Signs signs) {
    const auto [it, is_new] = point.cells.try_emplace(std::move(signs), cell_count_);
    if (is_new) ++cell_count_;
    return it->second;
}

void Surroundings::add_wall(Point& point, std::size_t at, std::size_t plane,
                            const RationalTriple& inner) {
    Signs signs;
    for (const RationalTriple& n : point.normals) signs.push_back(to_int(dot(n, inner).sign()));
    Wall wall{};
    signs[plane] = 1;
    wall.front = cell(point, signs);
    signs[plane] = -1;
    wall.back = cell(point, signs);
    const ExactScene& exact = *line_->scene_;
    for (const auto& trace : line_->traces_) {
        const RationalTriple& normal = exact.normals[trace.face.index()];
        if (at < trace.first || trace.last < at || !covers(trace.triangle, at, inner)) continue;
        const BodyId body = line_->body(trace.face);
        if (line_->is_sheet(body)) {
            wall.sheets.push_back(body);
        } else {
            wall.is_solid = true;
            const bool same = dot(normal, point.normals[plane]).sign() == Sign::positive;
            solid_cells_.push_back(same ? wall.back : wall.front);
        }
    }
    walls_.push_back(std::move(wall));
}

// Whether the triangle contains the points next to x in this direction.
bool Surroundings::covers(std::size_t triangle, std::size_t at,
                          const RationalTriple& direction) const {
    const ExactScene& exact = *line_->scene_;
    const Triangle3& t = exact.scene.triangles()[triangle];
    const RationalTriple& normal = exact.normals[t.face.index()];
    if (!is_zero(dot(normal, direction))) return false;
    const SurdTriple x = line_->picture_->line().at(line_->points_[at]);
    for (std::size_t i = 0; i < 3; ++i) {
        const RationalTriple& a = exact.vertices[t.corners[i].index()];
        const RationalTriple& b = exact.vertices[t.corners[(i + 1) % 3].index()];
        const RationalTriple inward = cross(normal, minus(b, a));
        const bool is_on = is_zero(dot(to_surd(inward), minus(x, to_surd(a))));
        if (is_on && dot(inward, direction).sign() == Sign::negative) return false;
    }
    return true;
}

Surroundings::Signs Surroundings::signs_towards(const Point& point, int direction,
                                                const std::array<Rational, 2>& aside) const {
    const ExactLine& line = line_->picture_->line();
    Signs signs;
    for (const RationalTriple& n : point.normals) {
        const int along = to_int(dot(to_surd(n), line.direction).sign());
        const Rational turn = n[(line.axis + 1) % 3] * aside[0] + n[(line.axis + 2) % 3] * aside[1];
        signs.push_back(along != 0 ? direction * along : to_int(turn.sign()));
    }
    return signs;
}

// Round a piece of the line, the planes that contain it cut space into sectors; each is part of a cell at
// both its ends.
void Surroundings::join_along(const Point& a, const Point& b) {
    const ExactLine& line = line_->picture_->line();
    std::vector<std::array<Rational, 2>> rays;
    std::vector<Direction> directions;
    for (const Point* point : {&a, &b}) {
        for (const RationalTriple& n : point->normals) {
            if (!is_zero(dot(to_surd(n), line.direction))) continue;
            const Rational& x = n[(line.axis + 1) % 3];
            const Rational& y = n[(line.axis + 2) % 3];
            rays.push_back({-y, x});
            rays.push_back({y, -x});
        }
    }
    for (const auto& r : rays) directions.push_back({r[0], r[1]});
    const auto order = round_the_circle(directions);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& ray = rays[order[i]];
        const auto& next = rays[order[(i + 1) % order.size()]];
        const std::array<Rational, 2> inner =
            order.size() == 2 ? std::array<Rational, 2>{-ray[1], ray[0]}
                              : std::array<Rational, 2>{ray[0] + next[0], ray[1] + next[1]};
        joints_.emplace_back(a.cells.at(signs_towards(a, 1, inner)),
                             b.cells.at(signs_towards(b, -1, inner)));
    }
}

Surroundings::Components Surroundings::components(const std::vector<BodyId>& sheets) const {
    Components parent(cell_count_);
    std::iota(parent.begin(), parent.end(), 0U);
    for (const auto& [a, b] : joints_) parent[find(parent, a)] = find(parent, b);
    for (const Wall& w : walls_) {
        const bool shut = w.is_solid || std::ranges::any_of(w.sheets, [&](BodyId b) {
                              return std::ranges::count(sheets, b) > 0;
                          });
        if (!shut) parent[find(parent, w.front)] = find(parent, w.back);
    }
    for (std::size_t i = 0; i < cell_count_; ++i) parent[i] = find(parent, i);
    return parent;
}

std::vector<std::size_t> Surroundings::cells_along(const Point& point, int direction) const {
    std::vector<std::size_t> result;
    const Signs towards = signs_towards(point, direction, {});
    for (const auto& [signs, id] : point.cells) {
        bool fits = true;
        for (std::size_t i = 0; i < signs.size(); ++i) {
            fits = fits && (towards[i] == 0 || towards[i] == signs[i]);
        }
        if (fits) result.push_back(id);
    }
    return result;
}

bool Surroundings::may_pass(const std::vector<BodyId>& sheets) const {
    // Without sheets, cells that hang together with one in a solid lie in it.
    const Components bare = components({});
    std::set<std::size_t> solid;
    for (const std::size_t c : solid_cells_) solid.insert(bare[c]);
    const Components with = components(sheets);
    for (const std::size_t i : cells_along(points_.front(), -1)) {
        for (const std::size_t j : cells_along(points_.back(), 1)) {
            if (with[i] == with[j] && !solid.contains(bare[i]) && !solid.contains(bare[j])) {
                return true;
            }
        }
    }
    return false;
}

std::vector<BodyId> Surroundings::separating_sheets() const {
    std::set<BodyId> all;
    for (const Wall& w : walls_) all.insert(w.sheets.begin(), w.sheets.end());
    const std::vector<BodyId> sheets(all.begin(), all.end());
    if (may_pass(sheets) || !may_pass({})) return {};
    std::vector<BodyId> alone;
    for (const BodyId b : sheets) {
        if (!may_pass({b})) alone.push_back(b);
    }
    return alone.empty() ? sheets : alone;
}

}  // namespace sightline::reference::detail
