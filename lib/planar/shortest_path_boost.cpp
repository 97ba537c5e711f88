// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths: Dijkstra in doubles from both ends leaves the few edges that can lie on a shortest
// path within the certified rounding error; among those, sums of square roots are compared exactly.
#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths_no_color_map.hpp>
#include <cfloat>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "planar/path_graph.hpp"
#include "planar/ray_walk.hpp"
#include "sightline/arith/square_roots.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/planar/shortest_path.hpp"

namespace sightline {
namespace detail {
namespace {

struct Length {
    double value;
};
using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Length>;

class Reached {};

// Ends the search when it comes to the far end: everything nearer is settled by then.
struct StopAt : boost::default_dijkstra_visitor {
    explicit StopAt(std::size_t end) : target(end) {}
    void examine_vertex(std::size_t v, const Graph& /*g*/) const {
        if (v == target) throw Reached{};
    }
    std::size_t target;
};

class PathSearch {
public:
    PathSearch(const ViewScene& view, const PathNodes& nodes, const PathGraph& graph,
               const RationalPoint2& from, const RationalPoint2& to)
        : view_(view), nodes_(nodes), graph_(graph), from_(from), to_(to) {}

    /// The nodes of a shortest path, ends included; empty when there is none.
    [[nodiscard]] std::vector<std::uint32_t> run();
    [[nodiscard]] RationalPoint2 position(std::uint32_t node) const {
        if (node == graph_.source) return from_;
        if (node == graph_.target) return to_;
        return view_.triangulation.exact_position(nodes_.place(node));
    }

private:
    using Chain = std::vector<std::uint32_t>;

    [[nodiscard]] std::vector<double> distances(const Graph& g, std::size_t from,
                                                std::size_t to) const;
    [[nodiscard]] Graph as_graph() const;
    [[nodiscard]] double approx_length(const PathEdge& e) const;
    [[nodiscard]] Point2 approx_position(std::uint32_t node) const {
        if (node == graph_.source) return approx_point(from_);
        if (node == graph_.target) return approx_point(to_);
        return view_.triangulation.position(nodes_.place(node));
    }
    [[nodiscard]] bool is_better(const Chain& a, const Chain& b) const;
    [[nodiscard]] std::vector<Rational> squares(const Chain& chain) const;
    [[nodiscard]] Chain extended(Chain chain, std::uint32_t node) const;
    [[nodiscard]] Chain settle(const std::vector<PathEdge>& arcs) const;

    const ViewScene& view_;
    const PathNodes& nodes_;
    const PathGraph& graph_;
    const RationalPoint2& from_;
    const RationalPoint2& to_;
};

double PathSearch::approx_length(const PathEdge& e) const {
    const Point2 a = approx_position(e.u);
    const Point2 b = approx_position(e.v);
    return std::hypot(a.x - b.x, a.y - b.y);
}

Graph PathSearch::as_graph() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
    std::vector<Length> lengths;
    arcs.reserve(2 * graph_.edges.size());
    lengths.reserve(2 * graph_.edges.size());
    for (const PathEdge& e : graph_.edges) {
        const Length length{approx_length(e)};
        arcs.emplace_back(e.u, e.v);
        arcs.emplace_back(e.v, e.u);
        lengths.insert(lengths.end(), {length, length});
    }
    return {boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), lengths.begin(),
            std::size_t{nodes_.count()} + 2};
}

std::vector<double> PathSearch::distances(const Graph& g, std::size_t from, std::size_t to) const {
    std::vector<double> distance(boost::num_vertices(g));
    const auto index = boost::get(boost::vertex_index, g);
    try {
        boost::dijkstra_shortest_paths_no_color_map(
            g, from,
            boost::weight_map(boost::get(&Length::value, g))
                .distance_map(boost::make_iterator_property_map(distance.begin(), index))
                .visitor(StopAt(to)));
    } catch (const Reached&) {  // NOLINT(bugprone-empty-catch): how a visitor ends the search
    }
    return distance;
}

std::vector<Rational> PathSearch::squares(const Chain& chain) const {
    std::vector<Rational> result;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const RationalPoint2 a = position(chain[i - 1]);
        const RationalPoint2 b = position(chain[i]);
        const Rational dx = b.x - a.x;
        const Rational dy = b.y - a.y;
        result.push_back(dx * dx + dy * dy);
    }
    return result;
}

// Shorter; or as short, with fewer vertices; or that too, and lexicographically less by vertex ids.
bool PathSearch::is_better(const Chain& a, const Chain& b) const {
    const std::vector<Rational> sa = squares(a);
    const std::vector<Rational> sb = squares(b);
    if (const Sign s = compare_sums_of_square_roots(sa, sb).sign; s != Sign::zero)
        return s == Sign::negative;
    if (a.size() != b.size()) return a.size() < b.size();
    const auto id = [&](std::uint32_t node) {
        return node >= nodes_.count() ? VertexId::none()
                                      : view_.triangulation.vertices_at(nodes_.place(node)).front();
    };
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [&](auto u, auto v) { return id(u) < id(v); });
}

