// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/info2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>

#include "scene/boundary_sweep.hpp"
#include "scene/box_tree.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

using detail::Box2;
using detail::Owner;

bool is_within(const Point2& a, const Point2& b, const Point2& p) {
    return a < b ? !(p < a) && !(b < p) : !(p < b) && !(a < p);
}

class Describer {
public:
    explicit Describer(const Scene2& scene) : scene_(scene) {}

    SceneInfo2 run() {
        count();
        measure();
        find_coincident();
        find_contacts();
        find_straight();
        compare_walls();
        std::sort(info_.vertices_on_edges.begin(), info_.vertices_on_edges.end());
        info_.vertices_on_edges.erase(
            std::unique(info_.vertices_on_edges.begin(), info_.vertices_on_edges.end()),
            info_.vertices_on_edges.end());
        return std::move(info_);
    }

private:
    void count() {
        info_.vertices = scene_.vertex_count();
        info_.points = scene_.points().size();
        info_.bodies = scene_.body_count();
        info_.has_world = scene_.has_world();
        for (const RingRange2& ring : scene_.rings()) info_.holes += ring.is_hole ? 1 : 0;
        for (const Edge2& e : scene_.edges()) {
            std::size_t& n = e.kind == EdgeKind2::wall    ? info_.walls
                             : e.kind == EdgeKind2::world ? info_.world_edges
                                                          : info_.body_edges;
            ++n;
        }
    }

    void measure() {
        if (scene_.vertex_count() == 0) return;
        Box2 box = Box2::of(scene_.vertices()[0], scene_.vertices()[0]);
        for (const Point2& p : scene_.vertices()) box.include(Box2::of(p, p));
        info_.low = box.low;
        info_.high = box.high;
        info_.approx_extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
        double shortest = std::numeric_limits<double>::infinity();
        for (const Edge2& e : scene_.edges()) {
            const Point2& s = scene_[e.source];
            const Point2& t = scene_[e.target];
            shortest = std::min(shortest, std::hypot(t.x - s.x, t.y - s.y));
        }
        info_.approx_shortest_edge = scene_.edge_count() == 0 ? 0 : shortest;
    }

    void find_coincident() {
        std::vector<VertexId> order(scene_.vertex_count());
        for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = VertexId{v};
        std::sort(order.begin(), order.end(), [&](VertexId a, VertexId b) {
            if (scene_[a] != scene_[b]) return scene_[a] < scene_[b];
            return a < b;
        });
        for (std::size_t i = 0; i < order.size();) {
            std::size_t j = i + 1;
            while (j < order.size() && scene_[order[j]] == scene_[order[i]]) ++j;
            if (j - i > 1) info_.coincident.emplace_back(order.data() + i, order.data() + j);
            i = j;
        }
        std::sort(info_.coincident.begin(), info_.coincident.end());
    }

    void find_contacts() {
        const detail::SweepResult sweep =
            detail::sweep_boundaries(scene_.vertices(), scene_.edges(), scene_.has_world(), true);
        std::vector<std::vector<std::uint32_t>> edges_at(scene_.vertex_count());
        for (std::uint32_t i = 0; i < scene_.edge_count(); ++i) {
            edges_at[scene_.edges()[i].source.index()].push_back(i);
            edges_at[scene_.edges()[i].target.index()].push_back(i);
        }
        std::map<std::uint32_t, std::vector<std::uint32_t>> partners;
        for (const auto& [e, f] : sweep.overlaps) {
            partners[e].push_back(f);
            contact(owner(e), owner(f)).edges += 1;
        }
        for (const detail::SweepTouch& touch : sweep.touches) {
            std::vector<std::uint32_t> here = touch.passing;
            for (const VertexId v : touch.vertices) {
                for (const std::uint32_t e : touch.passing)
                    info_.vertices_on_edges.emplace_back(v, EdgeId{e});
                here.insert(here.end(), edges_at[v.index()].begin(), edges_at[v.index()].end());
            }
            note_meeting(touch, here, partners);
        }
        for (const auto& [pair, value] : contacts_) info_.contacts.push_back(value);
        std::sort(info_.pinches.begin(), info_.pinches.end());
    }

    void note_meeting(const detail::SweepTouch& touch, const std::vector<std::uint32_t>& here,
                      const std::map<std::uint32_t, std::vector<std::uint32_t>>& partners) {
        std::map<Owner, std::size_t> chains;
        for (const VertexId v : touch.vertices) ++chains[owner_of_vertex(v)];
        for (const std::uint32_t e : touch.passing) ++chains[owner(e)];
        const bool pinched =
            std::any_of(chains.begin(), chains.end(), [](const auto& c) { return c.second > 1; });
        if (pinched) info_.pinches.push_back(touch.vertices.front());
        std::vector<std::pair<Owner, Owner>> sealed;
        for (const std::uint32_t e : here) {
            const auto found = partners.find(e);
            if (found == partners.end()) continue;
            for (const std::uint32_t f : found->second) {
                if (std::find(here.begin(), here.end(), f) != here.end())
                    sealed.push_back(std::minmax(owner(e), owner(f)));
            }
        }
        for (auto a = chains.begin(); a != chains.end(); ++a) {
            for (auto b = std::next(a); b != chains.end(); ++b) {
                const std::pair<Owner, Owner> pair{a->first, b->first};
                const bool is_sealed =
                    std::find(sealed.begin(), sealed.end(), pair) != sealed.end();
                if (!is_sealed) contact(a->first, b->first).points += 1;
            }
        }
    }

