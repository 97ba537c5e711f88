// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/path_graph.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>

#include "planar/graph_rows.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

PathNodes::PathNodes(const Triangulation& t) : t_(t) {
    first_.reserve(t.place_count() + 1);
    for (Place p = 0; p < t.place_count(); ++p) {
        first_.push_back(static_cast<std::uint32_t>(place_.size()));
        if (!t.is_scene_place(p)) continue;
        if (t.has_walls() && !t.is_pinch(p))
            add_sectors(p);
        else
            place_.push_back(p);
    }
    first_.push_back(static_cast<std::uint32_t>(place_.size()));
    std::sort(sector_.begin(), sector_.end(),
              [](const Sector& a, const Sector& b) { return a.half_edge < b.half_edge; });
}

// Sectors are parted by walls and by B. At a pinch B parts them already, and a pinhole is open.
void PathNodes::add_sectors(Place p) {
    const auto parts =
        [&](HalfEdge h) {  // whether h and the triangle before it lie in different sectors
            return t_.is_wall(h) || t_.is_free(h) != t_.is_free(t_.twin(h));
        };
    HalfEdge start = t_.leaving(p);
    const HalfEdge first = start;
    do {
        if (parts(start)) break;
        start = t_.rotate_ccw(start);
    } while (start != first);
    const std::size_t before = sector_.size();
    auto node = static_cast<std::uint32_t>(place_.size());
    bool started = false;
    HalfEdge h = start;
    do {
        if (t_.is_free(h)) {
            if (started && parts(h)) ++node;
            started = true;
            sector_.push_back({h, node});
        }
        h = t_.rotate_ccw(h);
    } while (h != start);
    place_.resize(node + 1, p);
    if (place_.size() - first_[p] == 1) sector_.resize(before);
}

std::uint32_t PathNodes::node_of(HalfEdge h) const {
    const auto it = std::lower_bound(sector_.begin(), sector_.end(), h,
                                     [](const Sector& a, HalfEdge b) { return a.half_edge < b; });
    SIGHTLINE_EXPECT(it != sector_.end() && it->half_edge == h);
    return it->node;
}

std::array<std::uint32_t, 2> PathNodes::towards(Place p, const Viewpoint& q,
                                                ConeSigns& signs) const {
    if (sectors(p) <= 1 && !t_.has_constructed()) return {first_[p], first_[p]};
    // Around p: on which side of the line q→p each neighbour lies. Left of it is right of p→q.
    Limit ray;
    ray.place = p;
    ray.x = t_.position(p).x - q.position.x;
    ray.y = t_.position(p).y - q.position.y;
    const auto side = [&](Place x) { return -signs.certain_side(q, ray, x); };
    const auto is_towards = [&](Place x) {  // for x on the line
        if (x == q.place) return true;
        const RationalPoint2 at = t_.exact_position(p);
        const RationalPoint2 to = signs.exact_position(q);
        return (at < t_.exact_position(x)) == (at < to);
    };
    const HalfEdge start = t_.leaving(p);
    HalfEdge h = start;
    do {
        const Place x = t_.target(h);
        const Sign sx = side(x);
        if (sx == Sign::zero && is_towards(x)) {
            // Along a wall as far as another one that crosses it: no path goes on from there.
            if (!t_.is_scene_place(x) && t_.is_wall(h) && x != q.place) return {no_index, no_index};
            if (sectors(p) == 1) return {first_[p], first_[p]};
            const HalfEdge g = t_.twin(h);
            const HalfEdge right = next(g);  // leaves p, on the right of h
            const std::uint32_t left_node = t_.is_free(h) ? node_of(h) : node_of(right);
            return {left_node, t_.is_free(g) ? node_of(right) : left_node};
        }
        if (sectors(p) > 1 && sx == Sign::negative && side(t_.apex(h)) == Sign::positive)
            return {node_of(h), node_of(h)};
        h = t_.rotate_ccw(h);
    } while (h != start);
    return {first_[p], first_[p]};
}

