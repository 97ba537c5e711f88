// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "cli/document.hpp"
#include "cli/picture.hpp"
#include "cli/program.hpp"
#include "sightline/viz/render.hpp"

namespace sightline::detail {
namespace {

struct RenderArguments {
    PictureArguments picture;
    OutputArguments outputs;
};

/// -o takes a picture by its ending.
Result<OutputArguments> outputs_of(const RenderArguments& arguments) {
    OutputArguments outputs = arguments.outputs;
    std::string name;
    std::swap(name, outputs.json);
    if (name.ends_with(".svg")) {
        outputs.svg = name;
    } else if (name.ends_with(".png")) {
        outputs.png = name;
    } else if (name.ends_with(".vtp") || name.ends_with(".vtm")) {
        outputs.vtk = name;
    } else if (!name.empty()) {
        return fail(Errc::bad_parameter,
                    name + ": the ending tells no picture; name a .svg, .png, .vtp or .vtm file");
    }
    if (!outputs.has_picture()) {
        return fail(Errc::bad_parameter, "no picture is named; give --png, --svg or --vtk a file");
    }
    return outputs;
}

Result<ExitStatus> run_render(const RenderArguments& arguments, Session& session) {
    const Result<OutputArguments> outputs = outputs_of(arguments);
    if (!outputs) return tl::unexpected(outputs.error());
    if (const auto checked = check_outputs(*outputs, arguments.picture.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    const Result<viz::DrawList> picture = load_picture(arguments.picture, session);
    if (!picture) return tl::unexpected(picture.error());
    Document document;
    document.picture = [&] { return *picture; };
    const auto written = write_outputs(*outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    return ExitStatus::done;
}

Result<ExitStatus> run_show(const PictureArguments& arguments, Session& session) {
    if (!viz::has_rendering()) {
        return fail(Errc::unsupported,
                    "this program was built without VTK; write --svg with render instead");
    }
    const Result<viz::DrawList> picture = load_picture(arguments, session);
    if (!picture) return tl::unexpected(picture.error());
    const auto shown = viz::show(*picture);
    if (!shown) return tl::unexpected(shown.error());
    return ExitStatus::done;
}

void add_picture_arguments(CLI::App& app, PictureArguments& arguments) {
    add_scene_arguments(app, arguments.scene);
    app.get_option("SCENE")->description("scene and result files, in any order");
    app.add_option("--title", arguments.title, "above the picture")->type_name("TEXT");
    app.add_flag("--vertices", arguments.vertices, "mark the vertices");
    app.add_flag("--labels", arguments.labels, "name the vertices");
    add_sheet_arguments(app, arguments.scene);
    app.add_option("--look-from", arguments.camera.look_from,
                   "of space: the direction towards the eye; 1,-1,1 unless given")
        ->type_name("X,Y,Z");
    app.add_flag("--see-through", arguments.camera.see_through, "of space: solids like glass");
    app.add_option("--arcs", arguments.arcs,
                   "of skeletons: only arcs of these types, or with these numbers")
        ->type_name("LIST");
}

}  // namespace

void add_render(Program& program) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App& app =
        program.add("render", "picture of a scene, of the plane or of space, and of result files",
                    "sightline render map.wkt graph.json path.json --png picture.png",
                    [arguments](Session& session) { return run_render(*arguments, session); });
    add_picture_arguments(app, arguments->picture);
    add_output_arguments(app, arguments->outputs);
    app.get_option("--output")->description("picture, by its ending");
}

void add_show(Program& program) {
    const auto arguments = std::make_shared<PictureArguments>();
    CLI::App& app = program.add("show", "interactive window with a scene and result files",
                                "sightline show map.wkt view.json", [arguments](Session& session) {
                                    return run_show(*arguments, session);
                                });
    add_picture_arguments(app, *arguments);
}

}  // namespace sightline::detail
