// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/program.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/viz/draw.hpp"

namespace sightline::detail {
namespace {

struct GraphArguments {
    SceneArguments scene;
    OutputArguments outputs;
    std::string collinear = "nearest";
    bool tangent = false;
    bool partial = false;
    std::vector<std::string> add;
};

Result<std::vector<Point2>> added_points(const GraphArguments& arguments) {
    std::vector<Point2> points;
    for (const std::string& text : arguments.add) {
        const Result<Point2> p = parse_scene_point("--add", text);
        if (!p) return tl::unexpected(p.error());
        points.push_back(*p);
    }
    return points;
}

/// The scene with the points of --add.
Result<LoadedScene> load(const GraphArguments& arguments, std::span<const Point2> added,
                         Session& session) {
    Result<LoadedScene> loaded = load_scene(arguments.scene, session);
    if (!loaded || added.empty()) return loaded;
    Result<Scene2> scene = loaded->scene.with_points(added);
    if (!scene) return tl::unexpected(scene.error());
    loaded->scene = std::move(*scene);
    return loaded;
}

nlohmann::ordered_json options_of(const GraphArguments& arguments, std::span<const Point2> added,
                                  const Session& session) {
    nlohmann::ordered_json options;
    options["arithmetic"] = name_of(session.common().arithmetic);
    options["collinear"] = arguments.collinear;
    options["tangent"] = arguments.tangent;
    if (!added.empty()) {
        options["add"] = nlohmann::ordered_json::array();
        for (const Point2& p : added) options["add"].push_back(to_json(p));
    }
    return options;
}

void write_graph(JsonWriter& json, const Scene2& scene, const VisibilityGraph& graph) {
    json.begin_object();
    json.key("vertices");
    json.begin_array();
    for (const Point2& p : scene.vertices()) write_point(json, p);
    json.end();
    json.key("edges");
    json.begin_array();
    for (std::uint32_t u = 0; u < graph.vertex_count(); ++u) {
        const auto row = graph.neighbours(VertexId{u});
        const auto above = std::upper_bound(row.begin(), row.end(), VertexId{u});
        for (auto v = above; v != row.end(); ++v) {
            json.begin_array(JsonWriter::Layout::inline_);
            json.value(u);
            json.value(v->value);
            json.end();
        }
    }
    json.end();
    json.end();
}

Result<VisibilityGraph> build(const GraphArguments& arguments, const Scene2& scene,
                              Session& session) {
    VisibilityGraphOptions options;
    options.collinear =
        arguments.collinear == "all" ? Collinear::every_vertex : Collinear::nearest_only;
    options.tangent_only = arguments.tangent;
    options.arithmetic = session.common().arithmetic;
    options.threads = session.common().threads;
    options.tally = &session.tally();
    return session.timed("build", "building the graph",
                         [&] { return visibility_graph(scene, options, session.limits()); });
}

Result<ExitStatus> run_graph(const GraphArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    const auto added = added_points(arguments);
    if (!added) return tl::unexpected(added.error());
    const Result<LoadedScene> loaded = load(arguments, *added, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const Result<VisibilityGraph> graph = build(arguments, loaded->scene, session);
    if (!graph) return tl::unexpected(graph.error());

    Document document;
    document.kind = "visibility_graph";
    document.scene = &*loaded;
    document.options = options_of(arguments, *added, session);
    document.result = [&](JsonWriter& json) { write_graph(json, loaded->scene, *graph); };
    document.picture = [&] { return viz::draw(loaded->scene, *graph); };
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    session.note(
        fmt::format("graph: {} vertices, {} edges", graph->vertex_count(), graph->edge_count()));
    return ExitStatus::done;
}

}  // namespace

void add_graph(Program& program) {
    const auto arguments = std::make_shared<GraphArguments>();
    CLI::App& app =
        program.add("graph", "2D visibility graph",
                    "sightline graph map.wkt --collinear all -o graph.json --svg graph.svg",
                    [arguments](Session& session) { return run_graph(*arguments, session); });
    add_scene_arguments(app, arguments->scene);
    app.add_option("--collinear", arguments->collinear,
                   "of several vertices on one line of sight, join the nearest (default) or all")
        ->check(CLI::IsMember({"nearest", "all"}))
        ->type_name("RULE");
    app.add_flag("--tangent", arguments->tangent, "only edges that are tangent at both ends");
    app.add_option("--add", arguments->add, "a further vertex; repeatable")
        ->type_name("X,Y")
        ->take_all()
        ->allow_extra_args(false);
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
