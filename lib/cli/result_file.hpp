// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/arguments.hpp"
#include "sightline/arith/interval.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {

/// A view as a result file has it.
struct ExactView {
    RationalPoint2 from;
    std::vector<ViewPoint> ring;
    std::vector<std::pair<ViewPoint, ViewPoint>> needles;
};

/// A file that the program wrote, with only those parts of its result that its kind has.
struct ResultFile {
    std::string path;
    std::string kind;
    bool complete = true;
    std::size_t scene_vertices = 0;
    nlohmann::json options;

    std::vector<RationalPoint2> vertices;      ///< visibility_graph
    std::vector<VisibilityGraph::Edge> edges;  ///< visibility_graph
    std::vector<ExactView> views;              ///< visibility_polygon
    std::vector<RationalPoint2> points;        ///< shortest_path; none: unreachable
    Interval length;                           ///< shortest_path
    RationalPoint2 from;                       ///< shortest_path
    RationalPoint2 to;                         ///< shortest_path
    nlohmann::json skeleton;                   ///< visibility_skeleton: its result, unread
};

/// Whether the file begins like one of ours; scenes in GeoJSON don't.
[[nodiscard]] bool is_result_file(const std::string& path);

/// Fails with cannot_open, or with syntax when the file is not as the program writes it.
[[nodiscard]] Result<ResultFile> read_result(const std::string& path);

/// How the scene of the result was read: what its options say is added to `arguments`.
void adopt_options(const ResultFile& result, SceneArguments& arguments);

/// The scene with the points that were added for the result (`graph --add`). Fails with
/// bad_parameter when the result cannot be one of this scene.
[[nodiscard]] Result<Scene2> scene_of(const ResultFile& result, const Scene2& scene);

}  // namespace sightline::detail
