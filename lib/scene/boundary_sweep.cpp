// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/boundary_sweep.hpp"

#include <algorithm>
#include <set>

#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

/// An edge from its lexicographically lesser end to the greater one.
struct SweepEdge {
    Point2 low;
    Point2 high;
    Owner owner = free_space;
    bool solid_above = false;

    [[nodiscard]] Owner above() const noexcept { return solid_above ? owner : free_space; }
    [[nodiscard]] Owner below() const noexcept { return solid_above ? free_space : owner; }
    /// positive: p lies above the edge's line.
    [[nodiscard]] Sign side(const Point2& p) const { return orientation(low, high, p); }
};

/// Mutable, so that the edge that continues a chain takes the node of the one
/// that ended.
struct Slot {
    mutable std::uint32_t edge;
};

struct StatusOrder {
    using is_transparent = void;
    const std::vector<SweepEdge>* edges;

    /// Whether a lies below b just right of where both have begun; ties: solid
    /// below comes first.
    bool operator()(const Slot& a, const Slot& b) const {
        const SweepEdge& e = (*edges)[a.edge];
        const SweepEdge& f = (*edges)[b.edge];
        if (e.low < f.low) {
            const Sign s = e.side(f.low);
            if (s != Sign::zero) return s == Sign::positive;
            const Sign t = e.side(f.high);
            if (t != Sign::zero) return t == Sign::positive;
        } else {
            const Sign s = f.side(e.low);
            if (s != Sign::zero) return s == Sign::negative;
            const Sign t = f.side(e.high);
            if (t != Sign::zero) return t == Sign::negative;
        }
        if (e.solid_above != f.solid_above) return !e.solid_above;
        return a.edge < b.edge;
    }
    bool operator()(const Slot& a, const Point2& p) const {
        return (*edges)[a.edge].side(p) == Sign::positive;
    }
    bool operator()(const Point2& p, const Slot& a) const {
        return (*edges)[a.edge].side(p) == Sign::negative;
    }
};

class BoundarySweep {
public:
    BoundarySweep(std::span<const Point2> vertices, std::span<const Edge2> edges, bool has_world,
                  bool collect_touches)
        : vertices_(vertices),
          edges_(edges),
          outside_(has_world ? world_solid : free_space),
          collect_touches_(collect_touches),
          status_(StatusOrder{&sweep_edges_}) {
        prepare_edges();
        prepare_events();
    }

    SweepResult run() {
        for (std::size_t i = 0; i < events_.size() && !result_.fault;) {
            std::size_t j = i + 1;
            while (j < events_.size() && events_[j].point == events_[i].point) ++j;
            if (j - i > 1 || !continue_chain(events_[i])) handle_place(i, j);
            i = j;
        }
        return std::move(result_);
    }

private:
    using Status = std::set<Slot, StatusOrder>;
    using Position = Status::iterator;
    struct Event {
        Point2 point;
        std::uint32_t vertex;
    };