// What one thread works with.
struct PathGraphBuilder::Worker {
    explicit Worker(const PathGraphBuilder& b)
        : rows(b.view_.triangulation, b.view_.crossings, &b.corners_,
               {.tangent_only = true, .arithmetic = b.options_.arithmetic}),
          signs(b.view_.triangulation, b.options_.arithmetic) {}

    void add_to(Tally* tally) const {
        if (tally == nullptr) return;
        rows.add_to(*tally);
        signs.add_to(*tally);
    }

    GraphRows rows;
    ConeSigns signs;
    std::vector<Place> row;
};

PathGraphBuilder::PathGraphBuilder(const ViewScene& view, const ShortestPathOptions& options)
    : view_(view),
      options_(options),
      nodes_(view.triangulation),
      corners_(view.triangulation, Corners::General::any_direction),
      signs_(view.triangulation, options.arithmetic) {}

PathGraph PathGraphBuilder::build(const Standpoint& from, const Standpoint& to) {
    PathGraph graph;
    graph.source = nodes_.count();
    graph.target = nodes_.count() + 1;
    add_tangents(graph);
    add_end(graph, from, graph.source);
    add_end(graph, to, graph.target);
    if (options_.tally != nullptr) signs_.add_to(*options_.tally);
    return graph;
}

// Blocks of places, in parallel when asked; the edges keep the order of the places.
void PathGraphBuilder::add_tangents(PathGraph& graph) {
    constexpr Place block = 256;
    const Place end = view_.triangulation.first_constructed();
    std::vector<std::vector<PathEdge>> found((end - frame_places + block - 1) / block);
    const auto fill = [&](std::size_t i, Worker& worker) {
        const Place begin = frame_places + static_cast<Place>(i) * block;
        for (Place u = begin; u < std::min(begin + block, end); ++u) {
            worker.row.clear();
            worker.rows.append(u, worker.row);
            for (const Place w : worker.row) add_between(u, w, worker.signs, found[i]);
        }
    };
    if (options_.threads == 1) {
        Worker worker(*this);
        for (std::size_t i = 0; i < found.size(); ++i) fill(i, worker);
        worker.add_to(options_.tally);
    } else {
        tbb::task_arena arena(options_.threads == 0 ? tbb::task_arena::automatic
                                                    : static_cast<int>(options_.threads));
        arena.execute([&] {
            tbb::enumerable_thread_specific<std::unique_ptr<Worker>> workers;
            tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
                auto& worker = workers.local();
                if (!worker) worker = std::make_unique<Worker>(*this);
                fill(i, *worker);
            });
            for (const auto& worker : workers) worker->add_to(options_.tally);
        });
    }
    for (const auto& edges : found)
        graph.edges.insert(graph.edges.end(), edges.begin(), edges.end());
}

void PathGraphBuilder::add_between(Place u, Place w, ConeSigns& signs,
                                   std::vector<PathEdge>& out) const {
    const Triangulation& t = view_.triangulation;
    const auto at_u = nodes_.towards(u, {t.position(w), w}, signs);
    const auto at_w = nodes_.towards(w, {t.position(u), u}, signs);
    if (at_u[0] == no_index || at_w[0] == no_index) return;
    // What is left seen from one end is right seen from the other.
    out.push_back({at_u[0], at_w[1]});
    if (at_u[1] != at_u[0] || at_w[0] != at_w[1]) out.push_back({at_u[1], at_w[0]});
}

// The edges from an end of the path to the vertices that it sees.
void PathGraphBuilder::add_end(PathGraph& graph, const Standpoint& end, std::uint32_t node) {
    VisiblePlaces visible(view_.triangulation, view_.crossings, options_.arithmetic);
    for (const Place w : visible.from(end.viewpoint, end.at)) {
        if (w == end.viewpoint.place || !corners_.is_tangent(end.viewpoint, w, signs_)) continue;
        const auto at_w = nodes_.towards(w, end.viewpoint, signs_);
        if (at_w[0] == no_index) continue;
        graph.edges.push_back({node, at_w[0]});
        if (at_w[1] != at_w[0]) graph.edges.push_back({node, at_w[1]});
    }
    if (options_.tally != nullptr) visible.add_to(*options_.tally);
}

}  // namespace sightline::detail
