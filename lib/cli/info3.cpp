// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info3.hpp"

#include <iostream>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "sightline/scene/info3.hpp"
#include "sightline/viz/draw3.hpp"

namespace sightline::detail {
namespace {

using Json = nlohmann::ordered_json;

template <typename IdType>
Json numbers(const std::vector<IdType>& ids) {
    Json list = Json::array();
    for (const IdType id : ids) list.push_back(id.value);
    return list;
}

template <typename IdType>
Json numbers(const std::vector<std::vector<IdType>>& groups) {
    Json list = Json::array();
    for (const auto& group : groups) list.push_back(numbers(group));
    return list;
}

Json corner(const Point3& p) {
    return {Rational(p.x).to_string(), Rational(p.y).to_string(), Rational(p.z).to_string()};
}

Json degeneracies(const SceneInfo3& info) {
    Json result = Json::object();
    result["contacts"] = Json::array();
    for (const BodyContact3& c : info.contacts) {
        result["contacts"].push_back({{"bodies", {c.first.value, c.second.value}},
                                      {"places", c.places},
                                      {"edges", c.edges},
                                      {"faces", c.faces}});
    }
    result["coincident_vertices"] = numbers(info.coincident);
    result["isolated_vertices"] = numbers(info.isolated);
    result["flat_vertices"] = numbers(info.flat);
    result["coplanar_faces"] = numbers(info.coplanar);
    result["collinear_edges"] = numbers(info.collinear);
    result["parallel_edges"] = info.parallel_edges;
    result["parallel_directions"] = info.parallel_directions;
    result["nearly_flat_edges"] = numbers(info.nearly_flat);
    return result;
}

void write_info(JsonWriter& json, const SceneInfo3& info, const LoadedScene3& loaded) {
    json.begin_object();
    json.member("vertices", info.vertices);
    json.member("feature_vertices", info.feature_vertices);
    json.member("edges", info.edges);
    json.member("border_edges", info.border_edges);
    json.member("faces", info.faces);
    json.member("input_faces", info.input_faces);
    json.member("holes", info.holes);
    json.member("triangles", info.triangles);
    json.member("solids", info.solids);
    json.member("sheets", info.sheets);
    json.member("world", info.has_world);
    json.key("box");
    json.tree(Json::array({corner(info.low), corner(info.high)}));
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

}  // namespace

Result<ExitStatus> run_info3(const SceneArguments& scene, const OutputArguments& outputs,
                             Session& session) {
    const Result<LoadedScene3> loaded = load_scene3(scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const SceneInfo3 info =
        session.timed("build", "describing", [&] { return describe(loaded->scene); });
    if (outputs.given().empty()) {
        std::cout << to_text(info) << std::flush;
        return ExitStatus::done;
    }
    Document document;
    document.kind = "info";
    document.scene3 = &*loaded;
    document.result = [&](JsonWriter& json) { write_info(json, info, *loaded); };
    document.picture = [&] { return viz::draw(loaded->scene); };
    const auto written = write_outputs(outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    return ExitStatus::done;
}

}  // namespace sightline::detail
