// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/program.hpp"
#include "sightline/planar/shortest_path.hpp"
#include "sightline/viz/draw.hpp"

namespace sightline::detail {
namespace {

struct PathArguments {
    SceneArguments scene;
    OutputArguments outputs;
    std::string from;
    std::string to;
};

void write_path(JsonWriter& json, const Result<ShortestPath>& path) {
    json.begin_object();
    if (!path) {
        json.member("unreachable", true);
        json.end();
        return;
    }
    json.key("points");
    json.begin_array();
    for (const RationalPoint2& p : path->points) write_point(json, p);
    json.end();
    json.key("vertices");
    json.begin_array(JsonWriter::Layout::inline_);
    for (const VertexId v : path->vertices) json.value(v.value);
    json.end();
    json.key("length");
    json.begin_object(JsonWriter::Layout::inline_);
    json.member("approx_value", path->length.approx_middle());
    json.member("lower", Rational(path->length.lower).to_string());
    json.member("upper", Rational(path->length.upper).to_string());
    json.end();
    json.end();
}

Result<ShortestPath> build(const Scene2& scene, const RationalPoint2& from,
                           const RationalPoint2& to, Session& session) {
    ShortestPathOptions options;
    options.arithmetic = session.common().arithmetic;
    options.threads = session.common().threads;
    options.tally = &session.tally();
    return session.timed("build", "looking for the path",
                         [&] { return shortest_path(scene, from, to, options); });
}

Result<ExitStatus> run_path(const PathArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    const Result<RationalPoint2> from = parse_point("--from", arguments.from);
    if (!from) return tl::unexpected(from.error());
    const Result<RationalPoint2> to = parse_point("--to", arguments.to);
    if (!to) return tl::unexpected(to.error());
    const Result<LoadedScene> loaded = load_scene(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const Result<ShortestPath> path = build(loaded->scene, *from, *to, session);
    if (!path && path.error().code != Errc::unreachable) return tl::unexpected(path.error());

    Document document;
    document.kind = "shortest_path";
    document.scene = &*loaded;
    document.options["arithmetic"] = name_of(session.common().arithmetic);
    document.options["from"] = to_json(*from);
    document.options["to"] = to_json(*to);
    document.result = [&](JsonWriter& json) { write_path(json, path); };
    document.picture = [&] {
        return path ? viz::draw(loaded->scene, *path) : viz::draw(loaded->scene);
    };
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    // An answer all the same, so the error is told after the files are there.
    if (!path) return tl::unexpected(path.error());
    session.note(fmt::format("path: length {:.12g}, {} turns", path->length.approx_middle(),
                             path->vertices.size()));
    return ExitStatus::done;
}

}  // namespace

void add_path(Program& program) {
    const auto arguments = std::make_shared<PathArguments>();
    CLI::App& app =
        program.add("path", "shortest path between two points",
                    "sightline path map.wkt --from 1.5,2 --to 7/3,-4 -o path.json",
                    [arguments](Session& session) { return run_path(*arguments, session); });
    add_scene_arguments(app, arguments->scene);
    app.add_option("--from", arguments->from, "where it begins; exact: decimals or fractions")
        ->required()
        ->type_name("X,Y");
    app.add_option("--to", arguments->to, "where it ends")->required()->type_name("X,Y");
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
