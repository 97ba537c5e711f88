// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture.hpp"

#include <vector>

#include "cli/scene_loading.hpp"

namespace sightline::detail {
namespace {

/// The places that a picture should show beside the scene.
std::vector<RationalPoint2> places_of(std::span<const ResultFile> results) {
    std::vector<RationalPoint2> places;
    for (const ResultFile& result : results) {
        places.insert(places.end(), result.points.begin(), result.points.end());
        for (const ExactView& view : result.views) {
            places.push_back(view.from);
            for (const ViewPoint& p : view.ring) {
                if (!p.at_infinity) places.push_back(p.coordinates);
            }
        }
    }
    return places;
}

Result<void> add_result(viz::DrawList& list, const Scene2& scene, const ResultFile& result) {
    const Result<Scene2> own = scene_of(result, scene);
    if (!own) return tl::unexpected(own.error());
    if (result.kind == "visibility_graph") {
        viz::add_graph(list, *own, result.edges);
    } else if (result.kind == "visibility_polygon") {
        for (const ExactView& view : result.views) {
            viz::add_view(list, view.from, view.ring, view.needles);
        }
    } else if (result.kind == "shortest_path") {
        if (!result.points.empty()) viz::add_path(list, result.points, result.length);
    } else {
        return fail(Errc::unsupported, result.path + ": nothing of the kind '" + result.kind +
                                           "' can be drawn; name a graph, view or path");
    }
    return {};
}

}  // namespace

Result<viz::DrawList> picture_of(const Scene2& scene, std::span<const ResultFile> results,
                                 viz::DrawOptions options) {
    const std::vector<RationalPoint2> places = places_of(results);
    options.view = viz::window(scene, places);
    viz::DrawList list = viz::draw(scene, options);
    for (const ResultFile& result : results) {
        const Result<void> added = add_result(list, scene, result);
        if (!added) return tl::unexpected(added.error());
    }
    return list;
}

Result<viz::DrawList> load_picture(const PictureArguments& arguments, Session& session) {
    SceneArguments scene = arguments.scene;
    scene.files.clear();
    std::vector<ResultFile> results;
    for (const std::string& file : arguments.scene.files) {
        if (!is_result_file(file)) {
            scene.files.push_back(file);
            continue;
        }
        Result<ResultFile> result = read_result(file);
        if (!result) return tl::unexpected(result.error());
        adopt_options(*result, scene);
        results.push_back(std::move(*result));
    }
    if (scene.files.empty()) {
        return fail(Errc::bad_parameter, "only results are named; name their scene too");
    }
    const Result<LoadedScene> loaded = load_scene(scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    viz::DrawOptions options;
    options.title = arguments.title;
    options.vertices = arguments.vertices;
    options.vertex_labels = arguments.labels;
    return session.timed("build", "drawing",
                         [&] { return picture_of(loaded->scene, results, options); });
}

}  // namespace sightline::detail
