// SPDX-License-Identifier: GPL-3.0-or-later
// Acceptance on maps: exact counts, times beside CGAL's, and robustness after rounded transforms.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "02-maps2d/maps.hpp"
#include "common/edge_difference.hpp"
#include "common/expansion_cgal.hpp"
#include "common/measure.hpp"
#include "common/scenes.hpp"
#include "common/table.hpp"
#include "sightline/planar/exact_points.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/reference/visibility_graph.hpp"

namespace sightline::experiments {
namespace {

struct Options {
    std::string data;
    std::string out;
    std::vector<std::string> maps;
    std::size_t rows = 200;
    std::size_t queries = 2000;
    std::size_t cgal_queries = 500;
    std::size_t cgal_vertices = 5000;
    std::uint64_t seed = 1;
    bool counts = true;
    bool times = true;
    bool robustness = true;
};

std::string text(std::size_t n) { return fmt::format("{}", n); }
std::string text(double x) { return fmt::format("{:.3g}", x); }
std::string text(const std::optional<std::size_t>& n) { return n ? text(*n) : ""; }
std::string text(const std::optional<double>& x) { return x ? text(*x) : ""; }

// ---- counts ----------------------------------------------------------------------------------------

// Tangent edges between different polygons, the world's ring being one.
std::size_t between_polygons(const Scene2& scene, const VisibilityGraph& tangent) {
    PerVertex<std::uint32_t> ring(scene.vertex_count());
    std::uint32_t index = 0;
    for (const RingRange2& range : scene.rings()) {
        for (std::uint32_t i = 0; i < range.count; ++i) {
            ring[scene[EdgeId{range.first.value + i}].source] = index;
        }
        ++index;
    }
    const auto edges = tangent.edges();
    return static_cast<std::size_t>(std::ranges::count_if(
        edges, [&](const auto& e) { return ring[e.first] != ring[e.second]; }));
}

// Whether all counts are as expected.
bool count(const Map& map, const Scene2& scene, Table& table) {
    const auto every = Collinear::every_vertex;
    const std::size_t all = visibility_graph(scene, {.collinear = every}).edge_count();
    const std::size_t nearest = visibility_graph(scene).edge_count();
    const VisibilityGraph tangent =
        visibility_graph(scene, {.collinear = every, .tangent_only = true});
    const std::size_t bitangents = between_polygons(scene, tangent);
    const bool right = scene.vertex_count() == map.vertices && all == map.all &&
                       nearest == map.nearest.value_or(nearest) &&
                       bitangents == map.bitangents.value_or(bitangents);
    table.add({map.name, text(scene.vertex_count()), text(scene.body_count()), text(all),
               text(map.all), text(nearest), text(map.nearest), text(tangent.edge_count()),
               text(bitangents), text(map.bitangents), right ? "yes" : "NO"});
    return right;
}

// ---- times -----------------------------------------------------------------------------------------

struct GraphTimes {
    std::size_t edges = 0;
    double full = 0;
    double as_double = 0;
    double tangent = 0;
    std::size_t tangents = 0;
    double wall_one = 0;
    double wall_two = 0;
    std::size_t bytes = 0;
};

GraphTimes time_graph(const Scene2& scene) {
    VisibilityGraphOptions full{.collinear = Collinear::every_vertex};
    GraphTimes t;
    t.bytes = peak_growth_bytes([&] { (void)visibility_graph(scene, full).edge_count(); });
    t.edges = visibility_graph(scene, full).edge_count();
    const Timing one = measure([&] { return visibility_graph(scene, full); });
    t.full = one.thread;
    t.wall_one = one.wall;
    VisibilityGraphOptions two = full;
    two.threads = 2;
    t.wall_two = measure([&] { return visibility_graph(scene, two); }).wall;
    VisibilityGraphOptions rounded = full;
    rounded.arithmetic = Arithmetic::double_;
    t.as_double = measure([&] { return visibility_graph(scene, rounded); }).thread;
    VisibilityGraphOptions tangent = full;
    tangent.tangent_only = true;
    t.tangents = visibility_graph(scene, tangent).edge_count();
    t.tangent = measure([&] { return visibility_graph(scene, tangent); }).thread;
    return t;
}

struct ViewTimes {
    double polygon = 0;         ///< seconds a query
    double exact = 0;           ///< with exact coordinates
    double canonical = 0;       ///< with the canonical ring of reduced fractions
    double corners = 0;         ///< a polygon
    double with_fractions = 0;  ///< part of the polygons whose coordinates fit in 128 bits
};

ViewTimes time_views(const Scene2& scene, const std::vector<Point2>& points) {
    const PointVisibility2 visibility(scene);
    const double n = static_cast<double>(points.size());
    ViewTimes t;
    VisibilityPolygon polygon;
    t.polygon = measure([&] {
                    for (const Point2& q : points) (void)visibility.from(q, {}, polygon);
                }).thread /
                n;
    t.exact = measure([&] {
                  std::size_t total = 0;
                  for (const Point2& q : points) {
                      (void)visibility.from(q, {}, polygon);
                      total += visibility.exact_points(polygon).size();
                  }
                  return total;
              }).thread /
              n;
    const std::size_t few = std::min<std::size_t>(points.size(), 100);
    t.canonical = measure(
                      [&] {
                          std::size_t total = 0;
                          for (std::size_t i = 0; i < few; ++i) {
                              (void)visibility.from(points[i], {}, polygon);
                              total += exact_ring(scene, polygon).size();
                          }
                          return total;
                      },
                      {.least_runs = 1})
                      .thread /
                  static_cast<double>(few);
    for (const Point2& q : points) {
        (void)visibility.from(q, {}, polygon);
        t.corners += static_cast<double>(polygon.ring.size()) / n;
        t.with_fractions += visibility.exact_points(polygon).is_fractions() ? 1 / n : 0;
    }
    return t;
}

struct CgalTimes {
    std::optional<double> every_vertex;
    double query = 0;
};

CgalTimes time_cgal(const Scene2& scene, std::vector<Point2> points, const Options& options) {
    points.resize(std::min(points.size(), options.cgal_queries));
    CgalExpansion expansion(scene);
    expansion.locate(points);
    CgalTimes t;
    expansion.attach();
    t.query = measure(
                  [&] {
                      std::size_t total = 0;
                      for (std::size_t i = 0; i < points.size(); ++i)
                          total += expansion.from_point(i);
                      return total;
                  },
                  {.least_runs = 3, .least_seconds = 0})
                  .thread /
              static_cast<double>(points.size());
    if (scene.vertex_count() <= options.cgal_vertices) {
        t.every_vertex = measure(
                             [&] {
                                 expansion.attach();
                                 return expansion.from_every_vertex();
                             },
                             {.least_runs = 3, .least_seconds = 0})
                             .thread;
    }
    return t;
}

void time(const Map& map, const Scene2& scene, const Options& options, Table& table) {
    const GraphTimes graph = time_graph(scene);
    const std::vector<Point2> points = free_points(scene, options.queries, options.seed);
    const ViewTimes view = time_views(scene, points);
    const CgalTimes cgal = time_cgal(scene, points, options);
    std::optional<double> graph_ratio;
    std::optional<double> cgal_ms;
    if (cgal.every_vertex) {
        cgal_ms = 1e3 * *cgal.every_vertex;
        graph_ratio = *cgal.every_vertex / graph.full;
    }
    const auto edges = static_cast<double>(graph.edges);
    table.add({map.name, text(graph.edges), text(1e3 * graph.full), text(1e3 * graph.as_double),
               text(cgal_ms), text(graph_ratio), text(static_cast<double>(graph.bytes) / edges),
               text(1e3 * graph.tangent),
               text(1e6 * graph.tangent / static_cast<double>(graph.tangents)),
               text(1e6 * view.polygon), text(1e6 * view.exact), text(1e6 * view.canonical),
               text(1e6 * cgal.query), text(cgal.query / view.polygon), text(view.corners),
               text(view.with_fractions), text(1e3 * graph.wall_one), text(1e3 * graph.wall_two),
               text(graph.wall_one / graph.wall_two)});
}

// ---- robustness ------------------------------------------------------------------------------------

std::vector<VertexId> sample(std::size_t n, std::size_t count, std::uint64_t seed) {
    std::vector<VertexId> all;
    for (std::uint32_t v = 0; v < n; ++v) all.push_back(VertexId{v});
    std::mt19937_64 random(seed);
    std::vector<VertexId> chosen;
    std::ranges::sample(all, std::back_inserter(chosen), static_cast<std::ptrdiff_t>(count),
                        random);
    return chosen;
}

// Whether all sampled rows equal the reference's.
bool check(const Map& map, const Moved& moved, const Options& options, Table& table) {
    const Scene2& scene = moved.scene;
    bool right = true;
    for (const Collinear rule : {Collinear::every_vertex, Collinear::nearest_only}) {
        const VisibilityGraph graph = visibility_graph(scene, {.collinear = rule});
        EdgeDifference wrong;
        std::size_t edges = 0;
        const auto rows = sample(scene.vertex_count(), options.rows, options.seed);
        for (const VertexId v : rows) {
            const auto expected = reference::visible_from(scene, v, {.collinear = rule});
            wrong += compare(graph.neighbours(v), expected);
            edges += expected.size();
        }
        const VisibilityGraph rounded =
            visibility_graph(scene, {.collinear = rule, .arithmetic = Arithmetic::double_});
        const EdgeDifference rounded_wrong = compare(rounded, graph);
        right = right && wrong.false_edges == 0 && wrong.missed_edges == 0;
        table.add({map.name, moved.transform, moved.handling,
                   rule == Collinear::every_vertex ? "all" : "nearest", text(graph.edge_count()),
                   text(rows.size()), text(edges), text(wrong.false_edges),
                   text(wrong.missed_edges), text(rounded_wrong.false_edges),
                   text(rounded_wrong.missed_edges)});
    }
    return right;
}

// ---- the whole -------------------------------------------------------------------------------------

struct Report {
    Table counts{{"map", "vertices", "holes", "all", "expected_all", "nearest", "expected_nearest",
                  "tangent", "bitangents", "expected_bitangents", "right"}};
    Table times{{"map", "edges", "full_ms", "double_ms", "cgal_vertices_ms", "cgal/full",
                 "bytes_per_edge", "tangent_ms", "us_per_bitangent", "view_us", "view_exact_us",
                 "view_canonical_us", "cgal_view_us", "cgal/view", "corners", "in_128_bits",
                 "wall_1_ms", "wall_2_ms", "speedup"}};
    Table robustness{{"map", "transform", "handling", "collinear", "edges", "rows", "edges_in_rows",
                      "false", "missed", "double_false", "double_missed"}};

