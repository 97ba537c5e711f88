// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "sightline/scene/doom.hpp"
#include "sightline/scene/mesh_io.hpp"
#include "sightline/scene/repair2.hpp"
#include "sightline/scene/repair3.hpp"
#include "sightline/scene/scene_io.hpp"

namespace sightline::detail {
namespace {

/// FILE.wad and MAP, when the name is of the form FILE.wad:MAP.
std::optional<std::pair<std::string, std::string>> doom_map(const std::string& name) {
    const std::size_t colon = name.rfind(':');
    const std::string file = name.substr(0, colon);
    if (!file.ends_with(".wad") && !file.ends_with(".WAD")) return std::nullopt;
    return std::pair{file, colon == std::string::npos ? "" : name.substr(colon + 1)};
}

Result<SceneInput2> load_doom(const std::string& file, const std::string& map, bool all_lines) {
    if (!map.empty()) return read_doom(file, map, DoomOptions{all_lines});
    const Result<std::vector<std::string>> maps = doom_maps(file);
    if (!maps) return tl::unexpected(maps.error());
    return fail(Errc::bad_parameter, fmt::format("{}: which map? Write {}:MAP with one of {}", file,
                                                 file, fmt::join(*maps, " ")));
}

Result<SceneInput2> load_file(const std::string& file, bool world, bool all_lines,
                              Session& session) {
    if (const auto doom = doom_map(file)) return load_doom(doom->first, doom->second, all_lines);
    ReadOptions options;
    options.world = world;
    options.progress = [&session](double fraction) { session.progress().update(fraction); };
    return read_input(file, options);
}

/// The elements of several files as one input; lines have no meaning there any more.
SceneInput2 joined(const std::vector<SceneInput2>& parts) {
    if (parts.size() == 1) return parts.front();
    SceneInput2 all;
    all.world = parts.front().world;
    for (const SceneInput2& part : parts) {
        if (!all.file.empty()) all.file += " + ";
        all.file += part.file;
        std::copy(part.elements.begin(), part.elements.end(), std::back_inserter(all.elements));
    }
    return all;
}

/// What a reader refuses to read is bad input, not a limit of this run.
Error as_bad_input(Error error) {
    if (error.code == Errc::limit_reached) error.code = Errc::unsupported;
    return error;
}

Result<std::vector<SceneInput2>> load_parts(const SceneArguments& arguments, Session& session) {
    if (std::count(arguments.files.begin(), arguments.files.end(), "-") > 1) {
        return fail(Errc::bad_parameter,
                    "standard input (-) is named twice; it can be read only once");
    }
    std::vector<SceneInput2> parts;
    for (const std::string& file : arguments.files) {
        Result<SceneInput2> part =
            load_file(file, arguments.world && parts.empty(), arguments.all_lines, session);
        if (!part) {
            return tl::unexpected(as_bad_input(std::move(part.error())));
        }
        if (part->world && !parts.empty()) {
            return fail(Errc::bad_parameter,
                        file + ": only the first file may be a world; name it first");
        }
        parts.push_back(std::move(*part));
    }
    return parts;
}

/// A fault within one file is better told with that file's name and lines.
Error fault_of(const std::vector<SceneInput2>& parts, const Error& whole) {
    if (parts.size() == 1) return whole;
    for (const SceneInput2& part : parts) {
        if (part.elements.empty()) continue;
        const Result<Scene2> alone = Scene2::make(part);
        if (!alone) return alone.error();
    }
    return whole;
}

Result<LoadedScene> load_repaired(const SceneInput2& input, const SceneArguments& arguments,
                                  Session& session) {
    Result<RepairedScene2> repaired = repair(input);
    if (!repaired) return tl::unexpected(repaired.error());
    for (const std::string& change : repaired->changes) session.note("repair: " + change);
    return LoadedScene{std::move(repaired->scene), arguments, std::move(repaired->changes)};
}

Result<SceneInput3> load_meshes(const SceneArguments& arguments) {
    SceneInput3 input;
    input.world = arguments.world;
    const auto add = [&](const std::string& file, SurfaceKind kind) -> Result<void> {
        MeshReadOptions options;
        options.kind = kind;
        Result<MeshInput3> mesh = read_mesh(file, options);
        if (!mesh) return tl::unexpected(as_bad_input(std::move(mesh.error())));
        input.meshes.push_back(std::move(*mesh));
        return {};
    };
    for (std::size_t i = 0; i < arguments.files.size(); ++i) {
        const bool is_world = arguments.world && i == 0;
        const bool is_sheet = arguments.sheets && !is_world;
        const auto ok = add(arguments.files[i], is_sheet ? SurfaceKind::sheet : SurfaceKind::solid);
        if (!ok) return tl::unexpected(ok.error());
    }
    for (const std::string& file : arguments.sheet_files)
        if (const auto ok = add(file, SurfaceKind::sheet); !ok) return tl::unexpected(ok.error());
    return input;
}

}  // namespace

bool names_meshes(const SceneArguments& arguments) {
    return arguments.sheets || !arguments.sheet_files.empty() ||
           (!arguments.files.empty() && mesh_format(arguments.files.front()).has_value());
}

Result<LoadedScene3> load_scene3(const SceneArguments& arguments, Session& session) {
    return session.timed("read", "reading", [&]() -> Result<LoadedScene3> {
        Result<SceneInput3> input = load_meshes(arguments);
        if (!input) return tl::unexpected(input.error());
        if (arguments.repair) {
            Result<RepairedScene3> repaired = repair(*input);
            if (!repaired) return tl::unexpected(repaired.error());
            for (const std::string& change : repaired->changes) session.note("repair: " + change);
            return LoadedScene3{std::move(repaired->scene), std::move(repaired->input), arguments,
                                std::move(repaired->changes)};
        }
        Result<Scene3> scene = Scene3::make(*input);
        if (!scene) return tl::unexpected(scene.error());
        return LoadedScene3{std::move(*scene), std::move(*input), arguments, {}};
    });
}

Result<LoadedScene> load_scene(const SceneArguments& arguments, Session& session) {
    return session.timed("read", "reading", [&]() -> Result<LoadedScene> {
        const Result<std::vector<SceneInput2>> parts = load_parts(arguments, session);
        if (!parts) return tl::unexpected(parts.error());
        if (arguments.repair) return load_repaired(joined(*parts), arguments, session);
        Result<Scene2> scene = Scene2::make(joined(*parts));
        if (!scene) return tl::unexpected(fault_of(*parts, scene.error()));
        return LoadedScene{std::move(*scene), arguments, {}};
    });
}

}  // namespace sightline::detail
