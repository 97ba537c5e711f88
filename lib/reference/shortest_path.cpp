// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/shortest_path.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "reference/sight_line.hpp"
#include "sightline/arith/square_roots.hpp"

namespace sightline::reference {
namespace {

using Squares = std::vector<Rational>;  // squared lengths of segments

bool is_shorter(const Squares& a, const Squares& b) {
    return compare_sums_of_square_roots(a, b).sign == Sign::negative;
}
bool is_as_long(const Squares& a, const Squares& b) {
    return compare_sums_of_square_roots(a, b).sign == Sign::zero;
}

Rational squared_distance(const RationalPoint2& a, const RationalPoint2& b) {
    const Rational dx = b.x - a.x;
    const Rational dy = b.y - a.y;
    return dx * dx + dy * dy;
}

/// A place where a path can be: a vertex's (with the least id there), or an end.
struct Stop {
    Place place;
    VertexId id;  // none for the ends
    Picture picture;
};

/// At `stop`, having come in `sector` of it (at the ends of the path the sector says nothing).
struct State {
    std::size_t stop;
    std::size_t sector;
    friend auto operator<=>(const State&, const State&) = default;
};

struct Arc {
    State from;  // leaves in this sector
    State to;
    Rational squared_length;
};

class PathFinder {
public:
    PathFinder(const Scene2& scene, const RationalPoint2& from, const RationalPoint2& to);

    /// The places of the best path, ends included; empty when there is none.
    [[nodiscard]] std::vector<std::size_t> best();
    [[nodiscard]] const Stop& stop(std::size_t i) const { return stops_[i]; }

private:
    static constexpr std::size_t start = 0;
    static constexpr std::size_t goal = 1;

    void find_arcs(const Scene2& scene);
    void settle();
    [[nodiscard]] bool may_continue(const State& at, const Arc& arc) const;
    void extend(const State& at, std::vector<std::size_t>& chain);
    [[nodiscard]] std::vector<std::size_t> bends(const std::vector<std::size_t>& chain) const;
    [[nodiscard]] bool is_better(const std::vector<std::size_t>& a,
                                 const std::vector<std::size_t>& b) const;

    std::vector<Stop> stops_;
    std::vector<Arc> arcs_;
    std::map<State, Squares> distance_;  // from the start, of states reached
    std::vector<std::size_t> best_;
};

PathFinder::PathFinder(const Scene2& scene, const RationalPoint2& from, const RationalPoint2& to) {
    stops_.push_back({from, VertexId::none(), picture_at(scene, from)});
    stops_.push_back({to, VertexId::none(), picture_at(scene, to)});
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        const Place place = scene[VertexId{i}];
        const bool is_known = std::any_of(stops_.begin(), stops_.end(),
                                          [&](const Stop& s) { return s.place == place; });
        if (is_known || is_interior(scene, place)) continue;
        stops_.push_back({place, VertexId{i}, picture_at(scene, place)});
    }
    find_arcs(scene);
    settle();
}

void PathFinder::find_arcs(const Scene2& scene) {
    const Everything everything(scene);
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        for (std::size_t j = 0; j < stops_.size(); ++j) {
            if (i == j || j == start || i == goal) continue;
            const Place& p = stops_[i].place;
            const Place& q = stops_[j].place;
            const SightLine line(scene, everything.candidates(), p, q, Reach::segment);
            if (!line.is_free()) continue;
            const Rational length = squared_distance(p.rational(), q.rational());
            const auto add = [&](std::size_t leaves, std::size_t comes) {
                arcs_.push_back({{i, leaves}, {j, j == goal ? 0 : comes}, length});
            };
            if (i == start && j == goal) {
                add(0, 0);
            } else if (!line.passes_vertex()) {
                for (const auto& way : line.ways()) add(way.from, way.to);
            }
        }
    }
}

bool PathFinder::may_continue(const State& at, const Arc& arc) const {
    if (arc.from.stop != at.stop) return false;
    if (at.stop == start) return true;
    return stops_[at.stop].picture.may_pass(at.sector, arc.from.sector);
}

// Dijkstra's algorithm, the obvious way.
void PathFinder::settle() {
    std::map<State, Squares> open{{State{start, 0}, {}}};
    while (!open.empty()) {
        const auto nearest = std::min_element(
            open.begin(), open.end(),
            [](const auto& a, const auto& b) { return is_shorter(a.second, b.second); });
        const auto [state, length] = *nearest;
        open.erase(nearest);
        distance_[state] = length;
        for (const Arc& arc : arcs_) {
            if (!may_continue(state, arc) || distance_.contains(arc.to)) continue;
            Squares longer = length;
            longer.push_back(arc.squared_length);
            const auto [known, is_new] = open.emplace(arc.to, longer);
            if (!is_new && is_shorter(longer, known->second)) known->second = longer;
        }
    }
}

// All shortest paths, backwards from the goal: the best of them is kept.
void PathFinder::extend(const State& at, std::vector<std::size_t>& chain) {
    chain.push_back(at.stop);
    if (at.stop == start) {
        std::vector<std::size_t> path = bends({chain.rbegin(), chain.rend()});
        if (best_.empty() || is_better(path, best_)) best_ = std::move(path);
    }
    for (const Arc& arc : arcs_) {
        if (arc.to != at) continue;
        for (const auto& [before, length] : distance_) {
            if (!may_continue(before, arc)) continue;
            Squares longer = length;
            longer.push_back(arc.squared_length);
            if (is_as_long(longer, distance_.at(at))) extend(before, chain);
        }
    }
    chain.pop_back();
}

std::vector<std::size_t> PathFinder::best() {
    std::vector<std::size_t> chain;
    if (distance_.contains({goal, 0})) extend({goal, 0}, chain);
    return best_;
}

std::vector<std::size_t> PathFinder::bends(const std::vector<std::size_t>& chain) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (i > 0 && i + 1 < chain.size()) {
            const Place& a = stops_[chain[i - 1]].place;
            const Place& b = stops_[chain[i]].place;
            const Place& c = stops_[chain[i + 1]].place;
            if (side(a, b, c) == Sign::zero && is_between(a, c, b)) continue;
        }
        result.push_back(chain[i]);
    }
    return result;
}

bool PathFinder::is_better(const std::vector<std::size_t>& a,
                           const std::vector<std::size_t>& b) const {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(),
        [this](std::size_t i, std::size_t j) { return stops_[i].id < stops_[j].id; });
}

}  // namespace

Result<ShortestPath> shortest_path(const Scene2& scene, const RationalPoint2& from,
                                   const RationalPoint2& to, const ShortestPathOptions&) {
    for (const RationalPoint2& end : {from, to}) {
        if (is_interior(scene, end)) return tl::unexpected(inside_error(scene, end));
    }
    ShortestPath path;
    path.points.push_back(from);
    Squares squares;
    if (from != to) {
        PathFinder finder(scene, from, to);
        const std::vector<std::size_t> stops = finder.best();
        if (stops.empty()) {
            return fail(
                Errc::unreachable,
                "no free path joins the two points; they lie in different parts of the free space");
        }
        for (std::size_t i = 1; i < stops.size(); ++i) {
            const Stop& stop = finder.stop(stops[i]);
            squares.push_back(squared_distance(path.points.back(), stop.place.rational()));
            path.points.push_back(stop.place.rational());
            if (!stop.id.is_none()) path.vertices.push_back(stop.id);
        }
    }
    path.length = sum_of_square_roots(squares);
    return path;
}

}  // namespace sightline::reference
