// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "cli/document.hpp"
#include "cli/program.hpp"
#include "sightline/viz/draw.hpp"

namespace sightline::detail {
namespace {

struct InfoArguments {
    SceneArguments scene;
    OutputArguments outputs;
};

Result<ExitStatus> run_info(const InfoArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    const Result<LoadedScene> loaded = load_scene(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    Document document;
    document.kind = "info";
    document.scene = &*loaded;
    document.result = [&](JsonWriter& json) {
        json.begin_object();
        json.member("vertices", loaded->scene.vertex_count());
        json.member("edges", loaded->scene.edge_count());
        json.member("bodies", loaded->scene.body_count());
        json.member("points", loaded->scene.points().size());
        json.member("world", loaded->scene.has_world());
        json.end();
    };
    document.picture = [&] { return viz::draw(loaded->scene); };
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    return ExitStatus::done;
}

}  // namespace

void add_info(Program& program) {
    const auto arguments = std::make_shared<InfoArguments>();
    CLI::App& app =
        program.add("info", "validate a scene, count, and list what is degenerate in it",
                    "sightline info coast.geojson --world --repair",
                    [arguments](Session& session) { return run_info(*arguments, session); });
    add_scene_arguments(app, arguments->scene);
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
