// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/torture_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "cli/document.hpp"
#include "cli/forked.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/skeleton/build.hpp"

namespace sightline::detail {
namespace {

/// Small, as the exact arithmetic has to do them too.
constexpr const char* battery[] = {"cube",
                                   "dodecahedron",
                                   "notched-cube",
                                   "ring",
                                   "tetrahedra 6",
                                   "polytopes 4 12",
                                   "needles3 6",
                                   "triangles 8",
                                   "boxes 5",
                                   "boxes-turned 5",
                                   "l-shapes 2",
                                   "grid3 2 2 2",
                                   "grid3-near 2 2 1",
                                   "grid3-rotated 2 2 2",
                                   "grid3-perturbed 2 2 1",
                                   "grid3-turned 2 2 1",
                                   "checkerboard3 2 2 2",
                                   "grid3-packed 2 2 1",
                                   "stack 4",
                                   "chain3 4",
                                   "coplanar 4",
                                   "near-coplanar 4",
                                   "collinear3 4",
                                   "near-collinear3 4",
                                   "concurrent 4",
                                   "near-concurrent 4",
                                   "regulus 5",
                                   "near-regulus 5",
                                   "vertices-in-plane 4",
                                   "near-vertices-in-plane 4",
                                   "double-root",
                                   "double-root-missed",
                                   "double-root-split",
                                   "touching-box-on-table",
                                   "touching-edge-crossing",
                                   "touching-vertex-on-face",
                                   "two-boxes-triangle",
                                   "tiny3 3",
                                   "huge3 3",
                                   "far3 3"};

/// What a skeleton has too much or too little. Plain data: it crosses from one process to another.
struct Difference {
    bool is_done = false;
    std::size_t false_nodes = 0;
    std::size_t missed_nodes = 0;
    std::size_t false_arcs = 0;
    std::size_t missed_arcs = 0;
    TierCounts tiers;

