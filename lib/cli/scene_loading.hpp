// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/session.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

/// A scene and where it comes from.
struct LoadedScene {
    Scene2 scene;
    SceneArguments arguments;
    std::vector<std::string> repairs;  ///< what --repair did, one line each
};

/// Reads the files, in their order, into one scene. An error names the file at fault.
[[nodiscard]] Result<LoadedScene> load_scene(const SceneArguments& arguments, Session& session);

}  // namespace sightline::detail