    [[nodiscard]] Owner owner(std::uint32_t e) const { return detail::owner_of(scene_.edges()[e]); }
    [[nodiscard]] Owner owner_of_vertex(VertexId v) {
        if (vertex_owner_.empty()) {
            vertex_owner_.assign(scene_.vertex_count(), detail::free_space);
            for (const Edge2& e : scene_.edges())
                vertex_owner_[e.source.index()] = detail::owner_of(e);
        }
        return vertex_owner_[v.index()];
    }

    BodyContact2& contact(Owner a, Owner b) {
        if (a > b) std::swap(a, b);
        const auto body = [](Owner o) {
            return o == detail::world_solid ? BodyId::none() : BodyId{o};
        };
        return contacts_.try_emplace({a, b}, BodyContact2{body(a), body(b), 0, 0}).first->second;
    }

    void find_straight() {
        for (const RingRange2& ring : scene_.rings()) {
            for (std::uint32_t i = 0; i < ring.count; ++i) {
                const Edge2& e = scene_.edges()[ring.first.index() + i];
                const Edge2& f = scene_.edges()[ring.first.index() + (i + 1) % ring.count];
                look_at_corner(scene_[e.source], f.source, scene_[f.target]);
            }
        }
        for (std::size_t i = 1; i < scene_.edge_count(); ++i) {
            const Edge2& e = scene_.edges()[i - 1];
            const Edge2& f = scene_.edges()[i];
            if (f.kind == EdgeKind2::wall && e.kind == EdgeKind2::wall && e.target == f.source) {
                look_at_corner(scene_[e.source], f.source, scene_[f.target]);
            }
        }
        std::sort(info_.straight.begin(), info_.straight.end());
        std::sort(info_.nearly_straight.begin(), info_.nearly_straight.end());
    }

    void look_at_corner(const Point2& a, VertexId v, const Point2& c) {
        const Point2& b = scene_[v];
        if (orientation(a, b, c) == Sign::zero) {
            info_.straight.push_back(v);
        } else if (is_nearly_straight(a, b, c)) {
            info_.nearly_straight.push_back(v);
        }
    }

    /// Compares twice the triangle's area with what moving b by 4 ulps changes of it. A hint only: the
    /// cheap estimate first, exact area when that is in doubt.
    static bool is_nearly_straight(const Point2& a, const Point2& b, const Point2& c) {
        const auto ulp = [](double x) {
            return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) -
                   std::abs(x);
        };
        const double change = 4 * (ulp(b.x) * std::abs(c.y - a.y) + ulp(b.y) * std::abs(c.x - a.x));
        const double area = std::abs((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x));
        if (!(area <= 64 * change)) return false;
        const RationalPoint2 p = to_rational(a);
        const RationalPoint2 q = to_rational(b);
        const RationalPoint2 r = to_rational(c);
        const Rational exact = abs((q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x));
        return exact.approx_double() <= change;
    }

    void compare_walls() {
        if (info_.walls == 0 && info_.points == 0) return;
        std::vector<Box2> boxes;
        for (const Edge2& e : scene_.edges())
            boxes.push_back(Box2::of(scene_[e.source], scene_[e.target]));
        const detail::BoxTree tree(boxes);
        constexpr std::size_t most_pairs = 20'000'000;
        std::size_t pairs = 0;
        for (std::uint32_t i = 0; i < scene_.edge_count() && info_.all_walls_compared; ++i) {
            if (scene_.edges()[i].kind != EdgeKind2::wall) continue;
            const auto enough = [&](const Box2&) { return pairs <= most_pairs; };
            tree.query(boxes[i], enough, [&](std::uint32_t j) {
                ++pairs;
                const bool is_wall = scene_.edges()[j].kind == EdgeKind2::wall;
                if (j != i && (!is_wall || i < j)) compare(EdgeId{i}, EdgeId{j}, is_wall);
            });
            info_.all_walls_compared = pairs <= most_pairs;
        }
        find_points_on_edges(tree);
    }

    void compare(EdgeId i, EdgeId j, bool both_walls) {
        const Edge2& e = scene_[i];
        const Edge2& f = scene_[j];
        const Point2 &a = scene_[e.source], &b = scene_[e.target], &c = scene_[f.source],
                     &d = scene_[f.target];
        const Sign sc = orientation(a, b, c);
        const Sign sd = orientation(a, b, d);
        const Sign sa = orientation(c, d, a);
        const Sign sb = orientation(c, d, b);
        if (both_walls && sc * sd == Sign::negative && sa * sb == Sign::negative)
            ++info_.crossing_walls;
        if (both_walls && sc == Sign::zero && sd == Sign::zero) {
            if (std::max(std::min(a, b, less), std::min(c, d, less), less) <
                std::min(std::max(a, b, less), std::max(c, d, less), less)) {
                ++info_.overlapping_walls;
            }
        }
        note_on_edge(e.source, sa, j);
        note_on_edge(e.target, sb, j);
        note_on_edge(f.source, sc, i);
        note_on_edge(f.target, sd, i);
    }

    static bool less(const Point2& a, const Point2& b) { return a < b; }

    void note_on_edge(VertexId v, Sign side, EdgeId e) {
        const Point2& s = scene_[scene_[e].source];
        const Point2& t = scene_[scene_[e].target];
        const Point2& p = scene_[v];
        if (side == Sign::zero && p != s && p != t && is_within(s, t, p))
            info_.vertices_on_edges.emplace_back(v, e);
    }

    void find_points_on_edges(const detail::BoxTree& tree) {
        for (const VertexId v : scene_.points()) {
            const Point2& p = scene_[v];
            tree.query(
                Box2::of(p, p), [](const Box2&) { return true; },
                [&](std::uint32_t j) {
                    const Edge2& e = scene_.edges()[j];
                    note_on_edge(v, orientation(scene_[e.source], scene_[e.target], p), EdgeId{j});
                });
        }
    }

    const Scene2& scene_;
    SceneInfo2 info_;
    std::map<std::pair<Owner, Owner>, BodyContact2> contacts_;
    std::vector<Owner> vertex_owner_;
};

