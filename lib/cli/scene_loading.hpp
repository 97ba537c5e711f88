// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/session.hpp"
#include "sightline/scene/scene2.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::detail {

/// A scene and where it comes from.
struct LoadedScene {
    Scene2 scene;
    SceneArguments arguments;
    std::vector<std::string> repairs;  ///< what --repair did, one line each
};

/// Reads the files, in their order, into one scene. An error names the file at fault.
[[nodiscard]] Result<LoadedScene> load_scene(const SceneArguments& arguments, Session& session);

/// A scene of space and where it comes from.
struct LoadedScene3 {
    Scene3 scene;
    SceneInput3 input;  ///< what the scene was made of; repaired with --repair
    SceneArguments arguments;
    std::vector<std::string> repairs;  ///< what --repair did, one line each
};

/// Whether the files are meshes (.off, .obj, .ply, .stl), so that load_scene3 reads them. A command that takes
/// both kinds of scenes asks; the first file decides.
[[nodiscard]] bool names_meshes(const SceneArguments& arguments);

/// Reads the files, in their order, each as one mesh of the scene. An error names the file at fault.
[[nodiscard]] Result<LoadedScene3> load_scene3(const SceneArguments& arguments, Session& session);

}  // namespace sightline::detail
