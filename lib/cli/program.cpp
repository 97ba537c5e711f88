// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <new>
#include <thread>

#include "cli/interruption.hpp"
#include "sightline/arith/rational.hpp"

namespace sightline::detail {
namespace {

constexpr const char* common_group = "Common options";

void complain(const std::string& line) { fmt::print(stderr, "sightline: {}\n", line); }

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// Rational::parse knows no words such as nan and does not ask the locale.
double parse_seconds(const std::string& text) {
    const auto seconds = Rational::parse(text);
    constexpr int most = 1'000'000'000;
    if (!seconds || seconds->sign() != Sign::positive || *seconds > Rational(most)) {
        throw CLI::ValidationError("--limit-seconds",
                                   "'" + text + "' is no time; write seconds, as in 30 or 0.5");
    }
    return seconds->approx_double();
}

/// "512M" as bytes.
std::uint64_t parse_memory(const std::string& text) {
    static const std::map<std::string, std::uint64_t> units = {
        {"", 1}, {"K", 1 << 10}, {"M", 1 << 20}, {"G", 1 << 30}, {"T", 1ULL << 40}};
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto unit = units.find(text.substr(digits));
    if (digits == 0 || digits > 12 || unit == units.end()) {
        throw CLI::ValidationError(
            "--limit-memory", "'" + text + "' is no amount of memory; write bytes, or 512M, or 2G");
    }
    return std::stoull(text.substr(0, digits)) * unit->second;
}

void add_common_options(CLI::App& app, CommonOptions& common) {
    static const std::map<std::string, Arithmetic> policies = {{"filtered", Arithmetic::filtered},
                                                               {"exact", Arithmetic::exact},
                                                               {"interval", Arithmetic::interval},
                                                               {"double", Arithmetic::double_}};
    app.add_option_function<std::string>(
           "--arithmetic",
           [&common](const std::string& name) { common.arithmetic = policies.at(name); },
           "filtered (default), exact; interval and double may be wrong and are there to be "
           "measured")
        ->check(CLI::IsMember({"filtered", "exact", "interval", "double"}))
        ->type_name("POLICY")
        ->group(common_group);
    app.add_option_function<unsigned>(
           "--threads",
           [&common](unsigned n) {
               common.threads = std::min(n, std::max(1U, std::thread::hardware_concurrency()));
           },
           "how many to use, at most one a core; 0 (default): one a core")
        ->check(CLI::Range(0, 1024))
        ->type_name("N")
        ->group(common_group);
    app.add_option_function<std::string>(
           "--limit-seconds",
           [&common](const std::string& text) { common.limit_seconds = parse_seconds(text); },
           "give up after so long, with exit status 1")
        ->type_name("S")
        ->group(common_group);
    app.add_option_function<std::string>(
           "--limit-memory",
           [&common](const std::string& text) { common.limit_memory = parse_memory(text); },
           "give up beyond so many bytes (suffix K, M, G), with exit status 1")
        ->type_name("SIZE")
        ->group(common_group);
    app.add_flag("--quiet", common.quiet, "say nothing but errors")->group(common_group);
    app.add_flag("--progress", common.progress,
                 "show a progress bar even when standard error is no terminal")
        ->group(common_group);
    app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "print the version")
        ->group(common_group);
    app.get_help_ptr()->group(common_group);
}

}  // namespace

std::vector<std::string> OutputArguments::given() const {
    std::vector<std::string> names;
    for (const std::string& name : {json, vtk, png, svg}) {
        if (!name.empty()) names.push_back(name);
    }
    return names;
}

Program::Program() : app_("Exact visibility: what sees what, from where.", "sightline") {
    app_.require_subcommand(1);
    app_.set_help_flag("--help,-h", "print this");
    app_.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "print the version");
    app_.footer(
        "Example:\n  sightline graph map.wkt -o graph.json --svg graph.svg\n\n"
        "`sightline COMMAND --help` tells the options of a command.\n"
        "Exit status: 0 done; 1 no answer, or a limit was reached; 2 bad usage or input; "
        "3 a bug; 130 interrupted.");
}

CLI::App& Program::add(const std::string& name, const std::string& what, const std::string& example,
                       Command command) {
    CLI::App& app = *app_.add_subcommand(name, what);
    app.set_help_flag("--help,-h", "print this");
    app.footer("Example:\n  " + example);
    add_common_options(app, common_);
    app.callback([this, command = std::move(command)] { chosen_ = command; });
    return app;
}

