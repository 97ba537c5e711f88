// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "cli/session.hpp"

/// The commands and what they have in common. Each cmd_<command>.cpp adds one.
namespace sightline::detail {

/// The work of a command, once its arguments are read.
using Command = std::function<Result<ExitStatus>(Session&)>;

/// The scene files of a command.
struct SceneArguments {
    std::vector<std::string> files;
    bool world = false;
    bool repair = false;
    bool all_lines = false;
};

/// Where a result goes; empty: not there.
struct OutputArguments {
    std::string json;
    std::string vtk;
    std::string png;
    std::string svg;

    [[nodiscard]] std::vector<std::string> given() const;
};

class Program {
public:
    Program();

    /// Adds a command with the common options. `example` closes its help.
    CLI::App& add(const std::string& name, const std::string& what, const std::string& example,
                  Command command);

    /// Reads the arguments, runs the command, tells errors on standard error.
    [[nodiscard]] ExitStatus run(int argc, char** argv);

private:
    [[nodiscard]] ExitStatus run_chosen();
    [[nodiscard]] ExitStatus tell_usage(const CLI::ParseError& error) const;

    CLI::App app_;
    CommonOptions common_;
    Command chosen_;
};

/// SCENE..., --world, --repair, --all-lines.
void add_scene_arguments(CLI::App& app, SceneArguments& arguments);
/// -o, --vtk, --png, --svg.
void add_output_arguments(CLI::App& app, OutputArguments& arguments);
/// --partial, for commands whose unfinished results mean something.
void add_partial(CLI::App& app, bool& partial);

void add_info(Program& program);
void add_graph(Program& program);

}  // namespace sightline::detail