template <typename List, typename Show>
void append_list(std::string& out, std::string_view name, const List& list, const Show& show) {
    if (list.empty()) return;
    out += fmt::format("{}: {} (", name, list.size());
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(list.size(), most); ++i) {
        if (i > 0) out += ", ";
        out += show(list[i]);
    }
    out += list.size() > most ? ", …)\n" : ")\n";
}

std::string show_contact(const BodyContact2& c) {
    const std::string second = c.second.is_none() ? "world" : to_string(c.second);
    return fmt::format("{}-{} {} points {} edges", to_string(c.first), second, c.points, c.edges);
}

}  // namespace

bool SceneInfo2::is_degenerate() const noexcept {
    return !contacts.empty() || !coincident.empty() || !pinches.empty() || !straight.empty() ||
           !nearly_straight.empty() || !vertices_on_edges.empty() || crossing_walls > 0 ||
           overlapping_walls > 0;
}

SceneInfo2 describe(const Scene2& scene) { return Describer(scene).run(); }

std::string to_text(const SceneInfo2& info) {
    std::string out = fmt::format(
        "vertices: {}\nbodies: {} ({} edges, {} holes)\nworld: {}\nwalls: {}\npoints: {}\n",
        info.vertices, info.bodies, info.body_edges, info.holes,
        info.has_world ? fmt::format("yes ({} edges)", info.world_edges) : "no", info.walls,
        info.points);
    out += fmt::format("box: ({}, {}) to ({}, {})\n", info.low.x, info.low.y, info.high.x,
                       info.high.y);
    out += fmt::format("shortest edge: about {:.3g}, extent: about {:.3g}\n",
                       info.approx_shortest_edge, info.approx_extent);
    const auto id = [](VertexId v) { return to_string(v); };
    append_list(out, "touching bodies", info.contacts, show_contact);
    append_list(out, "places with several vertices", info.coincident,
                [&](const std::vector<VertexId>& vs) {
                    return fmt::format("{} at {}", vs.size(), id(vs.front()));
                });
    append_list(out, "pinch vertices", info.pinches, id);
    append_list(out, "straight vertices", info.straight, id);
    append_list(out, "nearly straight vertices", info.nearly_straight, id);
    append_list(out, "vertices on edges", info.vertices_on_edges, [&](const auto& pair) {
        return fmt::format("{} on {}", id(pair.first), to_string(pair.second));
    });
    const char* at_least = info.all_walls_compared ? "" : "at least ";
    if (info.crossing_walls > 0)
        out += fmt::format("crossing walls: {}{} pairs\n", at_least, info.crossing_walls);
    if (info.overlapping_walls > 0)
        out += fmt::format("overlapping walls: {}{} pairs\n", at_least, info.overlapping_walls);
    if (!info.is_degenerate()) out += "degeneracies: none\n";
    return out;
}

std::ostream& operator<<(std::ostream& out, const SceneInfo2& info) { return out << to_text(info); }

}  // namespace sightline
