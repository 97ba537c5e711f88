// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/result_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace sightline::detail {
namespace {

using Json = nlohmann::json;

/// What is wrong with the content; turned into an Error where the file's name is known.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Rational rational(const Json& json) {
    const auto number = Rational::parse(json.get_ref<const std::string&>());
    if (!number) throw Malformed("'" + json.get<std::string>() + "' is no exact number");
    return *number;
}

RationalPoint2 point(const Json& json) {
    if (json.size() != 2) throw Malformed("a point has two coordinates, not " + json.dump());
    return {rational(json.at(0)), rational(json.at(1))};
}

ViewPoint view_point(const Json& json) {
    if (json.is_object()) return {point(json.at("direction")), true};
    return {point(json), false};
}

ExactView view(const Json& json) {
    ExactView result;
    result.from = point(json.at("from"));
    for (const Json& p : json.at("ring")) result.ring.push_back(view_point(p));
    for (const Json& needle : json.at("needles")) {
        result.needles.emplace_back(view_point(needle.at(0)), view_point(needle.at(1)));
    }
    return result;
}

VisibilityGraph::Edge edge(const Json& json) {
    return {VertexId{json.at(0).get<std::uint32_t>()}, VertexId{json.at(1).get<std::uint32_t>()}};
}

/// Millions of edges are taken out as they come, not kept as a tree.
class EdgeCollector {
public:
    explicit EdgeCollector(std::vector<VisibilityGraph::Edge>& edges) : edges_(edges) {}

    bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
        constexpr int depth_of_an_edge = 3;
        if (event == Json::parse_event_t::key && depth == 2) {
            in_edges_ = parsed == "edges";
        } else if (event == Json::parse_event_t::key && depth == 1) {
            in_edges_ = false;
        } else if (event == Json::parse_event_t::array_end && in_edges_ &&
                   depth == depth_of_an_edge) {
            edges_.push_back(edge(parsed));
            return false;
        }
        return true;
    }

private:
    std::vector<VisibilityGraph::Edge>& edges_;
    bool in_edges_ = false;
};

void read_graph(const Json& json, ResultFile& file) {
    for (const Json& p : json.at("vertices")) file.vertices.push_back(point(p));
    for (const auto& [u, v] : file.edges) {
        if (u >= v || v.index() >= file.vertices.size()) {
            throw Malformed(fmt::format("[{}, {}] is no edge", u.value, v.value));
        }
    }
}

void read_path(const Json& json, ResultFile& file) {
    file.from = point(file.options.at("from"));
    file.to = point(file.options.at("to"));
    if (json.value("unreachable", false)) return;
    for (const Json& p : json.at("points")) file.points.push_back(point(p));
    if (file.points.empty()) throw Malformed("the path has no points");
    const Json& length = json.at("length");
    file.length = {rational(length.at("lower")).approx_double(),
                   rational(length.at("upper")).approx_double()};
}

void read_views(const Json& json, ResultFile& file) {
    if (!json.contains("polygons")) {
        file.views.push_back(view(json));
        return;
    }
    for (const Json& one : json.at("polygons")) file.views.push_back(view(one));
}

void read_document(std::istream& in, ResultFile& file) {
    const Json document = Json::parse(in, EdgeCollector(file.edges));
    file.kind = document.at("kind").get<std::string>();
    file.complete = document.value("complete", true);
    file.options = document.at("options");
    if (document.contains("scene")) file.scene_vertices = document["scene"].at("vertices");
    const Json& result = document.at("result");
    if (file.kind == "visibility_graph") read_graph(result, file);
    if (file.kind == "visibility_polygon") read_views(result, file);
    if (file.kind == "shortest_path") read_path(result, file);
    if (file.kind == "visibility_skeleton") file.skeleton = result;
}

/// The parser's own messages begin with a code in brackets.
std::string without_code(const Json::exception& problem) {
    const std::string what = problem.what();
    const std::size_t end = what.find("] ");
    return end == std::string::npos ? what : what.substr(end + 2);
}

tl::unexpected<Error> malformed(const std::string& path, const std::string& what) {
    return fail(Errc::syntax,
                fmt::format("{}: is no result of sightline ({}); write it again", path, what));
}

}  // namespace

bool is_result_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(256, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; });
    return text.starts_with("{\"sightline\":");
}

Result<ResultFile> read_result(const std::string& path) {
    ResultFile file;
    file.path = path;
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return fail(Errc::cannot_open,
                    fmt::format("{}: cannot be read ({}); check the name and the permissions", path,
                                std::strerror(errno)));
    }
    try {
        read_document(in, file);
    } catch (const Json::exception& problem) {
        return malformed(path, without_code(problem));
    } catch (const Malformed& problem) {
        return malformed(path, problem.what());
    }
    return file;
}

void adopt_options(const ResultFile& result, SceneArguments& arguments) {
    const auto says = [&](const char* name) {
        const auto option = result.options.find(name);
        return option != result.options.end() && *option == true;
    };
    arguments.world = arguments.world || says("world");
    arguments.repair = arguments.repair || says("repair");
    arguments.all_lines = arguments.all_lines || says("all_lines");
    arguments.sheets = arguments.sheets || says("sheets");
}

Result<Scene2> scene_of(const ResultFile& result, const Scene2& scene) {
    std::vector<Point2> added;
    try {
        for (const Json& p : result.options.value("add", Json::array())) {
            added.push_back(approx_point(point(p)));
        }
    } catch (const std::exception& problem) {
        return malformed(result.path, problem.what());
    }
    if (result.scene_vertices != scene.vertex_count() + added.size()) {
        return fail(
            Errc::bad_parameter,
            fmt::format("{}: is of a scene with {} vertices, this one has {}; name the "
                        "files that it was made from",
                        result.path, result.scene_vertices, scene.vertex_count() + added.size()));
    }
    if (added.empty()) return scene;
    return scene.with_points(added);
}

}  // namespace sightline::detail