// The chain, one node longer; where it goes straight on, its last node is no vertex of it any more.
PathSearch::Chain PathSearch::extended(Chain chain, std::uint32_t node) const {
    if (chain.size() > 1) {
        const RationalPoint2 a = position(chain[chain.size() - 2]);
        const RationalPoint2 b = position(chain.back());
        const RationalPoint2 c = position(node);
        if (orientation(a, b, c) == Sign::zero && (a < b) == (b < c)) chain.pop_back();
    }
    chain.push_back(node);
    return chain;
}

// The best chain to the end of each arc (sorted by the distance of their sources), relaxed until nothing
// changes: one round unless an arc is shorter than the rounding error. By arcs, not by nodes, since the
// arc decides whether the path goes straight on.
PathSearch::Chain PathSearch::settle(const std::vector<PathEdge>& arcs) const {
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> into;
    for (std::size_t i = 0; i < arcs.size(); ++i) into[arcs[i].v].push_back(i);
    std::vector<Chain> best(arcs.size());
    const auto offer = [&](std::size_t arc, Chain chain) {
        if (chain == best[arc] || (!best[arc].empty() && !is_better(chain, best[arc])))
            return false;
        best[arc] = std::move(chain);
        return true;
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < arcs.size(); ++i) {
            if (arcs[i].u == graph_.source) changed |= offer(i, {arcs[i].u, arcs[i].v});
            for (const std::size_t j : into[arcs[i].u])
                if (!best[j].empty()) changed |= offer(i, extended(best[j], arcs[i].v));
        }
    }
    Chain result;
    for (const std::size_t i : into[graph_.target])
        if (!best[i].empty() && (result.empty() || is_better(best[i], result))) result = best[i];
    return result;
}

std::vector<std::uint32_t> PathSearch::run() {
    const Graph g = as_graph();
    const std::vector<double> from = distances(g, graph_.source, graph_.target);
    const double length = from[graph_.target];
    if (length == std::numeric_limits<double>::max() || std::isinf(length)) return {};
    const std::vector<double> to = distances(g, graph_.target, graph_.source);
    // A difference of coordinates is rounded once, and a rounded end once more; hypot within 1 ulp; every
    // sum once. With k edges a computed length is within a factor 1 ± (k + 8) u of the true one.
    const double unit = DBL_EPSILON / 2 * (static_cast<double>(nodes_.count()) + 16);
    const double longest = length * (1 + 4 * unit) + DBL_MIN * 16;
    std::vector<PathEdge> arcs;
    for (const PathEdge& e : graph_.edges) {
        const double between = approx_length(e);
        if (from[e.u] + between + to[e.v] <= longest) arcs.push_back({e.u, e.v});
        if (from[e.v] + between + to[e.u] <= longest) arcs.push_back({e.v, e.u});
    }
    std::sort(arcs.begin(), arcs.end(),
              [&](const PathEdge& a, const PathEdge& b) { return from[a.u] < from[b.u]; });
    return settle(arcs);
}

// Adds the rest of a path that bends; false when there is none.
bool bend(const ViewScene& view, const Standpoint& source, const Standpoint& target,
          const ShortestPathOptions& options, ShortestPath& path, const RationalPoint2& to) {
    PathGraphBuilder builder(view, options);
    const PathGraph graph = builder.build(source, target);
    const RationalPoint2 from = path.points.front();
    PathSearch search(view, builder.nodes(), graph, from, to);
    const std::vector<std::uint32_t> chain = search.run();
    if (chain.empty()) return false;
    for (std::size_t i = 1; i < chain.size(); ++i) path.points.push_back(search.position(chain[i]));
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
        path.vertices.push_back(
            view.triangulation.vertices_at(builder.nodes().place(chain[i])).front());
    return true;
}

}  // namespace
}  // namespace detail

using namespace detail;

Result<ShortestPath> shortest_path(const Scene2& scene, const RationalPoint2& from,
                                   const RationalPoint2& to, const ShortestPathOptions& options) {
    const std::array<Point2, 2> ends{approx_point(from), approx_point(to)};
    for (const Point2& end : ends)
        if (auto fits = detail::check_size(end); !fits) return tl::unexpected(fits.error());
    const ViewScene view(scene, ends);
    const auto viewpoint = [](const RationalPoint2& exact, const Point2& rounded) {
        return to_rational(rounded) == exact ? Viewpoint{rounded}
                                             : Viewpoint{rounded, no_index, &exact};
    };
    const Result<Standpoint> source =
        stand_at(scene, view, viewpoint(from, ends[0]), options.tally);
    if (!source) return tl::unexpected(source.error());
    const Result<Standpoint> target = stand_at(scene, view, viewpoint(to, ends[1]), options.tally);
    if (!target) return tl::unexpected(target.error());
    ShortestPath path;
    path.points = {from};
    if (from != to) {
        if (RayWalk(view.triangulation, source->viewpoint, source->at, target->viewpoint)
                .reaches_target()) {
            path.points.push_back(to);
        } else if (!bend(view, *source, *target, options, path, to)) {
            return fail(
                Errc::unreachable,
                "no free path joins the two points; they lie in different parts of the free space");
        }
    }
    std::vector<Rational> squares;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const Rational dx = path.points[i].x - path.points[i - 1].x;
        const Rational dy = path.points[i].y - path.points[i - 1].y;
        squares.push_back(dx * dx + dy * dy);
    }
    path.length = sum_of_square_roots(squares);
    return path;
}

}  // namespace sightline
