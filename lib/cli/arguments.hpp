// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sightline::detail {

/// The scene files of a command.
struct SceneArguments {
    std::vector<std::string> files;
    bool world = false;
    bool repair = false;
    bool all_lines = false;
    bool sheets = false;                   ///< meshes are sheets, except the world
    std::vector<std::string> sheet_files;  ///< meshes that are sheets, after `files`
};

/// Where a result goes; empty: not there.
struct OutputArguments {
    std::string json;
    std::string vtk;
    std::string png;
    std::string svg;

    [[nodiscard]] std::vector<std::string> given() const;
    [[nodiscard]] bool has_picture() const { return !(vtk.empty() && png.empty() && svg.empty()); }
};

}  // namespace sightline::detail
