// SPDX-License-Identifier: GPL-3.0-or-later
// Run time against error of the visibility graph, by arithmetic, from generic to fully degenerate scenes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <variant>
#include <vector>

#include "common/edge_difference.hpp"
#include "common/measure.hpp"
#include "common/scenes.hpp"
#include "common/table.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/repair2.hpp"
#include "sightline/scene/transform2.hpp"

namespace sightline::experiments {
namespace {

namespace f = families;

struct Options {
    std::size_t n = 1000;
    std::uint64_t seed = 1;
    std::string out;
    std::vector<std::string> only;
};

struct NamedScene {
    std::string name;
    SceneInput2 input;
};

struct Movement {
    const char* name;
    f::Transform transform;
};

const Movement movements[] = {
    {"rotated 30 deg", f::ApproxRotation{30}}, {"rotated 17.3 deg", f::ApproxRotation{17.3}},
    {"scaled 0.1", f::ApproxScaling{0.1}},     {"shifted 1e8/3", f::ApproxTranslation{1e8 / 3, 0}},
    {"one ulp off", f::Nudge{1, 500}},
};

// From generic to fully degenerate.
std::vector<NamedScene> scenes(const Options& options) {
    const std::size_t n = options.n;
    const std::uint64_t seed = options.seed;
    std::vector<NamedScene> list;
    for (const char* family :
         {"dense", "packed", "needles", "grid", "rotated_grid", "cave", "floor_plan"}) {
        list.push_back({family, family_scene(family, n, seed)});
    }
    for (const char* family : {"dense", "grid", "floor_plan"}) {
        const SceneInput2 input = family_scene(family, n, seed);
        for (const Movement& m : movements) {
            list.push_back(
                {std::string(family) + " " + m.name, transformed(input, m.transform).value()});
        }
    }
    list.push_back({"near_collinear", f::near_collinear({n / 4}, seed)});
    list.push_back({"slivers", f::slivers({n / 3}, seed)});
    list.push_back({"collinear_bodies", f::collinear_bodies({n / 3}, seed)});
    list.push_back({"collinear_points", f::collinear_points({n / 4}, seed)});
    list.push_back(
        {"collinear_points rotated 30 deg",
         transformed(f::collinear_points({n / 4}, seed), f::ApproxRotation{30}).value()});
    list.push_back({"dense near 1e150", f::scaled_convex({n, 478}, seed)});
    list.push_back({"dense near 1e-150", f::scaled_convex({n, -518}, seed)});
    list.push_back({"dense denormal", f::scaled_convex({n, -1074}, seed)});
    list.push_back({"magnitudes", f::magnitudes({n / 3}, seed)});
    return list;
}

struct Policy {
    const char* name;
    Arithmetic arithmetic;
};

const Policy policies[] = {{"double", Arithmetic::double_},
                           {"interval", Arithmetic::interval},
                           {"filtered", Arithmetic::filtered},
                           {"exact", Arithmetic::exact}};

TierCounts total(const Tally& tally) {
    TierCounts sum;
    for (std::size_t p = 0; p < static_cast<std::size_t>(Predicate::count_); ++p) {
        sum += tally[static_cast<Predicate>(p)];
    }
    return sum;
}

void run(const NamedScene& named, Table& table) {
    auto scene = Scene2::make(named.input);
    std::string name = named.name;
    if (!scene) {  // rounding made edges cross: the bodies that overlap are merged
        auto repaired = repair(named.input);
        if (!repaired) {
            std::cerr << name << ": left out, " << repaired.error().message << '\n';
            return;
        }
        name += fmt::format(" ({} repairs)", repaired->changes.size());
        scene = std::move(repaired->scene);
    }
    const VisibilityGraph right = visibility_graph(*scene, {.arithmetic = Arithmetic::exact});
    for (const Policy& policy : policies) {
        Tally tally;
        const VisibilityGraph graph =
            visibility_graph(*scene, {.arithmetic = policy.arithmetic, .tally = &tally});
        const Timing timing =
            measure([&] { return visibility_graph(*scene, {.arithmetic = policy.arithmetic}); },
                    {.least_runs = 3, .least_seconds = 0.1, .most_runs = 50});
        const EdgeDifference wrong = compare(graph, right);
        const TierCounts tiers = total(tally);
        table.add({name, fmt::format("{}", scene->vertex_count()), policy.name,
                   fmt::format("{}", graph.edge_count()), fmt::format("{}", wrong.false_edges),
                   fmt::format("{}", wrong.missed_edges),
                   fmt::format("{:.3f}", 1e3 * timing.thread), fmt::format("{}", tiers.calls),
                   fmt::format("{}", tiers.filter), fmt::format("{}", tiers.interval),
                   fmt::format("{}", tiers.exact), fmt::format("{}", tiers.undecided)});
    }
}

int main_of(const Options& options) {
    Table table({"scene", "vertices", "arithmetic", "edges", "false", "missed", "cpu_ms", "calls",
                 "filter", "interval", "exact", "undecided"});
    const std::string head = provenance() + fmt::format("# seed: {}\n", options.seed);
    std::cout << head << std::flush;
    for (const NamedScene& scene : scenes(options)) {
        if (!options.only.empty() &&
            std::find(options.only.begin(), options.only.end(), scene.name) == options.only.end()) {
            continue;
        }
        run(scene, table);
    }
    if (!options.out.empty()) table.write_csv(options.out, head);
    return 0;
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    CLI::App app("Run time against error of the visibility graph, by arithmetic");
    sightline::experiments::Options options;
    app.add_option("--vertices", options.n, "of each scene, about")->capture_default_str();
    app.add_option("--seed", options.seed)->capture_default_str();
    app.add_option("--out", options.out, "CSV file to write");
    app.add_option("--only", options.only, "names of scenes to run");
    CLI11_PARSE(app, argc, argv);
    return sightline::experiments::main_of(options);
}