    [[nodiscard]] bool is_none() const {
        return is_done && false_nodes + missed_nodes + false_arcs + missed_arcs == 0;
    }
};

struct Case {
    bool is_compared = false;
    std::size_t edges = 0;
    std::size_t nodes = 0;
    std::size_t arcs = 0;
    Difference filtered;
    Difference in_doubles;
};

Result<SceneInput3> input_of(const std::string& source, std::uint64_t seed) {
    std::istringstream words(source);
    std::string name;
    words >> name;
    std::vector<std::string> parameters;
    for (std::string word; words >> word;) parameters.push_back(word);
    return families::generate3(name, parameters, seed);
}

/// An arc by what it says, with its nodes' labels in place of their numbers.
using NamedArc = std::pair<SkeletonArc, std::array<SkeletonNode, 2>>;

std::vector<NamedArc> named_arcs(const VisibilitySkeleton& skeleton) {
    std::vector<NamedArc> arcs;
    for (SkeletonArc arc : skeleton.arcs()) {
        std::array nodes{skeleton[arc.nodes[0]], skeleton[arc.nodes[1]]};
        std::ranges::sort(nodes);
        arc.nodes = {};
        arcs.emplace_back(std::move(arc), std::move(nodes));
    }
    std::ranges::sort(arcs);
    return arcs;
}

template <typename Sorted>
std::size_t extra(const Sorted& some, const Sorted& others) {
    return static_cast<std::size_t>(std::ranges::count_if(
        some, [&](const auto& x) { return !std::ranges::binary_search(others, x); }));
}

void compare(const Scene3& scene, const VisibilitySkeleton& right, Arithmetic arithmetic,
             Difference& difference) {
    Tally tally;
    SkeletonOptions options;
    options.arithmetic = arithmetic;
    options.tally = &tally;
    const VisibilitySkeleton skeleton = visibility_skeleton(scene, options);
    difference.false_nodes = extra(skeleton.nodes(), right.nodes());
    difference.missed_nodes = extra(right.nodes(), skeleton.nodes());
    const auto arcs = named_arcs(skeleton);
    const auto right_arcs = named_arcs(right);
    difference.false_arcs = extra(arcs, right_arcs);
    difference.missed_arcs = extra(right_arcs, arcs);
    for (int i = 0; i < static_cast<int>(Predicate::count_); ++i) {
        difference.tiers += tally[static_cast<Predicate>(i)];
    }
    difference.is_done = true;
}

void work(Case& one, const std::string& source, std::uint64_t seed) {
    const auto input = input_of(source, seed);
    const auto scene = input ? Scene3::make(*input) : tl::unexpected(input.error());
    if (!scene) return;
    SkeletonOptions exact;
    exact.arithmetic = Arithmetic::exact;
    const VisibilitySkeleton right = visibility_skeleton(*scene, exact);
    one.edges = scene->edges().size();
    one.nodes = right.nodes().size();
    one.arcs = right.arcs().size();
    one.is_compared = true;
    compare(*scene, right, Arithmetic::filtered, one.filtered);
    compare(*scene, right, Arithmetic::double_, one.in_doubles);
}

std::string cell(const Difference& d) {
    if (!d.is_done) return fmt::format("{:>27}", "crashed");
    return fmt::format("{:>6} {:>6} {:>6} {:>6}", d.false_nodes, d.missed_nodes, d.false_arcs,
                       d.missed_arcs);
}

std::string row_of(const Case& one, const std::string& source) {
    const std::string head = fmt::format("{:<26}", source);
    if (!one.is_compared) return head + "  exact arithmetic did not finish\n";
    const TierCounts& tiers = one.filtered.tiers;
    return head + fmt::format(" {:>5} {:>6} {:>6} |{} |{} | {:>9} {:>8}\n", one.edges, one.nodes,
                              one.arcs, cell(one.filtered), cell(one.in_doubles), tiers.filter,
                              tiers.exact);
}

std::string table_of(std::span<const Case> cases, std::span<const std::string> sources,
                     std::uint64_t seed) {
    std::string text =
        fmt::format("{:<26} {:>5} {:>6} {:>6} |{:^27} |{:^27} | {}\n", "", "", "", "",
                    "filtered: nodes, arcs", "double: nodes, arcs", "filtered decided by");
    text += fmt::format(
        "{:<26} {:>5} {:>6} {:>6} |{:>6} {:>6} {:>6} {:>6} |{:>6} {:>6} {:>6} {:>6} | {:>9} "
        "{:>8}\n",
        "scene", "edges", "nodes", "arcs", "false", "missed", "false", "missed", "false", "missed",
        "false", "missed", "filter", "exact");
    std::size_t compared = 0;
    std::size_t filtered_wrong = 0;
    std::size_t doubles_wrong = 0;
    std::size_t doubles_crashed = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& one = cases[i];
        text += row_of(one, sources[i]);
        if (!one.is_compared) continue;
        ++compared;
        if (!one.filtered.is_none()) ++filtered_wrong;
        if (one.filtered.is_done && !one.in_doubles.is_done) ++doubles_crashed;
        if (one.in_doubles.is_done && !one.in_doubles.is_none()) ++doubles_wrong;
    }
    return text +
           fmt::format(
               "{} skeletons compared with exact arithmetic (seed {}): filtered wrong on {}; "
               "double wrong on {}, crashed on {}\n",
               compared, seed, filtered_wrong, doubles_wrong, doubles_crashed);
}

void write_difference(JsonWriter& json, const char* name, const Difference& d) {
    json.key(name);
    json.begin_object(JsonWriter::Layout::inline_);
    json.member("crashed", !d.is_done);
    json.member("false_nodes", d.false_nodes);
    json.member("missed_nodes", d.missed_nodes);
    json.member("false_arcs", d.false_arcs);
    json.member("missed_arcs", d.missed_arcs);
    json.member("filter", d.tiers.filter);
    json.member("exact", d.tiers.exact);
    json.end();
}

Result<void> write_document(const SpaceTorture& torture, std::span<const Case> cases,
                            std::span<const std::string> sources, bool is_complete,
                            Session& session) {
    Document document;
    document.kind = "torture";
    document.options["space"] = true;
    document.options["seed"] = torture.seed;
    document.complete = is_complete;
    document.result = [&](JsonWriter& json) {
        json.begin_object();
        json.key("rows");
        json.begin_array();
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Case& one = cases[i];
            json.begin_object(JsonWriter::Layout::inline_);
            json.member("family", sources[i]);
            json.member("edges", one.edges);
            json.member("nodes", one.nodes);
            json.member("arcs", one.arcs);
            if (one.is_compared) {
                write_difference(json, "filtered", one.filtered);
                write_difference(json, "double", one.in_doubles);
            }
            json.end();
        }
        json.end();
        json.end();
    };
    OutputArguments outputs;
    outputs.json = torture.output;
    return write_outputs(outputs, document, session);
}

}  // namespace

Result<ExitStatus> torture_space(const SpaceTorture& torture, Session& session) {
    std::vector<std::string> sources = torture.families;
    if (sources.empty()) sources.assign(std::begin(battery), std::end(battery));
    for (const std::string& source : sources) {
        const auto input = input_of(source, torture.seed);
        if (!input) return tl::unexpected(input.error());
    }
    const SharedMemory<Case> shared(sources.size());
    const std::span<Case> cases = shared.all();
    session.keep_from_now_on();
    const std::size_t finished = session.timed("build", "torturing", [&] {
        return run_forked(cases.size(), session,
                          [&](std::size_t i) { work(cases[i], sources[i], torture.seed); });
    });
    const bool is_complete = finished == cases.size();
    std::cout << table_of(cases, sources, torture.seed) << std::flush;
    if (!torture.output.empty()) {
        const auto written = write_document(torture, cases, sources, is_complete, session);
        if (!written) return tl::unexpected(written.error());
    }
    if (!is_complete) return fail(Errc::limit_reached, session.limit_message());
    const bool is_fine = std::ranges::all_of(
        cases, [](const Case& one) { return one.is_compared && one.filtered.is_none(); });
    return is_fine ? ExitStatus::done : ExitStatus::no_answer;
}

}  // namespace sightline::detail
