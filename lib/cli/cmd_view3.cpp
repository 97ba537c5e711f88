// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "cli/document.hpp"
#include "cli/program.hpp"
#include "sightline/view/view3.hpp"
#include "sightline/viz/draw_view3.hpp"

namespace sightline::detail {
namespace {

using Layout = JsonWriter::Layout;

struct View3Arguments {
    SceneArguments scene;
    OutputArguments outputs;
    std::string from;
    std::string direction;
    std::vector<std::string> cone;
};

Result<RationalPoint3> parse_triple(const std::string& option, const std::string& text) {
    std::vector<Rational> numbers;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::string part = text.substr(begin, end - begin);
        part.erase(0, part.find_first_not_of(" \t"));
        part.erase(part.find_last_not_of(" \t") + 1);
        const auto number = Rational::parse(part);
        if (!number) break;
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() == 3 && begin == text.size() + 1) {
        return RationalPoint3{numbers[0], numbers[1], numbers[2]};
    }
    return fail(Errc::bad_parameter,
                fmt::format("{}: '{}' is no triple of numbers; write X,Y,Z with decimals or "
                            "fractions, as in 1.5,-7/2,0",
                            option, text));
}

struct View3Question {
    Viewpoint3 from;
    View3Options options;
};

Result<View3Question> question_of(const View3Arguments& arguments) {
    if (arguments.from.empty() == arguments.direction.empty()) {
        return fail(Errc::bad_parameter,
                    "one viewpoint is needed; give --from X,Y,Z or --direction X,Y,Z");
    }
    View3Question question;
    question.from.at_infinity = arguments.from.empty();
    const auto at = question.from.at_infinity ? parse_triple("--direction", arguments.direction)
                                              : parse_triple("--from", arguments.from);
    if (!at) return tl::unexpected(at.error());
    question.from.coordinates = *at;
    for (const std::string& text : arguments.cone) {
        const auto corner = parse_triple("--cone", text);
        if (!corner) return tl::unexpected(corner.error());
        question.options.cone.push_back(*corner);
    }
    return question;
}

void write_triple(JsonWriter& json, const RationalPoint3& p) {
    json.begin_array(Layout::inline_);
    for (const Rational* x : {&p.x, &p.y, &p.z}) json.value(x->to_string());
    json.end();
}

void write_edge(JsonWriter& json, const Scene3& scene, EdgeId e) {
    json.begin_array(Layout::inline_);
    json.value(scene[e].source.value);
    json.value(scene[e].target.value);
    json.end();
}

void write_edges(JsonWriter& json, const Scene3& scene, const std::vector<EdgeId>& edges) {
    json.begin_array(Layout::inline_);
    for (const EdgeId e : edges) write_edge(json, scene, e);
    json.end();
}

// Each node once, with a point on its line of sight; everything else names nodes by their number.
void write_nodes(JsonWriter& json, const Scene3& scene, const View3& view) {
    json.key("nodes");
    json.begin_array();
    for (std::uint32_t i = 0; i < view.map.nodes.size(); ++i) {
        const ViewNode& node = view.map.nodes[i];
        json.begin_object(Layout::inline_);
        json.key("point");
        write_triple(json, exact_point(scene, view, i));
        json.key("vertices");
        json.begin_array(Layout::inline_);
        for (const VertexId v : node.vertices) json.value(v.value);
        json.end();
        json.key("edges");
        write_edges(json, scene, node.edges);
        json.end();
    }
    json.end();
}

void write_regions(JsonWriter& json, const View3& view) {
    json.key("faces");
    json.begin_array();
    for (const ViewRegion& region : view.map.regions) {
        if (region.kind != ViewRegion::Kind::face) continue;
        json.begin_object(Layout::inline_);
        json.member("face", region.faces.front().face.value);
        if (region.faces.front().back) json.member("back", true);
        if (region.faces.size() > 1) {
            json.key("with");
            json.begin_array(Layout::inline_);
            for (std::size_t i = 1; i < region.faces.size(); ++i) {
                json.value(region.faces[i].face.value);
            }
            json.end();
        }
        json.key("area_rings");
        json.begin_array(Layout::inline_);
        for (const auto& ring : region.rings) {
            json.begin_array(Layout::inline_);
            for (const ViewHalfArc& h : ring) {
                const ViewArc& arc = view.map.arcs[h.arc];
                json.value(h.reversed ? arc.target : arc.source);
            }
            json.end();
        }
        json.end();
        json.end();
    }
    json.end();
}

void write_pieces(JsonWriter& json, const Scene3& scene, const View3& view) {
    json.key("edges");
    json.begin_array();
    for (const ViewPiece& piece : view.map.pieces) {
        json.begin_object(Layout::inline_);
        json.key("edge");
        write_edge(json, scene, piece.edge);
        json.key("nodes");
        json.begin_array(Layout::inline_);
        json.value(piece.from);
        json.value(piece.to);
        json.end();
        json.key("parameters");
        json.begin_array(Layout::inline_);
        for (const std::uint32_t node : {piece.from, piece.to}) {
            json.value(exact_parameter(scene, view, node, piece.edge).to_string());
        }
        json.end();
        json.end();
    }
    json.end();
}

void write_view(JsonWriter& json, const Scene3& scene, const View3& view) {
    json.begin_object();
    json.key(view.from.at_infinity ? "direction" : "from");
    write_triple(json, view.from.coordinates);
    write_nodes(json, scene, view);
    write_regions(json, view);
    write_pieces(json, scene, view);
    json.key("vertices");
    json.begin_array(Layout::inline_);
    for (const VertexId v : view.visible_vertices()) json.value(v.value);
    json.end();
    json.key("t_junctions");
    json.begin_array();
    for (const TJunction& t : view.map.t_junctions) {
        json.begin_object(Layout::inline_);
        json.key("front");
        write_edge(json, scene, t.front);
        json.key("back");
        write_edge(json, scene, t.back);
        json.member("node", t.node);
        json.end();
    }
    json.end();
    json.end();
}

nlohmann::ordered_json options_of(const View3Question& question, const Session& session) {
    nlohmann::ordered_json options;
    options["arithmetic"] = name_of(session.common().arithmetic);
    for (const RationalPoint3& p : question.options.cone) {
        options["cone"].push_back({p.x.to_string(), p.y.to_string(), p.z.to_string()});
    }
    return options;
}

Result<ExitStatus> run_view3(const View3Arguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    Result<View3Question> question = question_of(arguments);
    if (!question) return tl::unexpected(question.error());
    const Result<LoadedScene3> loaded = load_scene3(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    question->options.arithmetic = session.common().arithmetic;
    question->options.tally = &session.tally();
    const Result<View3> view = session.timed("build", "looking", [&] {
        return view3(loaded->scene, question->from, question->options);
    });
    if (!view) {
        const std::string name = question->from.at_infinity ? "--direction " + arguments.direction
                                                            : "--from " + arguments.from;
        return fail(view.error().code, name + ": " + view.error().message);
    }
    Document document;
    document.kind = "view";
    document.scene3 = &*loaded;
    document.options = options_of(*question, session);
    document.result = [&](JsonWriter& json) { write_view(json, loaded->scene, *view); };
    document.picture = [&] { return viz::draw(loaded->scene, *view); };
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    session.note(fmt::format("view3: {} faces, {} pieces of edges, {} T-junctions",
                             view->visible_faces().size(), view->map.pieces.size(),
                             view->map.t_junctions.size()));
    return ExitStatus::done;
}

}  // namespace

void add_view3(Program& program) {
    const auto arguments = std::make_shared<View3Arguments>();
    CLI::App& app =
        program.add("view3", "what is seen of a 3D scene from a point or along a direction",
                    "sightline view3 room.off --world --from 1.5,7/3,1 -o view.json --png view.png",
                    [arguments](Session& session) { return run_view3(*arguments, session); });
    add_mesh_arguments(app, arguments->scene);
    app.add_option("--from", arguments->from, "the viewpoint; exact: decimals or fractions p/q")
        ->type_name("X,Y,Z");
    app.add_option("--direction", arguments->direction,
                   "instead of --from: look along this direction, from infinity")
        ->type_name("X,Y,Z");
    app.add_option(
           "--cone", arguments->cone,
           "only what is seen in a convex cone: a point on each corner line, counter-clockwise; "
           "three times or more")
        ->type_name("X,Y,Z")
        ->take_all()
        ->allow_extra_args(false);
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
