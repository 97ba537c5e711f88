// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>

#include "cli/comparison.hpp"
#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/program.hpp"
#include "cli/result_file.hpp"
#include "cli/skeleton_file.hpp"
#include "sightline/planar/shortest_path.hpp"
#include "sightline/reference/free_segment.hpp"
#include "sightline/reference/shortest_path.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "sightline/reference/visibility_polygon.hpp"
#include "sightline/reference/visibility_skeleton.hpp"

namespace sightline::detail {
namespace {

using Json = nlohmann::ordered_json;

struct CheckArguments {
    std::string result;
    SceneArguments scene;
    OutputArguments outputs;
    std::size_t sample = 0;
};

/// What was found, for the document and in one line.
struct Finding {
    bool is_equal = true;
    Json details = Json::object();
    std::string line;
};

/// Without --sample, small results are compared whole.
std::size_t sample_size(const CheckArguments& arguments, std::size_t n) {
    constexpr std::size_t small = 1000;
    constexpr std::size_t sampled = 100;
    if (arguments.sample > 0) return std::min(n, arguments.sample);
    return n <= small ? n : sampled;
}

/// Calls work(i) for i < n on the session's threads.
template <typename Work>
void for_each_index(std::size_t n, Session& session, const Work& work) {
    const unsigned threads = session.common().threads;
    tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
    std::atomic<std::size_t> finished{0};
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) {
            work(i);
            session.progress().update(static_cast<double>(++finished) / static_cast<double>(n));
        });
    });
}

Json some_edges(const std::vector<VisibilityGraph::Edge>& edges) {
    Json list = Json::array();
    for (const auto& [u, v] : edges) list.push_back({u.value, v.value});
    return list;
}

VisibilityGraphOptions graph_options(const ResultFile& result) {
    VisibilityGraphOptions options;
    if (result.options.value("collinear", "nearest") == "all") {
        options.collinear = Collinear::every_vertex;
    }
    options.tangent_only = result.options.value("tangent", false);
    return options;
}

Result<void> has_vertices_of(const ResultFile& result, const Scene2& scene) {
    for (std::size_t i = 0; i < scene.vertex_count(); ++i) {
        if (i < result.vertices.size() && result.vertices[i] == to_rational(scene.vertices()[i])) {
            continue;
        }
        return fail(Errc::bad_parameter,
                    fmt::format("{}: vertex {} is not that of the scene; name the files that it "
                                "was made from",
                                result.path, i));
    }
    return {};
}

Result<Finding> check_graph(const CheckArguments& arguments, const ResultFile& result,
                            const Scene2& scene, Session& session) {
    if (const auto same = has_vertices_of(result, scene); !same) {
        return tl::unexpected(same.error());
    }
    const VisibilityGraphOptions options = graph_options(result);
    const VisibilityGraph graph = VisibilityGraph::from_edges(scene.vertex_count(), result.edges);
    const auto rows =
        sampled_vertices(scene.vertex_count(), sample_size(arguments, scene.vertex_count()));
    std::vector<std::vector<VertexId>> right(rows.size());
    for_each_index(rows.size(), session, [&](std::size_t i) {
        right[i] = reference::visible_from(scene, rows[i], options);
    });
    GraphComparison found;
    for (std::size_t i = 0; i < rows.size(); ++i) compare_row(graph, rows[i], right[i], found);
    Finding finding;
    finding.is_equal = found.is_equal();
    finding.details["rows"] = found.rows;
    finding.details["edges"] = found.edges;
    finding.details["false"] = found.false_count;
    finding.details["missed"] = found.missed_count;
    finding.details["false_edges"] = some_edges(found.false_some);
    finding.details["missed_edges"] = some_edges(found.missed_some);
    finding.line =
        fmt::format("{} of {} rows with {} edges: {} false, {} missed", found.rows,
                    scene.vertex_count(), found.edges, found.false_count, found.missed_count);
    return finding;
}

/// Whether the view is the reference's, as far as the result says anything.
Result<bool> is_right(const ResultFile& result, const ExactView& view, const Scene2& scene) {
    VisibilityPolygonOptions options;
    const bool with_needles = result.options.value("with_needles", false);
    if (with_needles) options.needles = Needles::with_needles;
    const auto right = reference::visibility_polygon(scene, view.from, options);
    if (!right) return tl::unexpected(right.error());
    std::vector<reference::SeenSegment> needles;
    needles.reserve(view.needles.size());
    for (const auto& [near, far] : view.needles) needles.push_back({near, far});
    std::sort(needles.begin(), needles.end());
    return view.ring == right->ring && (!with_needles || needles == right->needles);
}

