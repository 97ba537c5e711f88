// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/info3.hpp"
#include "cli/program.hpp"
#include "sightline/scene/info2.hpp"
#include "sightline/viz/draw.hpp"

namespace sightline::detail {
namespace {

struct InfoArguments {
    SceneArguments scene;
    OutputArguments outputs;
};

using Json = nlohmann::ordered_json;

Json ids(const std::vector<VertexId>& vertices) {
    Json list = Json::array();
    for (const VertexId v : vertices) list.push_back(v.value);
    return list;
}

Json contacts(const SceneInfo2& info) {
    Json list = Json::array();
    for (const BodyContact2& contact : info.contacts) {
        Json bodies = Json::array();
        for (const BodyId b : {contact.first, contact.second}) {
            bodies.push_back(b.is_none() ? Json(nullptr) : Json(b.value));
        }
        list.push_back({{"bodies", bodies}, {"points", contact.points}, {"edges", contact.edges}});
    }
    return list;
}

/// Key and value, in the order in which they are written.
Json degeneracies(const SceneInfo2& info) {
    Json result = Json::object();
    result["contacts"] = contacts(info);
    result["coincident_vertices"] = Json::array();
    for (const auto& place : info.coincident) result["coincident_vertices"].push_back(ids(place));
    result["pinches"] = ids(info.pinches);
    result["straight_vertices"] = ids(info.straight);
    result["nearly_straight_vertices"] = ids(info.nearly_straight);
    result["vertices_on_edges"] = Json::array();
    for (const auto& [v, e] : info.vertices_on_edges) {
        result["vertices_on_edges"].push_back({v.value, e.value});
    }
    result["crossing_walls"] = info.crossing_walls;
    result["overlapping_walls"] = info.overlapping_walls;
    result["all_walls_compared"] = info.all_walls_compared;
    return result;
}

void write_info(JsonWriter& json, const SceneInfo2& info, const LoadedScene& loaded) {
    json.begin_object();
    json.member("vertices", info.vertices);
    json.member("points", info.points);
    json.member("bodies", info.bodies);
    json.member("holes", info.holes);
    json.member("body_edges", info.body_edges);
    json.member("world_edges", info.world_edges);
    json.member("walls", info.walls);
    json.member("world", info.has_world);
    json.key("box");
    json.tree(Json::array({to_json(info.low), to_json(info.high)}));
    json.member("approx_shortest_edge", info.approx_shortest_edge);
    json.member("approx_extent", info.approx_extent);
    json.member("degenerate", info.is_degenerate());
    json.key("degeneracies");
    json.begin_object();
    const Json lists = degeneracies(info);
    for (const auto& item : lists.items()) {
        json.key(item.key());
        json.tree(item.value());
    }
    json.end();
    if (loaded.arguments.repair) {
        json.key("repairs");
        json.begin_array();
        for (const std::string& line : loaded.repairs) json.value(line);
        json.end();
    }
    json.end();
}

Result<ExitStatus> run_info(const InfoArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    if (names_meshes(arguments.scene))
        return run_info3(arguments.scene, arguments.outputs, session);
    const Result<LoadedScene> loaded = load_scene(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const SceneInfo2 info =
        session.timed("build", "describing", [&] { return describe(loaded->scene); });
    // Asked for nothing else, it tells people.
    if (arguments.outputs.given().empty()) {
        std::cout << to_text(info) << std::flush;
        return ExitStatus::done;
    }
    Document document;
    document.kind = "info";
    document.scene = &*loaded;
    document.result = [&](JsonWriter& json) { write_info(json, info, *loaded); };
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
    app.get_option("SCENE")->description(
        "WKT, GeoJSON or text files, Doom maps as FILE.wad:MAP; or OFF, OBJ, PLY or STL files, a "
        "mesh each; - is standard input");
    add_sheet_arguments(app, arguments->scene);
    add_output_arguments(app, arguments->outputs);
    app.get_option("--output")->description("JSON; without any output, text on standard output");
}

}  // namespace sightline::detail
