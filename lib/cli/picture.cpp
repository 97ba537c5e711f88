// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "cli/scene_loading.hpp"
#include "cli/skeleton_file.hpp"

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

Result<void> add_result(viz::DrawList& list, const Scene3& scene, const ResultFile& result,
                        const PictureArguments& arguments) {
    if (result.kind != "visibility_skeleton") {
        return fail(Errc::unsupported, result.path + ": results of the kind '" + result.kind +
                                           "' are not drawn in scenes of space; name a skeleton");
    }
    const Result<VisibilitySkeleton> skeleton = skeleton_of(result.skeleton, scene, result.path);
    if (!skeleton) return tl::unexpected(skeleton.error());
    viz::SkeletonDrawOptions options;
    if (const auto chosen = choose_arcs(arguments.arcs, *skeleton, options); !chosen) {
        return chosen;
    }
    viz::add_skeleton(list, scene, *skeleton, options);
    return {};
}

/// The scene of space that the files are, with everything that the results say.
Result<viz::DrawList> load_space(const SceneArguments& scene, std::span<const ResultFile> results,
                                 const PictureArguments& arguments, Session& session) {
    Result<viz::DrawOptions3> options = options_of(arguments.camera);
    if (!options) return tl::unexpected(options.error());
    options->title = arguments.title;
    options->vertices = arguments.vertices;
    options->vertex_labels = arguments.labels;
    const Result<LoadedScene3> loaded = load_scene3(scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    return session.timed("build", "drawing", [&]() -> Result<viz::DrawList> {
        viz::DrawList list = viz::draw(loaded->scene, *options);
        for (const ResultFile& result : results) {
            const auto added = add_result(list, loaded->scene, result, arguments);
            if (!added) return tl::unexpected(added.error());
        }
        return list;
    });
}

}  // namespace

Result<viz::DrawOptions3> options_of(const CameraArguments& arguments) {
    viz::DrawOptions3 options;
    if (arguments.see_through) options.solid_opacity = 0.3;
    if (arguments.look_from.empty()) return options;
    std::vector<double> numbers;
    std::istringstream in(arguments.look_from);
    for (std::string word; std::getline(in, word, ',');) {
        const std::optional<Rational> number = Rational::parse(word);
        if (!number) break;
        numbers.push_back(number->approx_double());
    }
    const bool is_direction =
        numbers.size() == 3 && std::ranges::any_of(numbers, [](double x) { return x != 0; }) &&
        std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }) &&
        std::ranges::count(arguments.look_from, ',') == 2;
    if (!is_direction) {
        return fail(Errc::bad_parameter,
                    "--look-from: '" + arguments.look_from +
                        "' is no direction; write X,Y,Z from the scene towards the eye, not all "
                        "zero, as in 1,-2,1.5");
    }
    options.camera.from = {numbers[0], numbers[1], numbers[2]};
    return options;
}

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
    if (scene.files.empty() && scene.sheet_files.empty()) {
        return fail(Errc::bad_parameter, "only results are named; name their scene too");
    }
    if (names_meshes(scene)) {
        return load_space(scene, results, arguments, session);
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