Result<Finding> check_views(const CheckArguments& arguments, const ResultFile& result,
                            const Scene2& scene, Session& session) {
    if (result.options.contains("clip")) {
        return fail(Errc::unsupported,
                    result.path + ": is clipped to a box; check the view without --clip");
    }
    const auto chosen =
        sampled_vertices(result.views.size(), sample_size(arguments, result.views.size()));
    std::vector<Result<bool>> right(chosen.size());
    for_each_index(chosen.size(), session, [&](std::size_t i) {
        right[i] = is_right(result, result.views[chosen[i].index()], scene);
    });
    Finding finding;
    Json wrong = Json::array();
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (!right[i]) return tl::unexpected(right[i].error());
        if (!*right[i]) wrong.push_back(chosen[i].value);
    }
    finding.is_equal = wrong.empty();
    finding.line =
        fmt::format("{} of {} views: {} differ", chosen.size(), result.views.size(), wrong.size());
    finding.details["views"] = chosen.size();
    finding.details["different"] = wrong;
    return finding;
}

/// The reference looks at all triples of vertices: beyond a few hundred, the fast algorithm in exact
/// numbers has to do.
Result<ShortestPath> right_path(const ResultFile& result, const Scene2& scene) {
    constexpr std::size_t small = 200;
    if (scene.vertex_count() <= small) {
        return reference::shortest_path(scene, result.from, result.to);
    }
    ShortestPathOptions options;
    options.arithmetic = Arithmetic::exact;
    return shortest_path(scene, result.from, result.to, options);
}

Result<Finding> check_path(const ResultFile& result, const Scene2& scene) {
    const Result<ShortestPath> right = right_path(result, scene);
    if (!right && right.error().code != Errc::unreachable) return tl::unexpected(right.error());
    std::size_t blocked = 0;
    for (std::size_t i = 0; i + 1 < result.points.size(); ++i) {
        if (!reference::is_free(scene, result.points[i], result.points[i + 1])) ++blocked;
    }
    const bool same = right ? result.points == right->points : result.points.empty();
    Finding finding;
    finding.is_equal = same && blocked == 0;
    finding.details["legs"] = result.points.empty() ? 0 : result.points.size() - 1;
    finding.details["blocked_legs"] = blocked;
    finding.details["is_shortest"] = same;
    finding.line = fmt::format("path with {} points: {} legs blocked, {}", result.points.size(),
                               blocked, same ? "the shortest" : "not the shortest");
    return finding;
}

/// A skeleton's arcs by what they say, their nodes included.
std::vector<std::pair<SkeletonArc, std::array<SkeletonNode, 2>>> named_arcs(
    const VisibilitySkeleton& skeleton) {
    std::vector<std::pair<SkeletonArc, std::array<SkeletonNode, 2>>> arcs;
    for (SkeletonArc arc : skeleton.arcs()) {
        std::array nodes{skeleton[arc.nodes[0]], skeleton[arc.nodes[1]]};
        std::ranges::sort(nodes);
        arc.nodes = {};
        arcs.emplace_back(std::move(arc), std::move(nodes));
    }
    std::ranges::sort(arcs);
    return arcs;
}

/// How many of the sorted `some` are not among the sorted `others`.
template <typename Sorted>
std::size_t extra(const Sorted& some, const Sorted& others) {
    return static_cast<std::size_t>(std::ranges::count_if(
        some, [&](const auto& x) { return !std::ranges::binary_search(others, x); }));
}

Result<Finding> check_skeleton_file(const ResultFile& result, const Scene3& scene) {
    if (result.options.contains("pair") || result.options.contains("arcs_only")) {
        return fail(Errc::unsupported,
                    result.path +
                        ": is a part of a skeleton; check the whole one, without --pair "
                        "and --arcs-only");
    }
    const Result<VisibilitySkeleton> skeleton = skeleton_of(result.skeleton, scene, result.path);
    if (!skeleton) return tl::unexpected(skeleton.error());
    const VisibilitySkeleton right = reference::visibility_skeleton(scene);
    const auto arcs = named_arcs(*skeleton);
    const auto right_arcs = named_arcs(right);
    const std::size_t false_nodes = extra(skeleton->nodes(), right.nodes());
    const std::size_t missed_nodes = extra(right.nodes(), skeleton->nodes());
    const std::size_t false_arcs = extra(arcs, right_arcs);
    const std::size_t missed_arcs = extra(right_arcs, arcs);
    Finding finding;
    finding.is_equal = *skeleton == right;
    finding.details["nodes"] = right.nodes().size();
    finding.details["arcs"] = right.arcs().size();
    finding.details["false_nodes"] = false_nodes;
    finding.details["missed_nodes"] = missed_nodes;
    finding.details["false_arcs"] = false_arcs;
    finding.details["missed_arcs"] = missed_arcs;
    finding.line = fmt::format("{} nodes: {} false, {} missed; {} arcs: {} false, {} missed",
                               right.nodes().size(), false_nodes, missed_nodes, right.arcs().size(),
                               false_arcs, missed_arcs);
    return finding;
}

