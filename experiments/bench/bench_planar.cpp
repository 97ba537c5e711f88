// SPDX-License-Identifier: GPL-3.0-or-later
// Planar structures on our own families, and CGAL's triangular expansion beside them as the yardstick.
//
// Names: graph/<family>/<n>/<full|tangent>/<nearest|all>/<arithmetic>/<threads>,
//        view/<family>/<n>[/exact|/canonical], path/…, triangulation/…, sort_directions/…, cgal_every_vertex/…,
//        cgal_view/…
// Times of one thread are processor time, those of two elapsed time.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "common/expansion_cgal.hpp"
#include "common/measure.hpp"
#include "common/scenes.hpp"
#include "geom/orientation_tiers.hpp"
#include "planar/triangulation.hpp"
#include "sightline/planar/exact_points.hpp"
#include "sightline/planar/shortest_path.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline {
namespace {

using benchmark::State;

constexpr std::uint64_t seed = 1;
constexpr std::size_t query_count = 500;

// Scenes live as long as the program: a benchmark is run several times.
const Scene2& scene_of(const std::string& family, std::size_t n) {
    static std::map<std::pair<std::string, std::size_t>, std::unique_ptr<const Scene2>> scenes;
    auto& scene = scenes[{family, n}];
    if (!scene) {
        scene = std::make_unique<const Scene2>(
            Scene2::make(experiments::family_scene(family, n, seed)).value());
    }
    return *scene;
}

void graph(State& state, const std::string& family, std::size_t n,
           const VisibilityGraphOptions& options) {
    const Scene2& scene = scene_of(family, n);
    std::size_t edges = 0;
    for (auto _ : state) {
        const VisibilityGraph g = visibility_graph(scene, options);
        edges = g.edge_count();
        benchmark::DoNotOptimize(edges);
    }
    state.counters["vertices"] = static_cast<double>(scene.vertex_count());
    state.counters["edges"] = static_cast<double>(edges);
    state.counters["s_per_edge"] = benchmark::Counter(
        static_cast<double>(edges),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// What every angular sweep starts with: the vertices of a half-plane round each vertex, sorted by
// direction with the exact filtered predicate. No sweep can be faster than this.
void sort_directions(State& state, const std::string& family, std::size_t n) {
    const std::span<const Point2> points = scene_of(family, n).vertices();
    std::vector<Point2> around;
    for (auto _ : state) {
        for (const Point2& v : points) {
            around.clear();
            for (const Point2& p : points)
                if (v < p) around.push_back(p);
            std::sort(around.begin(), around.end(), [&v](const Point2& p, const Point2& q) {
                return detail::orientation(v, p, q).sign == Sign::positive;
            });
            benchmark::DoNotOptimize(around.data());
        }
    }
}

enum class Coordinates { none, exact, canonical };

void view(State& state, const std::string& family, std::size_t n, Coordinates coordinates) {
    const Scene2& scene = scene_of(family, n);
    const auto points = experiments::free_points(scene, query_count, seed);
    const PointVisibility2 visibility(scene);
    VisibilityPolygon polygon;
    std::size_t i = 0;
    std::size_t corners = 0;
    for (auto _ : state) {
        const Point2& q = points[i++ % points.size()];
        if (!visibility.from(q, {}, polygon)) state.SkipWithError("a point in B");
        corners += polygon.ring.size();
        if (coordinates == Coordinates::exact)
            benchmark::DoNotOptimize(visibility.exact_points(polygon));
        if (coordinates == Coordinates::canonical)
            benchmark::DoNotOptimize(exact_ring(scene, polygon));
    }
    state.counters["corners"] =
        benchmark::Counter(static_cast<double>(corners), benchmark::Counter::kAvgIterations);
}

void path(State& state, const std::string& family, std::size_t n) {
    const Scene2& scene = scene_of(family, n);
    const auto points = experiments::free_points(scene, 2, seed);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            shortest_path(scene, to_rational(points[0]), to_rational(points[1])));
    }
}

void triangulation(State& state, const std::string& family, std::size_t n) {
    const Scene2& scene = scene_of(family, n);
    for (auto _ : state) {
        const detail::Triangulation t(scene);
        benchmark::DoNotOptimize(t.triangle_count());
    }
}

void cgal_every_vertex(State& state, const std::string& family, std::size_t n) {
    experiments::CgalExpansion expansion(scene_of(family, n));
    for (auto _ : state) {
        expansion.attach();
        benchmark::DoNotOptimize(expansion.from_every_vertex());
    }
}

void cgal_view(State& state, const std::string& family, std::size_t n) {
    const Scene2& scene = scene_of(family, n);
    const auto points = experiments::free_points(scene, query_count, seed);
    experiments::CgalExpansion expansion(scene);
    expansion.locate(points);
    expansion.attach();
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(expansion.from_point(i++ % points.size()));
}

// ---- what is run ---------------------------------------------------------------------------------

struct Family {
    const char* name;
    std::size_t largest;      // for the nearest neighbours
    std::size_t largest_all;  // for all: edges grow faster
    bool world;               // bounded and without walls: CGAL can be asked
};

const Family all_families[] = {
    {"dense", 100000, 100000, true},     {"sparse", 10000, 10000, true},
    {"grid", 100000, 10000, false},      {"rotated_grid", 100000, 10000, false},
    {"floor_plan", 100000, 10000, true}, {"needles", 10000, 10000, false},
};

template <typename Function>
benchmark::internal::Benchmark* add(const std::string& name, Function function) {
    return benchmark::RegisterBenchmark(name.c_str(), function);
}

void add_graphs(const Family& family, std::size_t n) {
    const std::string name = family.name;
    for (const bool tangent : {false, true}) {
        for (const Collinear rule : {Collinear::nearest_only, Collinear::every_vertex}) {
            if (rule == Collinear::every_vertex && n > family.largest_all) continue;
            for (const Arithmetic arithmetic : {Arithmetic::filtered, Arithmetic::double_}) {
                for (const unsigned threads : {1U, 2U}) {
                    if (threads == 2 && (arithmetic != Arithmetic::filtered || n < 10000)) continue;
                    const std::string label =
                        "graph/" + name + "/" + std::to_string(n) +
                        (tangent ? "/tangent" : "/full") +
                        (rule == Collinear::nearest_only ? "/nearest" : "/all") +
                        (arithmetic == Arithmetic::filtered ? "/filtered/" : "/double/") +
                        std::to_string(threads);
                    auto* b = add(label, [=](State& state) {
                        graph(state, name, n,
                              {.collinear = rule,
                               .tangent_only = tangent,
                               .arithmetic = arithmetic,
                               .threads = threads});
                    });
                    b->Unit(benchmark::kMillisecond);
                    if (threads > 1) b->UseRealTime();
                }
            }
        }
    }
}

void add_rest(const Family& family, std::size_t n) {
    const std::string name = family.name;
    const std::string label = "/" + name + "/" + std::to_string(n);
    add("triangulation" + label, [=](State& s) {
        triangulation(s, name, n);
    })->Unit(benchmark::kMillisecond);
    add("view" + label, [=](State& s) {
        view(s, name, n, Coordinates::none);
    })->Unit(benchmark::kMicrosecond);
    add("view" + label + "/exact", [=](State& s) {
        view(s, name, n, Coordinates::exact);
    })->Unit(benchmark::kMicrosecond);
    add("view" + label + "/canonical", [=](State& s) {
        view(s, name, n, Coordinates::canonical);
    })->Unit(benchmark::kMicrosecond);
    if (n <= 10000) {
        add("path" + label, [=](State& s) { path(s, name, n); })->Unit(benchmark::kMillisecond);
    }
    if (!family.world || n > 10000) return;
    add("cgal_view" + label, [=](State& s) {
        cgal_view(s, name, n);
    })->Unit(benchmark::kMicrosecond);
    if (n > 1000) return;
    add("sort_directions" + label, [=](State& s) {
        sort_directions(s, name, n);
    })->Unit(benchmark::kMillisecond);
    add("cgal_every_vertex" + label, [=](State& s) {
        cgal_every_vertex(s, name, n);
    })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
    for (const Family& family : all_families) {
        for (std::size_t n = 100; n <= family.largest; n *= 10) {
            add_graphs(family, n);
            add_rest(family, n);
        }
    }
    return true;
}();

}  // namespace
}  // namespace sightline
