// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "cli/comparison.hpp"
#include "cli/document.hpp"
#include "cli/forked.hpp"
#include "cli/output_set.hpp"
#include "cli/program.hpp"
#include "cli/torture_space.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/repair2.hpp"
#include "sightline/scene/scene_io.hpp"
#include "sightline/scene/transform2.hpp"

namespace sightline::detail {
namespace {

struct TortureArguments {
    std::vector<std::string> files;
    bool world = false;
    std::vector<std::string> families;
    std::uint64_t seed = 1;
    std::size_t sample = 12;
    std::string output;
    bool space = false;
};

/// What is tortured: a family or a file.
struct Source {
    std::string name;
    bool is_file = false;
};

struct NamedTransform {
    const char* name;
    std::optional<families::Transform> transform;
};

std::vector<NamedTransform> transforms(std::uint64_t seed) {
    return {{"as it is", std::nullopt},
            {"rotated 30°", families::ApproxRotation{30}},
            {"rotated 17.3°", families::ApproxRotation{17.3}},
            {"times 0.1", families::ApproxScaling{0.1}},
            {"times 1e-8", families::ApproxScaling{1e-8}},
            {"times 1e8", families::ApproxScaling{1e8}},
            {"shifted 1e8", families::ApproxTranslation{1e8, 1e8}},
            {"nudged", families::Nudge{seed}},
            {"mirrored", families::Mirror{}},
            {"permuted", families::Permutation{seed}}};
}

/// How one arithmetic did on one scene. Plain data: it crosses from one process to another.
struct Outcome {
    bool is_done = false;
    std::size_t false_edges = 0;
    std::size_t missed_edges = 0;
    Tally tally;
};

/// One scene of the battery. It is worked on in a process of its own, which may crash, as doubles
/// may lead anything astray.
struct Case {
    std::size_t source = 0;
    std::size_t transform = 0;
    bool is_invalid = false;  ///< rounding made bodies overlap or the like, beyond repair
    bool is_repaired = false;
    bool is_compared = false;
    std::size_t vertices = 0;
    std::size_t rows = 0;
    Outcome filtered;
    Outcome in_doubles;
};

Outcome outcome_of(const Scene2& scene, Arithmetic arithmetic, std::span<const VertexId> rows,
                   const std::vector<std::vector<VertexId>>& right) {
    Outcome outcome;
    VisibilityGraphOptions options;
    options.arithmetic = arithmetic;
    options.tally = &outcome.tally;
    const VisibilityGraph graph = visibility_graph(scene, options);
    GraphComparison found;
    for (std::size_t i = 0; i < rows.size(); ++i) compare_row(graph, rows[i], right[i], found);
    outcome.false_edges = found.false_count;
    outcome.missed_edges = found.missed_count;
    outcome.is_done = true;
    return outcome;
}

Result<SceneInput2> input_of(const Source& source, const TortureArguments& arguments) {
    if (!source.is_file) return families::generate2(source.name, {}, arguments.seed);
    ReadOptions options;
    options.world = arguments.world;
    return read_input(source.name, options);
}

/// The scene, repaired when rounding made bodies overlap.
Result<Scene2> scene_of(Case& one, const Source& source, const TortureArguments& arguments) {
    Result<SceneInput2> input = input_of(source, arguments);
    const auto transform = transforms(arguments.seed)[one.transform].transform;
    if (input && transform) input = families::transformed(*input, *transform);
    if (!input) return tl::unexpected(input.error());
    Result<Scene2> scene = Scene2::make(*input);
    if (scene) return scene;
    one.is_invalid = true;  // and stays so, should the repair end this process
    Result<RepairedScene2> repaired = repair(*input);
    if (!repaired) return scene;
    one.is_repaired = true;
    return std::move(repaired->scene);
}

void work(Case& one, const Source& source, const TortureArguments& arguments) {
    const Result<Scene2> scene = scene_of(one, source, arguments);
    one.is_invalid = !scene;
    if (!scene) return;
    one.vertices = scene->vertex_count();
    const auto rows = sampled_vertices(one.vertices, arguments.sample);
    std::vector<std::vector<VertexId>> right;
    for (const VertexId v : rows) right.push_back(reference::visible_from(*scene, v));
    one.rows = rows.size();
    one.is_compared = true;
    one.filtered = outcome_of(*scene, Arithmetic::filtered, rows, right);
    one.in_doubles = outcome_of(*scene, Arithmetic::double_, rows, right);
}

bool is_good(const Outcome& outcome) {
    return outcome.is_done && outcome.false_edges + outcome.missed_edges == 0;
}

std::string cell(const Outcome& outcome) {
    if (!outcome.is_done) return fmt::format("{:>7} {:>7} {:>7}", "-", "-", "crashed");
    return fmt::format("{:>7} {:>7} {:>7}", outcome.false_edges, outcome.missed_edges, "");
}

TierCounts total(const Tally& tally) {
    TierCounts sum;
    for (int i = 0; i < static_cast<int>(Predicate::count_); ++i) {
        sum += tally[static_cast<Predicate>(i)];
    }
    return sum;
}

std::string row_of(const Case& one, std::span<const Source> sources,
                   std::span<const NamedTransform> names) {
    const std::string& name = sources[one.source].name;
    const std::string family = name.substr(name.rfind('/') + 1);
    // A degree sign is one column and two bytes.
    const std::string transform = names[one.transform].name;
    const std::size_t width = transform.find("°") == std::string::npos ? 14 : 15;
    const std::string head = fmt::format("{:<18} {:<{}}", family, transform, width);
    if (one.is_invalid) return head + "  no valid scene after rounding\n";
    if (!one.is_compared) return head + "  the reference did not finish\n";
    const TierCounts tiers = total(one.filtered.tally);
    return head + fmt::format(" {:>8} {:>5} {} |{} | {:>9} {:>8} {:>7}{}\n", one.vertices, one.rows,
                              cell(one.filtered), cell(one.in_doubles), tiers.filter,
                              tiers.interval, tiers.exact, one.is_repaired ? "  repaired" : "");
}

struct Summary {
    std::size_t compared = 0;
    std::size_t invalid = 0;
    std::size_t unfinished = 0;
    std::size_t filtered_wrong = 0;
    std::size_t doubles_wrong = 0;
    std::size_t doubles_crashed = 0;
};

Summary summary_of(std::span<const Case> cases) {
    Summary sum;
    for (const Case& one : cases) {
        if (one.is_invalid) {
            ++sum.invalid;
        } else if (!one.is_compared) {
            ++sum.unfinished;
        } else {
            ++sum.compared;
            if (!is_good(one.filtered)) ++sum.filtered_wrong;
            if (one.filtered.is_done && !one.in_doubles.is_done) ++sum.doubles_crashed;
            if (one.in_doubles.is_done && !is_good(one.in_doubles)) ++sum.doubles_wrong;
        }
    }
    return sum;
}

std::string table_of(std::span<const Case> cases, std::span<const Source> sources,
                     std::uint64_t seed) {
    const auto names = transforms(seed);
    std::string text = fmt::format("{:<33} {:>8} {:>5} {:>23} |{:>23} | {}\n", "", "", "",
                                   "filtered       ", "double         ", "filtered decided by");
    text += fmt::format(
        "{:<18} {:<14} {:>8} {:>5} {:>7} {:>7} {:>7} |{:>7} {:>7} {:>7} | {:>9} "
        "{:>8} {:>7}\n",
        "scene", "transform", "vertices", "rows", "false", "missed", "", "false", "missed", "",
        "filter", "interval", "exact");
    for (const Case& one : cases) text += row_of(one, sources, names);
    const Summary sum = summary_of(cases);
    text += fmt::format(
        "{} scenes compared with the reference (seed {}): filtered wrong on {}; double wrong on "
        "{}, crashed on {}\n",
        sum.compared, seed, sum.filtered_wrong, sum.doubles_wrong, sum.doubles_crashed);
    if (sum.invalid > 0) text += fmt::format("{} not valid after rounding\n", sum.invalid);
    if (sum.unfinished > 0) text += fmt::format("{} not finished\n", sum.unfinished);
    return text;
}

void write_outcome(JsonWriter& json, const char* name, const Outcome& outcome) {
    json.key(name);
    json.begin_object(JsonWriter::Layout::inline_);
    json.member("crashed", !outcome.is_done);
    json.member("false", outcome.false_edges);
    json.member("missed", outcome.missed_edges);
    const TierCounts tiers = total(outcome.tally);
    json.member("filter", tiers.filter);
    json.member("interval", tiers.interval);
    json.member("exact", tiers.exact);
    json.member("undecided", tiers.undecided);
    json.end();
}

void write_cases(JsonWriter& json, std::span<const Case> cases, std::span<const Source> sources,
                 std::uint64_t seed) {
    const auto names = transforms(seed);
    json.begin_object();
    json.key("rows");
    json.begin_array();
    for (const Case& one : cases) {
        json.begin_object(JsonWriter::Layout::inline_);
        json.member(sources[one.source].is_file ? "file" : "family", sources[one.source].name);
        json.member("transform", names[one.transform].name);
        json.member("valid", !one.is_invalid);
        json.member("repaired", one.is_repaired);
        json.member("vertices", one.vertices);
        json.member("rows", one.rows);
        if (one.is_compared) {
            write_outcome(json, "filtered", one.filtered);
            write_outcome(json, "double", one.in_doubles);
        }
        json.end();
    }
    json.end();
    json.end();
}

/// The files and families that are asked for; all families when nothing is.
Result<std::vector<Source>> sources_of(const TortureArguments& arguments) {
    std::vector<Source> sources;
    for (const std::string& file : arguments.files) sources.push_back({file, true});
    for (const std::string& family : arguments.families) sources.push_back({family, false});
    for (const Source& source : sources) {
        const Result<SceneInput2> input = input_of(source, arguments);
        if (!input) return tl::unexpected(input.error());
    }
    if (!sources.empty()) return sources;
    for (const families::FamilyInfo& family : families::all2()) {
        sources.push_back({std::string(family.name), false});
    }
    return sources;
}

Result<void> write_document(const TortureArguments& arguments, std::span<const Case> cases,
                            std::span<const Source> sources, bool is_complete, Session& session) {
    Document document;
    document.kind = "torture";
    document.options["seed"] = arguments.seed;
    document.options["sample"] = arguments.sample;
    document.complete = is_complete;
    document.result = [&](JsonWriter& json) { write_cases(json, cases, sources, arguments.seed); };
    OutputArguments outputs;
    outputs.json = arguments.output;
    return write_outputs(outputs, document, session);
}

Result<ExitStatus> run_torture(const TortureArguments& arguments, Session& session) {
    if (arguments.space) {
        if (!arguments.files.empty()) {
            return fail(Errc::bad_parameter, "--space takes families only; leave out the files");
        }
        return torture_space({arguments.families, arguments.seed, arguments.output}, session);
    }
    if (!arguments.output.empty()) {
        const auto checked = OutputSet::check(std::span(&arguments.output, 1), arguments.files);
        if (!checked) return tl::unexpected(checked.error());
    }
    const auto sources = sources_of(arguments);
    if (!sources) return tl::unexpected(sources.error());
    const std::size_t kinds = transforms(arguments.seed).size();
    const SharedMemory<Case> shared(sources->size() * kinds);
    const std::span<Case> cases = shared.all();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        cases[i].source = i / kinds;
        cases[i].transform = i % kinds;
    }
    session.keep_from_now_on();
    const std::size_t finished = session.timed("build", "torturing", [&] {
        return run_forked(cases.size(), session, [&](std::size_t i) {
            work(cases[i], (*sources)[cases[i].source], arguments);
        });
    });
    const Summary sum = summary_of(cases);
    const bool is_complete = finished == cases.size();
    std::cout << table_of(cases, *sources, arguments.seed) << std::flush;
    if (!arguments.output.empty()) {
        const auto written = write_document(arguments, cases, *sources, is_complete, session);
        if (!written) return tl::unexpected(written.error());
    }
    if (!is_complete) return fail(Errc::limit_reached, session.limit_message());
    const bool is_fine = sum.filtered_wrong + sum.unfinished == 0;
    return is_fine ? ExitStatus::done : ExitStatus::no_answer;
}

}  // namespace

void add_torture(Program& program) {
    const auto arguments = std::make_shared<TortureArguments>();
    CLI::App& app = program.add(
        "torture", "the degeneracy battery: families, turned, scaled, shifted and nudged",
        "sightline torture --seed 7 -o torture.json",
        [arguments](Session& session) { return run_torture(*arguments, session); });
    app.add_option("SCENE", arguments->files, "files to torture instead of the families")
        ->type_name("");
    app.add_flag("--world", arguments->world,
                 "of the files: the first polygon is the free world, its holes are bodies");
    app.add_option("--family", arguments->families, "only this family; repeatable")
        ->type_name("NAME")
        ->take_all()
        ->allow_extra_args(false);
    app.add_flag("--space", arguments->space,
                 "skeletons of families of space, against exact arithmetic; --family then may have "
                 "parameters, as in \"grid3 2 2 1\"");
    app.add_option("--seed", arguments->seed, "of the scenes; 1 when not given")->type_name("S");
    app.add_option("--sample", arguments->sample,
                   "rows of each graph that are compared with the reference; 12 when not given")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    program.allow_partial(app);
    app.add_option("-o,--output", arguments->output, "the table as JSON as well")
        ->type_name("FILE")
        ->group("Output");
}

}  // namespace sightline::detail