Result<Finding> check_result(const CheckArguments& arguments, const ResultFile& result,
                             const Scene2& scene, Session& session) {
    if (result.kind == "visibility_graph") return check_graph(arguments, result, scene, session);
    if (result.kind == "visibility_polygon") return check_views(arguments, result, scene, session);
    if (result.kind == "shortest_path") return check_path(result, scene);
    return fail(Errc::unsupported, result.path + ": there is no reference for the kind '" +
                                       result.kind + "'; name a graph, view, path or skeleton");
}

Result<void> write_finding(const CheckArguments& arguments, const LoadedScene* plane,
                           const LoadedScene3* space, const Finding& finding, Session& session) {
    if (arguments.outputs.json.empty()) {
        std::cout << arguments.result << ": " << finding.line << '\n' << std::flush;
        return {};
    }
    Document document;
    document.kind = "check";
    document.scene = plane;
    document.scene3 = space;
    document.options["result"] = arguments.result;
    document.result = [&](JsonWriter& json) {
        json.begin_object();
        json.member("equal", finding.is_equal);
        for (const auto& item : finding.details.items()) {
            json.key(item.key());
            json.tree(item.value());
        }
        json.end();
    };
    return write_outputs(arguments.outputs, document, session);
}

Result<ExitStatus> check_in_space(const CheckArguments& arguments, const ResultFile& result,
                                  const SceneArguments& files, Session& session) {
    const Result<LoadedScene3> loaded = load_scene3(files, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const Result<Finding> finding = session.timed("build", "comparing with the reference", [&] {
        return check_skeleton_file(result, loaded->scene);
    });
    if (!finding) return tl::unexpected(finding.error());
    const auto told = write_finding(arguments, nullptr, &*loaded, *finding, session);
    if (!told) return tl::unexpected(told.error());
    return finding->is_equal ? ExitStatus::done : ExitStatus::no_answer;
}

Result<ExitStatus> run_check(const CheckArguments& arguments, Session& session) {
    SceneArguments files = arguments.scene;
    if (!arguments.outputs.json.empty()) {
        files.files.push_back(arguments.result);
        if (const auto checked = check_outputs(arguments.outputs, files); !checked) {
            return tl::unexpected(checked.error());
        }
        files.files.pop_back();
    }
    const Result<ResultFile> result = read_result(arguments.result);
    if (!result) return tl::unexpected(result.error());
    adopt_options(*result, files);
    if (result->kind == "visibility_skeleton")
        return check_in_space(arguments, *result, files, session);
    Result<LoadedScene> loaded = load_scene(files, session);
    if (!loaded) return tl::unexpected(loaded.error());
    Result<Scene2> scene = scene_of(*result, loaded->scene);
    if (!scene) return tl::unexpected(scene.error());
    loaded->scene = std::move(*scene);
    const Result<Finding> finding = session.timed("build", "comparing with the reference", [&] {
        return check_result(arguments, *result, loaded->scene, session);
    });
    if (!finding) return tl::unexpected(finding.error());
    if (const auto told = write_finding(arguments, &*loaded, nullptr, *finding, session); !told) {
        return tl::unexpected(told.error());
    }
    return finding->is_equal ? ExitStatus::done : ExitStatus::no_answer;
}

}  // namespace

void add_check(Program& program) {
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App& app =
        program.add("check", "compare a result with the reference algorithm",
                    "sightline check graph.json map.wkt --sample 50",
                    [arguments](Session& session) { return run_check(*arguments, session); });
    app.add_option("RESULT", arguments->result, "a graph, view, path or skeleton as JSON")
        ->required()
        ->type_name("");
    add_scene_arguments(app, arguments->scene);
    add_sheet_arguments(app, arguments->scene);
    app.add_option("--sample", arguments->sample,
                   "compare so many rows or views, evenly chosen; by default all up to 1000, else "
                   "100")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    app.add_option("-o,--output", arguments->outputs.json,
                   "JSON; without it one line on standard output")
        ->type_name("FILE")
        ->group("Output");
}

}  // namespace sightline::detail
