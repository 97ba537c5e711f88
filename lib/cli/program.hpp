// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/arguments.hpp"
#include "cli/session.hpp"

/// The commands and what they have in common. Each cmd_<command>.cpp adds one.
namespace sightline::detail {

/// The work of a command, once its arguments are read.
using Command = std::function<Result<ExitStatus>(Session&)>;

class Program {
public:
    Program();

    /// Adds a command with the common options. `example` closes its help.
    CLI::App& add(const std::string& name, const std::string& what, const std::string& example,
                  Command command);

    /// Adds --partial, for commands whose unfinished results mean something.
    void allow_partial(CLI::App& app);

    /// Reads the arguments, runs the command, tells errors on standard error.
    [[nodiscard]] ExitStatus run(int argc, char** argv);

private:
    [[nodiscard]] ExitStatus run_chosen();
    [[nodiscard]] ExitStatus tell_usage(const std::string& what) const;
    [[nodiscard]] bool names_no_command(int argc, char** argv) const;

    CLI::App app_;
    CommonOptions common_;
    Command chosen_;
};

/// SCENE..., --world, --repair, --all-lines.
void add_scene_arguments(CLI::App& app, SceneArguments& arguments);
/// For commands on meshes: SCENE... (OFF, OBJ, PLY, STL), --world, --repair, --sheets, --sheet.
void add_mesh_arguments(CLI::App& app, SceneArguments& arguments);
/// --sheets, --sheet, for commands that take both kinds of scenes.
void add_sheet_arguments(CLI::App& app, SceneArguments& arguments);
/// -o, --vtk, --png, --svg.
void add_output_arguments(CLI::App& app, OutputArguments& arguments);
void add_info(Program& program);
void add_graph(Program& program);
void add_view2(Program& program);
void add_view3(Program& program);
void add_path(Program& program);
void add_transversals(Program& program);
void add_skeleton(Program& program);
void add_render(Program& program);
void add_show(Program& program);
void add_generate(Program& program);
void add_torture(Program& program);
void add_check(Program& program);

}  // namespace sightline::detail
