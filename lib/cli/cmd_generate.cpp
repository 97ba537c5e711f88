// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/output_set.hpp"
#include "cli/program.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/scene_io.hpp"

namespace sightline::detail {
namespace {

struct GenerateArguments {
    bool list = false;
    std::vector<std::string> family_and_parameters;
    std::uint64_t seed = 1;
    std::string output;
};

/// By the ending; standard output gets our own text.
Result<SceneFormat2> format_of(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (path.empty() || path == "-") return SceneFormat2::text;
    if (ending == ".wkt") return SceneFormat2::wkt;
    if (ending == ".geojson" || ending == ".json") return SceneFormat2::geojson;
    if (ending == ".txt" || ending == ".scene") return SceneFormat2::text;
    return fail(Errc::bad_parameter,
                path +
                    ": the ending tells no format; name a .wkt, .geojson, .json, .txt or "
                    ".scene file");
}

void print_families() {
    for (const families::FamilyInfo& family : families::all2()) {
        std::string usage(family.name);
        for (const families::FamilyParameter& parameter : family.parameters) {
            usage += fmt::format(" [{}={}]", parameter.name, parameter.default_value);
        }
        std::cout << fmt::format("{:<44} {}\n", usage, family.description);
    }
}

Result<ExitStatus> run_generate(const GenerateArguments& arguments, Session& session) {
    if (arguments.list) {
        print_families();
        return ExitStatus::done;
    }
    if (arguments.family_and_parameters.empty()) {
        return fail(Errc::bad_parameter, "no family is named; see sightline generate --list");
    }
    const Result<SceneFormat2> format = format_of(arguments.output);
    if (!format) return tl::unexpected(format.error());
    const std::string output = arguments.output.empty() ? "-" : arguments.output;
    if (const auto checked = OutputSet::check(std::span(&output, 1), {}); !checked) {
        return tl::unexpected(checked.error());
    }
    const std::span words(arguments.family_and_parameters);
    const Result<SceneInput2> scene = session.timed("build", "generating", [&] {
        return families::generate2(words.front(), words.subspan(1), arguments.seed);
    });
    if (!scene) return tl::unexpected(scene.error());
    OutputSet files;
    const Result<void> written =
        files.write(output, [&](std::ostream& out) { write_input(out, *scene, *format); });
    if (!written) return tl::unexpected(written.error());
    if (const Result<void> done = files.commit(); !done) return tl::unexpected(done.error());
    const bool tell_world = scene->world && *format == SceneFormat2::wkt;
    session.note(fmt::format("generate: {} elements, seed {}{}", scene->elements.size(),
                             arguments.seed, tell_world ? "; a world: read it with --world" : ""));
    return ExitStatus::done;
}

}  // namespace

void add_generate(Program& program) {
    const auto arguments = std::make_shared<GenerateArguments>();
    CLI::App& app =
        program.add("generate", "a scene of a named family",
                    "sightline generate dense 1000 --seed 7 -o dense.geojson",
                    [arguments](Session& session) { return run_generate(*arguments, session); });
    app.add_option("FAMILY", arguments->family_and_parameters,
                   "a family and its parameters, whole numbers; see --list")
        ->type_name("[PARAMETER...]");
    app.add_flag("--list", arguments->list, "print the families with their parameters");
    app.add_option("--seed", arguments->seed, "of the random numbers; 1 when not given")
        ->type_name("S");
    app.add_option("-o,--output", arguments->output,
                   "scene, its format by the ending; standard output, as text, when not named")
        ->type_name("FILE")
        ->group("Output");
}

}  // namespace sightline::detail
