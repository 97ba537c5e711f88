// SPDX-License-Identifier: GPL-3.0-or-later
// How the time and memory of the visibility graph grow: with its edges, or with n²?

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "common/measure.hpp"
#include "common/scenes.hpp"
#include "common/table.hpp"
#include "planar/triangulation.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline::experiments {
namespace {

struct Options {
    std::string out;
    std::uint64_t seed = 1;
    std::size_t largest_dense = 100000;
    std::size_t largest_sparse = 20000;
};

struct Sample {
    double n = 0;
    double k = 0;
    double seconds = 0;
};

// Least squares in relative terms: a, b >= 0 that make a x + b y = 1 for x = k/t, y = n log n/t.
struct Fit {
    double per_edge = 0;
    double per_n_log_n = 0;
};

Fit fit_sum(const std::vector<Sample>& samples) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double x1 = 0;
    double y1 = 0;
    for (const Sample& s : samples) {
        const double x = s.k / s.seconds;
        const double y = s.n * std::log2(s.n) / s.seconds;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        x1 += x;
        y1 += y;
    }
    const double det = xx * yy - xy * xy;
    if (y1 * xx < x1 * xy) return {x1 / xx, 0};  // edges alone explain it better
    if (x1 * yy < y1 * xy) return {0, y1 / yy};
    return {(x1 * yy - y1 * xy) / det, (y1 * xx - x1 * xy) / det};
}

// The exponent e of t ~ x^e, by least squares of the logarithms.
template <typename Abscissa>
double exponent(const std::vector<Sample>& samples, Abscissa&& of) {
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (const Sample& s : samples) {
        const double x = std::log(of(s));
        const double y = std::log(s.seconds);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const auto m = static_cast<double>(samples.size());
    return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

Sample run(const std::string& family, std::size_t n, std::uint64_t seed, Table& table) {
    const Scene2 scene = Scene2::make(family_scene(family, n, seed)).value();
    const VisibilityGraphOptions one{.collinear = Collinear::every_vertex};
    VisibilityGraphOptions two = one;
    two.threads = 2;
    const std::size_t bytes =
        peak_growth_bytes([&] { (void)visibility_graph(scene, one).edge_count(); });
    const auto edges = static_cast<double>(visibility_graph(scene, one).edge_count());
    const Effort effort{.least_runs = 3, .least_seconds = 0.2, .most_runs = 100};
    const Timing triangulation =
        measure([&] { return detail::Triangulation(scene).triangle_count(); }, effort);
    const Timing t1 = measure([&] { return visibility_graph(scene, one); }, effort);
    const Timing t2 = measure([&] { return visibility_graph(scene, two); }, effort);
    const Sample sample{static_cast<double>(scene.vertex_count()), edges, t1.thread};
    table.add({family, fmt::format("{}", scene.vertex_count()), fmt::format("{:.0f}", edges),
               fmt::format("{:.3f}", 1e3 * t1.thread),
               fmt::format("{:.3f}", 1e3 * triangulation.thread),
               fmt::format("{:.1f}", 1e9 * t1.thread / edges),
               fmt::format("{:.1f}", static_cast<double>(bytes) / edges),
               fmt::format("{:.1f}", static_cast<double>(bytes) / 0x1p20),
               fmt::format("{:.3f}", 1e3 * t1.wall), fmt::format("{:.3f}", 1e3 * t2.wall),
               fmt::format("{:.3f}", 1e3 * t2.process), fmt::format("{:.2f}", t1.wall / t2.wall)});
    return sample;
}

void print_fit(const std::string& name, const std::vector<Sample>& samples) {
    const Fit fit = fit_sum(samples);
    double worst = 0;
    for (const Sample& s : samples) {
        const double model = fit.per_edge * s.k + fit.per_n_log_n * s.n * std::log2(s.n);
        worst = std::max(worst, std::abs(std::log(model / s.seconds)));
    }
    fmt::print(
        "{}: time = {:.1f} ns k + {:.1f} ns n log2 n, within a factor of {:.2f}; time ~ n^{:.2f}, "
        "edges ~ n^{:.2f}, time ~ edges^{:.2f}\n",
        name, 1e9 * fit.per_edge, 1e9 * fit.per_n_log_n, std::exp(worst),
        exponent(samples, [](const Sample& s) { return s.n; }),
        exponent(samples, [](const Sample& s) { return s.n; }) /
            exponent(samples, [](const Sample& s) { return s.k; }),
        exponent(samples, [](const Sample& s) { return s.k; }));
}

int main_of(const Options& options) {
    const std::string head = provenance() + fmt::format("# seed: {}\n", options.seed);
    std::cout << head << std::flush;
    Table table({"family", "vertices", "edges", "cpu_ms", "triangulation_ms", "ns_per_edge",
                 "peak_bytes_per_edge", "peak_MiB", "wall_1_ms", "wall_2_ms", "cpu_2_ms",
                 "speedup"});
    std::vector<Sample> together;
    for (const auto& [family, largest] :
         {std::pair{"dense", options.largest_dense}, {"sparse", options.largest_sparse}}) {
        std::vector<Sample> samples;
        for (double n = 100; n <= static_cast<double>(largest) * 1.001; n *= std::sqrt(10)) {
            samples.push_back(run(family, static_cast<std::size_t>(n), options.seed, table));
        }
        print_fit(family, samples);
        together.insert(together.end(), samples.begin(), samples.end());
    }
    print_fit("together", together);
    if (!options.out.empty()) table.write_csv(options.out, head);
    return 0;
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    CLI::App app("Time and memory of the visibility graph against its size");
    sightline::experiments::Options options;
    app.add_option("--out", options.out, "CSV file to write");
    app.add_option("--seed", options.seed)->capture_default_str();
    app.add_option("--dense", options.largest_dense, "largest n")->capture_default_str();
    app.add_option("--sparse", options.largest_sparse, "largest n")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return sightline::experiments::main_of(options);
}
