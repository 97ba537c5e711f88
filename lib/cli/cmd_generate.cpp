// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/output_set.hpp"
#include "cli/program.hpp"
#include "scene/families_registry.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/scene/off.hpp"
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

std::vector<std::string_view> all_names() {
    std::vector<std::string_view> names;
    for (const families::FamilyInfo& family : families::all2()) names.push_back(family.name);
    for (const families::FamilyInfo3& family : families::all3()) names.push_back(family.name);
    return names;
}

/// Whether the name is of a family of 3D scenes.
Result<bool> is_3d(const std::string& name) {
    const auto has_name = [&](const auto& family) { return family.name == name; };
    if (std::ranges::any_of(families::all3(), has_name)) return true;
    if (std::ranges::any_of(families::all2(), has_name)) return false;
    return families::detail::no_family(name, all_names());
}

/// One line a family of both dimensions, sorted by name.
void print_families() {
    std::vector<std::string> lines;
    const auto add = [&lines](const auto& family, const char* dimension) {
        std::string usage(family.name);
        for (const families::FamilyParameter& parameter : family.parameters) {
            usage += fmt::format(" [{}={}]", parameter.name, parameter.default_value);
        }
        lines.push_back(fmt::format("{:<44} {}{}\n", usage, dimension, family.description));
    };
    for (const families::FamilyInfo& family : families::all2()) add(family, "");
    for (const families::FamilyInfo3& family : families::all3()) add(family, "3D: ");
    std::ranges::sort(lines, {}, [](const std::string& line) {
        return std::string_view(line).substr(0, line.find(' '));
    });
    for (const std::string& line : lines) std::cout << line;
}

Result<ExitStatus> generate_2d(const GenerateArguments& arguments, Session& session) {
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

/// Where the bodies in a world go: the world is a file of its own, read before them.
std::string bodies_file(const std::string& world_file) {
    std::filesystem::path path(world_file);
    return path.replace_extension().string() + "-bodies.off";
}

/// A scene with a world goes to two files, as it is read: the world, then the bodies.
Result<void> write_3d(const std::string& output, const SceneInput3& scene, OutputSet& files) {
    if (!scene.world || output == "-") {
        return files.write(output, [&](std::ostream& out) { write_off(out, scene); });
    }
    SceneInput3 world{{scene.meshes.front()}, true};
    SceneInput3 bodies{{scene.meshes.begin() + 1, scene.meshes.end()}, false};
    const auto written = files.write(output, [&](std::ostream& out) { write_off(out, world); });
    if (!written) return written;
    return files.write(bodies_file(output), [&](std::ostream& out) { write_off(out, bodies); });
}

/// What the user should know to read the scene.
std::string reading_hint(const std::string& output, const SceneInput3& scene) {
    if (scene.world && output == "-") return "; a world, whose faces come first";
    if (scene.world)
        return fmt::format("; a world: read it as {} {} --world", output, bodies_file(output));
    const bool sheets = scene.meshes.front().kind == SurfaceKind::sheet;
    return sheets ? "; sheets: read it with --sheets" : "";
}

Result<ExitStatus> generate_3d(const GenerateArguments& arguments, Session& session) {
    const std::string output = arguments.output.empty() ? "-" : arguments.output;
    if (output != "-" && std::filesystem::path(output).extension() != ".off") {
        return fail(Errc::bad_parameter,
                    output + ": 3D scenes are written as OFF; name a .off file");
    }
    if (const auto checked = OutputSet::check(std::span(&output, 1), {}); !checked) {
        return tl::unexpected(checked.error());
    }
    const std::span words(arguments.family_and_parameters);
    const Result<SceneInput3> scene = session.timed("build", "generating", [&] {
        return families::generate3(words.front(), words.subspan(1), arguments.seed);
    });
    if (!scene) return tl::unexpected(scene.error());
    OutputSet files;
    const Result<void> written = write_3d(output, *scene, files);
    if (!written) return tl::unexpected(written.error());
    if (const Result<void> done = files.commit(); !done) return tl::unexpected(done.error());
    std::size_t faces = 0;
    for (const MeshInput3& mesh : scene->meshes) faces += mesh.faces.size();
    session.note(fmt::format("generate: {} faces, seed {}{}", faces, arguments.seed,
                             reading_hint(output, *scene)));
    return ExitStatus::done;
}

Result<ExitStatus> run_generate(const GenerateArguments& arguments, Session& session) {
    if (arguments.list) {
        print_families();
        return ExitStatus::done;
    }
    if (arguments.family_and_parameters.empty()) {
        return fail(Errc::bad_parameter, "no family is named; see sightline generate --list");
    }
    const Result<bool> solid = is_3d(arguments.family_and_parameters.front());
    if (!solid) return tl::unexpected(solid.error());
    return *solid ? generate_3d(arguments, session) : generate_2d(arguments, session);
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
    app.add_flag("--list", arguments->list,
                 "print the families of 2D and 3D scenes with their parameters");
    app.add_option("--seed", arguments->seed, "of the random numbers; 1 when not given")
        ->type_name("S");
    app.add_option("-o,--output", arguments->output,
                   "scene, its format by the ending (.off for 3D); standard output, as text or "
                   "OFF, when not "
                   "named")
        ->type_name("FILE")
        ->group("Output");
}

}  // namespace sightline::detail
