// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_loading.hpp"

#include <algorithm>
#include <iterator>

#include "sightline/scene/scene_io.hpp"

namespace sightline::detail {
namespace {

Result<SceneInput2> load_file(const std::string& file, bool world, Session& session) {
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

Result<std::vector<SceneInput2>> load_parts(const SceneArguments& arguments, Session& session) {
    if (std::count(arguments.files.begin(), arguments.files.end(), "-") > 1) {
        return fail(Errc::bad_parameter,
                    "standard input (-) is named twice; it can be read only once");
    }
    std::vector<SceneInput2> parts;
    for (const std::string& file : arguments.files) {
        Result<SceneInput2> part = load_file(file, arguments.world && parts.empty(), session);
        if (!part) return tl::unexpected(part.error());
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

}  // namespace

Result<LoadedScene> load_scene(const SceneArguments& arguments, Session& session) {
    return session.timed("read", "reading", [&]() -> Result<LoadedScene> {
        const Result<std::vector<SceneInput2>> parts = load_parts(arguments, session);
        if (!parts) return tl::unexpected(parts.error());
        Result<Scene2> scene = Scene2::make(joined(*parts));
        if (!scene) return tl::unexpected(fault_of(*parts, scene.error()));
        return LoadedScene{std::move(*scene), arguments, {}};
    });
}

}  // namespace sightline::detail