ExitStatus Program::run(int argc, char** argv) {
    try {
        app_.parse(argc, argv);
    } catch (const CLI::Success& request) {
        app_.exit(request);
        return ExitStatus::done;
    } catch (const CLI::ParseError& error) {
        if (names_no_command(argc, argv)) {
            return tell_usage(fmt::format("there is no command '{}'", argv[1]));
        }
        return tell_usage(one_line(error.what()));
    }
    try {
        return run_chosen();
    } catch (const std::bad_alloc&) {
        complain("limit reached: no more memory; nothing is written; use a smaller scene");
        return ExitStatus::no_answer;
    } catch (const std::exception& error) {
        complain(fmt::format("a bug: {}; please report it with the scene and the command line",
                             one_line(error.what())));
        return ExitStatus::bug;
    }
}

ExitStatus Program::run_chosen() {
    Session session(common_);
    const Result<ExitStatus> status = chosen_(session);
    if (status) return *status;
    session.progress().clear();
    if (status.error().code == Errc::cancelled) {
        complain(session.limit_message() + "; nothing is written; raise the limit");
        return ExitStatus::no_answer;
    }
    complain(one_line(status.error().message));
    return status_of(status.error().code);
}

ExitStatus Program::tell_usage(const std::string& what) const {
    std::string command = "sightline";
    for (const CLI::App* chosen : app_.get_subcommands()) command += " " + chosen->get_name();
    fmt::print(stderr, "{}: {}; see {} --help\n", command, what, command);
    return ExitStatus::bad_input;
}

bool Program::names_no_command(int argc, char** argv) const {
    if (argc < 2 || argv[1][0] == '-') return false;
    const std::string word = argv[1];
    const auto is_named = [&](const CLI::App* app) { return app->get_name() == word; };
    return app_.get_subcommands(is_named).empty();
}

void Program::allow_partial(CLI::App& app) {
    app.add_flag("--partial", common_.partial,
                 "when --limit-seconds is over, write what there is, marked as not complete");
}

void add_scene_arguments(CLI::App& app, SceneArguments& arguments) {
    app.add_option("SCENE", arguments.files,
                   "WKT, GeoJSON or text files; Doom maps as FILE.wad:MAP; - is standard input")
        ->required()
        ->type_name("");
    app.add_flag("--world", arguments.world,
                 "the first polygon is the free world, its holes are bodies");
    app.add_flag("--repair", arguments.repair,
                 "merge overlapping bodies and remove repeats, saying what was done");
    app.add_flag("--all-lines", arguments.all_lines,
                 "of Doom maps, also the lines with a floor on both sides");
}

void add_mesh_arguments(CLI::App& app, SceneArguments& arguments) {
    app.add_option("SCENE", arguments.files,
                   "OFF, OBJ, PLY or STL files, a mesh each; - is standard input")
        ->required()
        ->type_name("");
    app.add_flag("--world", arguments.world, "the inside of the first mesh is the free world");
    app.add_flag("--repair", arguments.repair,
                 "merge and remove what is double or degenerate, turn what looks inwards, saying "
                 "what was done");
    add_sheet_arguments(app, arguments);
}

void add_sheet_arguments(CLI::App& app, SceneArguments& arguments) {
    app.add_flag("--sheets", arguments.sheets,
                 "meshes are surfaces without thickness, not solids (a world excepted)");
    app.add_option("--sheet", arguments.sheet_files,
                   "a further mesh, which alone is such a surface; repeatable")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("FILE");
}

void add_output_arguments(CLI::App& app, OutputArguments& arguments) {
    const auto add = [&app](const char* name, std::string& path, const char* what) {
        app.add_option(name, path, what)
            ->type_name("FILE")
            ->group("Output")
            ->check(CLI::Validator(
                [](const std::string& file) {
                    return std::string(file.empty() ? "the name is empty" : "");
                },
                ""));
    };
    add("-o,--output", arguments.json, "JSON; standard output when no output is named");
    add("--vtk", arguments.vtk, "VTK polydata (.vtp)");
    add("--png", arguments.png, "picture");
    add("--svg", arguments.svg, "picture");
}

}  // namespace sightline::detail