    void write(const std::string& stem, const std::string& head) const {
        if (counts.row_count() != 0) counts.write_csv(stem + "counts.csv", head);
        if (times.row_count() != 0) times.write_csv(stem + "times.csv", head);
        if (robustness.row_count() != 0) robustness.write_csv(stem + "robustness.csv", head);
    }
};

int main_of(const Options& options) {
    const std::string head = provenance() + fmt::format("# seed: {}\n", options.seed);
    std::cout << head << std::flush;
    const std::vector<Map> maps = read_maps(options.data, options.maps);
    Report report;
    bool right = !maps.empty();
    for (const Map& map : options.counts ? maps : std::vector<Map>{}) {
        right = count(map, Scene2::make(map.input).value(), report.counts) && right;
    }
    for (const Map& map : options.times ? maps : std::vector<Map>{}) {
        time(map, Scene2::make(map.input).value(), options, report.times);
    }
    for (const Map& map : options.robustness ? maps : std::vector<Map>{}) {
        for (const Moved& m : moved(map, options.seed)) {
            right = check(map, m, options, report.robustness) && right;
        }
    }
    if (!options.out.empty()) report.write(options.out + "/", head);
    std::cout << (right ? "all as expected\n" : "WRONG: see above\n");
    return right ? 0 : 1;
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    CLI::App app("Exactness, speed and robustness on maps");
    sightline::experiments::Options options;
    app.add_option("--data", options.data, "folder of the maps, <name>.wkt")->required();
    app.add_option("--out", options.out, "folder for counts.csv, times.csv, robustness.csv");
    app.add_option("--maps", options.maps, "names of maps; all by default");
    app.add_option("--rows", options.rows, "compared with the reference")->capture_default_str();
    app.add_option("--queries", options.queries, "random viewpoints")->capture_default_str();
    app.add_option("--cgal-queries", options.cgal_queries, "of these, for CGAL")
        ->capture_default_str();
    app.add_option("--cgal-vertices", options.cgal_vertices,
                   "largest map on which CGAL expands from every vertex")
        ->capture_default_str();
    app.add_option("--seed", options.seed)->capture_default_str();
    app.add_flag("!--no-counts", options.counts);
    app.add_flag("!--no-times", options.times);
    app.add_flag("!--no-robustness", options.robustness);
    CLI11_PARSE(app, argc, argv);
    return sightline::experiments::main_of(options);
}
