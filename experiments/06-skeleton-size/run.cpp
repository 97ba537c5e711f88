// SPDX-License-Identifier: GPL-3.0-or-later
// How large is the visibility skeleton, what does it cost, and what do doubles get wrong?

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/measure.hpp"
#include "common/table.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/skeleton/build.hpp"

namespace sightline::experiments {
namespace {

struct Options {
    std::string out;
    std::uint64_t seed = 1;
    std::size_t largest = 60;
    std::size_t room = 300;
};

Scene3 family(const std::string& name, const std::vector<std::string>& parameters,
              std::uint64_t seed) {
    return *Scene3::make(*families::generate3(name, parameters, seed));
}

struct Sample {
    double k, n, size, seconds, bytes;
};

/// The exponent e of y ~ x^e, by least squares of the logarithms.
template <typename X, typename Y>
double exponent(const std::vector<Sample>& samples, const X& x_of, const Y& y_of) {
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (const Sample& s : samples) {
        const double x = std::log(x_of(s));
        const double y = std::log(y_of(s));
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const auto m = static_cast<double>(samples.size());
    return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

struct Run {
    VisibilitySkeleton skeleton;
    double cpu = 0, wall = 0;
    Tally tally;
};

Run build(const Scene3& scene, SkeletonOptions options) {
    Run run;
    options.tally = &run.tally;
    const Effort once{.least_runs = 1, .least_seconds = 0, .most_runs = 1};
    const Timing timing =
        measure([&] { return run.skeleton = visibility_skeleton(scene, options); }, once);
    run.cpu = timing.process;
    run.wall = timing.wall;
    return run;
}

/// Elements of a that are not in b; both are sorted.
template <typename T>
std::size_t missing(std::span<const T> a, std::span<const T> b) {
    std::vector<T> only;
    std::ranges::set_difference(a, b, std::back_inserter(only));
    return only.size();
}

Sample size_of(const std::string& name, const Scene3& scene, double bodies, Table& table) {
    const std::size_t before = memory_bytes();
    const Run one = build(scene, {});
    const std::size_t bytes = memory_bytes() - std::min(before, memory_bytes());
    const Run two = build(scene, {.threads = 2});
    const auto nodes = static_cast<double>(one.skeleton.nodes().size());
    const auto arcs = static_cast<double>(one.skeleton.arcs().size());
    table.add({name, fmt::format("{:.0f}", bodies), fmt::format("{}", scene.edges().size()),
               fmt::format("{:.0f}", nodes), fmt::format("{:.0f}", arcs),
               fmt::format("{:.3f}", one.cpu), fmt::format("{:.1f}", 1e6 * one.cpu / arcs),
               fmt::format("{:.1f}", static_cast<double>(bytes) / 0x1p20),
               fmt::format("{:.3f}", one.wall), fmt::format("{:.3f}", two.wall),
               fmt::format("{:.2f}", one.wall / two.wall)});
    return {bodies, static_cast<double>(scene.edges().size()), nodes + arcs, one.cpu,
            static_cast<double>(bytes)};
}

void print_fits(const std::vector<Sample>& samples) {
    const auto k = [](const Sample& s) { return s.k; };
    const auto law = [](const Sample& s) { return s.k * std::sqrt(s.n * s.k); };
    const auto size = [](const Sample& s) { return s.size; };
    const auto time = [](const Sample& s) { return s.seconds; };
    const auto bytes = [](const Sample& s) { return s.bytes; };
    fmt::print(
        "polytopes: size ~ k^{:.2f}, time ~ k^{:.2f}, memory ~ k^{:.2f}; size ~ (k√(nk))^{:.2f}, "
        "time ~ size^{:.2f}\n",
        exponent(samples, k, size), exponent(samples, k, time), exponent(samples, k, bytes),
        exponent(samples, law, size), exponent(samples, size, time));
}

void arithmetic_of(const std::string& name, const Scene3& scene, Table& table) {
    const Run filtered = build(scene, {});
    const Run doubles = build(scene, {.arithmetic = Arithmetic::double_});
    const TierCounts forms = filtered.tally[Predicate::line_form3];
    const TierCounts parameters = filtered.tally[Predicate::curve_parameter3];
    const double calls = static_cast<double>(forms.calls + parameters.calls);
    table.add(
        {name, fmt::format("{}", filtered.skeleton.nodes().size()),
         fmt::format("{:.3f}", filtered.cpu), fmt::format("{:.3f}", doubles.cpu),
         fmt::format("{:.2f}", filtered.cpu / doubles.cpu), fmt::format("{:.0f}", calls),
         fmt::format("{:.2f}", 100 * static_cast<double>(forms.exact + parameters.exact) / calls),
         fmt::format("{}", missing(filtered.skeleton.nodes(), doubles.skeleton.nodes())),
         fmt::format("{}", missing(doubles.skeleton.nodes(), filtered.skeleton.nodes()))});
}

/// The arcs between the two faces that share most of them.
void pair_of(const Scene3& scene, double whole_cpu, const VisibilitySkeleton& whole) {
    std::map<std::array<FaceId, 2>, std::size_t> counts;
    for (const SkeletonArc& arc : whole.arcs()) {
        const auto& [a, b] = arc.label.ends;
        if (a.size() == 1 && b.size() == 1) ++counts[{a.front().face, b.front().face}];
    }
    if (counts.empty()) return;
    std::vector<std::pair<std::size_t, std::array<FaceId, 2>>> sorted;
    for (const auto& [pair, count] : counts) sorted.emplace_back(count, pair);
    std::ranges::sort(sorted);
    for (const double share : {0.5, 0.9, 1.0}) {
        const auto at = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
        SkeletonOptions options;
        options.part.between = sorted[at].second;
        const Run part = build(scene, options);
        fmt::print(
            "pair of faces, {:.0f} % of the pairs have fewer arcs: {} arcs, {:.3f} s, {:.2f} % of "
            "the whole\n",
            100 * share, part.skeleton.arcs().size(), part.cpu, 100 * part.cpu / whole_cpu);
    }
}

int main_of(const Options& options) {
    const std::string head = provenance() + fmt::format("# seed: {}\n", options.seed);
    std::cout << head << std::flush;
    Table sizes({"scene", "bodies", "edges", "nodes", "arcs", "cpu_s", "us_per_arc", "held_MiB",
                 "wall_1_s", "wall_2_s", "speedup"});
    std::vector<Sample> samples;
    for (const std::size_t k : {6U, 12U, 24U, 42U, 60U}) {
        if (k > options.largest) break;
        const Scene3 scene = family("polytopes", {std::to_string(k), "20"}, options.seed);
        samples.push_back(size_of("polytopes", scene, static_cast<double>(k), sizes));
        std::cout << std::flush;
    }
    print_fits(samples);
    for (std::size_t polygons = 75; polygons <= options.room; polygons *= 2) {
        const Scene3 scene = family("room", {std::to_string(polygons)}, options.seed);
        size_of("room", scene, static_cast<double>(scene.bodies().size()), sizes);
    }
    if (!options.out.empty()) sizes.write_csv(options.out + "/sizes.csv", head);

    Table tiers({"scene", "nodes", "filtered_s", "double_s", "ratio", "calls", "exact_percent",
                 "double_misses", "double_invents"});
    arithmetic_of("polytopes 15", family("polytopes", {"15", "20"}, options.seed), tiers);
    arithmetic_of("tetrahedra 30", family("tetrahedra", {"30"}, options.seed), tiers);
    arithmetic_of("grid3-perturbed 2", family("grid3-perturbed", {"2", "2", "2"}, options.seed),
                  tiers);
    arithmetic_of("grid3 2", family("grid3", {"2", "2", "2"}, options.seed), tiers);
    arithmetic_of("grid3-rotated 2", family("grid3-rotated", {"2", "2", "2"}, options.seed), tiers);
    arithmetic_of("stack 6", family("stack", {"6"}, options.seed), tiers);
    if (!options.out.empty()) tiers.write_csv(options.out + "/tiers.csv", head);

    const Scene3 scene = family("polytopes", {"24", "20"}, options.seed);
    const Run whole = build(scene, {});
    pair_of(scene, whole.cpu, whole.skeleton);
    return 0;
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    CLI::App app("Size and cost of the visibility skeleton");
    sightline::experiments::Options options;
    app.add_option("--out", options.out, "folder for the CSV files");
    app.add_option("--seed", options.seed)->capture_default_str();
    app.add_option("--largest", options.largest, "most polytopes")->capture_default_str();
    app.add_option("--room", options.room, "most polygons of a room")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return sightline::experiments::main_of(options);
}