    void prepare_edges() {
        sweep_edges_.resize(edges_.size());
        in_edge_.assign(vertices_.size(), no_edge);
        out_edge_.assign(vertices_.size(), no_edge);
        where_.resize(edges_.size());
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const Edge2& e = edges_[i];
            if (e.kind == EdgeKind2::wall) continue;
            out_edge_[e.source.index()] = i;
            in_edge_[e.target.index()] = i;
            const Point2& s = vertices_[e.source.index()];
            const Point2& t = vertices_[e.target.index()];
            const bool rightwards = s < t;
            sweep_edges_[i] = {rightwards ? s : t, rightwards ? t : s, owner_of(e), rightwards};
        }
    }

    void prepare_events() {
        events_.resize(vertices_.size());
        for (std::uint32_t v = 0; v < vertices_.size(); ++v) events_[v] = {vertices_[v], v};
        std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
            if (a.point.x != b.point.x) return a.point.x < b.point.x;
            if (a.point.y != b.point.y) return a.point.y < b.point.y;
            return a.vertex < b.vertex;
        });
    }

    [[nodiscard]] const SweepEdge& edge(std::uint32_t e) const { return sweep_edges_[e]; }
    [[nodiscard]] const SweepEdge& edge(Position it) const { return sweep_edges_[it->edge]; }
    [[nodiscard]] bool contains(Position it, const Point2& p) const {
        return edge(it).side(p) == Sign::zero;
    }

    void report(SweepFault::Kind kind, std::uint32_t first, std::uint32_t second,
                std::uint32_t vertex) {
        if (!result_.fault) result_.fault = SweepFault{kind, first, second, VertexId{vertex}};
    }

    /// The common case: one edge ends, one starts, and nothing else is there.
    bool continue_chain(const Event& event) {
        std::uint32_t ending = in_edge_[event.vertex];
        std::uint32_t starting = out_edge_[event.vertex];
        if (ending == no_edge) return false;
        if (edge(ending).high != event.point) std::swap(ending, starting);
        if (edge(ending).high != event.point || edge(starting).low != event.point) return false;
        const Position it = where_[ending];
        const Position above = std::next(it);
        if (above != status_.end() && contains(above, event.point)) return false;
        if (it != status_.begin() && contains(std::prev(it), event.point)) return false;
        it->edge = starting;
        where_[starting] = it;
        if (it != status_.begin()) check_crossing(std::prev(it), it, event.vertex);
        if (above != status_.end()) check_crossing(it, above, event.vertex);
        return true;
    }

    void handle_place(std::size_t first, std::size_t last) {
        const Point2& p = events_[first].point;
        gather(first, last);
        const auto [low, high] = range_at(p);
        left_.clear();
        for (Position it = low; it != high; ++it) left_.push_back(it->edge);
        right_ = starting_;
        std::size_t passing = 0;
        for (const std::uint32_t e : left_) {
            if (edge(e).high == p) continue;
            right_.push_back(e);
            ++passing;
        }
        // A missed crossing is the only way to lose an edge, and none is missed.
        SIGHTLINE_EXPECT(left_.size() == passing + ending_);
        status_.erase(low, high);
        insert_right(p, high, events_[first].vertex);
        if (result_.fault) return;
        check_chains(p, first, last);
        locate_loose_vertices(p, first, last, high);
        if (collect_touches_) collect(first, last);
    }

    void gather(std::size_t first, std::size_t last) {
        starting_.clear();
        ending_ = 0;
        anchor_ = no_edge;
        for (std::size_t i = first; i < last; ++i) {
            for (const std::uint32_t e :
                 {in_edge_[events_[i].vertex], out_edge_[events_[i].vertex]}) {
                if (e == no_edge) continue;
                if (edge(e).low == events_[i].point) {
                    starting_.push_back(e);
                } else {
                    ++ending_;
                    anchor_ = e;
                }
            }
        }
    }

    /// The edges of the status that contain p, found from one that ends there
    /// when there is one.
    std::pair<Position, Position> range_at(const Point2& p) {
        Position low = anchor_ != no_edge ? where_[anchor_] : status_.lower_bound(p);
        Position high = low;
        while (high != status_.end() && contains(high, p)) ++high;
        while (low != status_.begin() && contains(std::prev(low), p)) --low;
        return {low, high};
    }

    void insert_right(const Point2& p, Position above, std::uint32_t vertex) {
        std::sort(right_.begin(), right_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Sign s = orientation(p, edge(a).high, edge(b).high);
            if (s != Sign::zero) return s == Sign::positive;
            if (edge(a).solid_above != edge(b).solid_above) return !edge(a).solid_above;
            return a < b;
        });
        const bool has_below = above != status_.begin();
        const Position below = has_below ? std::prev(above) : above;
        std::uint32_t previous = has_below ? below->edge : no_edge;
        Owner region = has_below ? edge(below).above() : outside_;
        for (std::size_t i = 1; i < right_.size(); ++i) {
            if (!overlaps_wrongly(p, right_[i - 1], right_[i])) continue;
            return report(SweepFault::Kind::overlap, right_[i - 1], right_[i], vertex);
        }
        for (const std::uint32_t e : right_) {
            if (edge(e).below() != region) {
                return report(SweepFault::Kind::mismatch, previous, e, vertex);
            }
            region = edge(e).above();
            previous = e;
            where_[e] = status_.insert(above, Slot{e});
        }
        const std::uint32_t next = above == status_.end() ? no_edge : above->edge;
        if ((next == no_edge ? outside_ : edge(next).below()) != region) {
            return report(SweepFault::Kind::mismatch, previous, next, vertex);
        }
        if (right_.empty()) {
            if (has_below && next != no_edge) check_crossing(below, above, vertex);
            return;
        }
        if (has_below) check_crossing(below, where_[right_.front()], vertex);
        if (next != no_edge) check_crossing(where_[right_.back()], above, vertex);
    }

    [[nodiscard]] bool overlaps_wrongly(const Point2& p, std::uint32_t a, std::uint32_t b) {
        if (orientation(p, edge(a).high, edge(b).high) != Sign::zero) return false;
        if (edge(a).owner == edge(b).owner || edge(a).solid_above == edge(b).solid_above)
            return true;
        if (collect_touches_) result_.overlaps.emplace_back(std::min(a, b), std::max(a, b));
        return false;
    }

    /// e lies below f here; they cross when that is no longer so where the first
    /// of them ends.
    void check_crossing(Position below, Position above, std::uint32_t vertex) {
        const SweepEdge& e = edge(below);
        const SweepEdge& f = edge(above);
        const bool crosses =
            e.high < f.high ? f.side(e.high) == Sign::positive : e.side(f.high) == Sign::negative;
        if (crosses) report(SweepFault::Kind::crossing, below->edge, above->edge, vertex);
    }

    /// With three corners or more of one body at a place the sides can all fit
    /// although the rings cross: going round, their corners must close like
    /// brackets.
    void check_chains(const Point2& p, std::size_t first, std::size_t last) {
        if (last - first < 3) return;
        std::vector<std::pair<std::uint32_t, std::uint32_t>>
            round;  // (edge, chain), counter-clockwise
        round.reserve(right_.size() + left_.size());
        for (const std::uint32_t e : right_) round.emplace_back(e, chain_of(e, p));
        for (const std::uint32_t e : left_) round.emplace_back(e, chain_of(e, p));
        // Left-going edges stand bottom to top; counter-clockwise after the right
        // ones is top to bottom.
        std::reverse(round.begin() + static_cast<std::ptrdiff_t>(right_.size()), round.end());
        std::vector<Owner> owners;
        owners.reserve(round.size());
        for (const auto& [e, chain] : round) owners.push_back(edge(e).owner);
        std::sort(owners.begin(), owners.end());
        owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
        for (const Owner owner : owners) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
            for (const auto& [e, chain] : round) {
                if (edge(e).owner != owner) continue;
                if (!open.empty() && open.back().second == chain) {
                    open.pop_back();
                } else {
                    open.emplace_back(e, chain);
                }
            }
            if (open.empty()) continue;
            return report(SweepFault::Kind::chains_cross, open[0].first, open[1].first,
                          events_[first].vertex);
        }
    }

    /// The two edges of one chain through p have the same number: the vertex
    /// there, or the edge itself.
    [[nodiscard]] std::uint32_t chain_of(std::uint32_t e, const Point2& p) const {
        const Edge2& original = edges_[e];
        if (vertices_[original.source.index()] == p) return original.source.value;
        if (vertices_[original.target.index()] == p) return original.target.value;
        return static_cast<std::uint32_t>(vertices_.size()) + e;
    }

    void locate_loose_vertices(const Point2& p, std::size_t first, std::size_t last,
                               Position above) {
        Owner owner = free_space;
        bool known = false;
        for (std::size_t i = first; i < last; ++i) {
            if (out_edge_[events_[i].vertex] != no_edge) continue;
            if (!known) owner = owner_round(p, above);
            known = true;
            if (owner == free_space) continue;
            const bool on_boundary = !left_.empty() || !right_.empty();
            result_.inside.push_back({VertexId{events_[i].vertex}, owner, on_boundary});
        }
    }

    /// When all of a neighbourhood of p is solid: the least of its owners; free_space otherwise.
    [[nodiscard]] Owner owner_round(const Point2& p, Position above) const {
        const auto lowest = right_.empty() ? above : where_[right_.front()];
        Owner least = lowest == status_.begin() ? outside_ : edge(std::prev(lowest)).above();
        if (least == free_space) return free_space;
        for (const std::vector<std::uint32_t>* side : {&right_, &left_}) {
            const auto end_of = [&](std::uint32_t e) {
                return side == &right_ ? edge(e).high : edge(e).low;
            };
            for (std::size_t i = 0; i < side->size(); ++i) {
                const bool sealed =
                    i + 1 < side->size() &&
                    orientation(p, end_of((*side)[i]), end_of((*side)[i + 1])) == Sign::zero;
                if (sealed) continue;
                const Owner owner = edge((*side)[i]).above();
                if (owner == free_space) return free_space;
                least = std::min(least, owner);
            }
        }
        return least;
    }

    void collect(std::size_t first, std::size_t last) {
        SweepTouch touch;
        for (std::size_t i = first; i < last; ++i) {
            if (out_edge_[events_[i].vertex] != no_edge)
                touch.vertices.push_back(VertexId{events_[i].vertex});
        }
        for (const std::uint32_t e : left_) {
            if (edge(e).high != events_[first].point) touch.passing.push_back(e);
        }
        std::sort(touch.passing.begin(), touch.passing.end());
        if (touch.vertices.size() + touch.passing.size() > 1 && !touch.vertices.empty()) {
            result_.touches.push_back(std::move(touch));
        }
    }

    std::span<const Point2> vertices_;
    std::span<const Edge2> edges_;
    Owner outside_;
    bool collect_touches_;
    std::vector<SweepEdge> sweep_edges_;
    std::vector<std::uint32_t> in_edge_;
    std::vector<std::uint32_t> out_edge_;
    std::vector<Position> where_;
    std::vector<Event> events_;
    Status status_;
    SweepResult result_;
    // Of the place being handled; members only to keep their storage.
    std::vector<std::uint32_t> starting_;
    std::vector<std::uint32_t> left_;
    std::vector<std::uint32_t> right_;
    std::size_t ending_ = 0;
    std::uint32_t anchor_ = no_edge;
};

}  // namespace

SweepResult sweep_boundaries(std::span<const Point2> vertices, std::span<const Edge2> edges,
                             bool has_world, bool collect_touches) {
    return BoundarySweep(vertices, edges, has_world, collect_touches).run();
}

}  // namespace sightline::detail
