// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sightline/planar/shortest_path.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/scene/scene2.hpp"
#include "sightline/viz/draw_list.hpp"

/// From scenes and results to pictures as plain data. `draw` makes a whole picture, `add_…` adds to
/// one; what is added to finds its place between the layers that are there.
namespace sightline::viz {

struct DrawOptions {
    std::string title{};
    /// Whether scene vertices are marked; points of the scene always are.
    bool vertices = false;
    /// Whether vertices are named v0, v1…
    bool vertex_labels = false;
    /// What the picture shows; empty: the scene and the result, with a margin. Things without
    /// bounds (the outside of a world, what a point sees of infinity) are cut off at it.
    Box view{};
};

/// Order of the layers that the builders make; layers of callers may stand between them.
struct PaintOrder {
    static constexpr int outside = 0;
    static constexpr int bodies = 10;
    static constexpr int views = 20;
    static constexpr int graphs = 30;
    static constexpr int walls = 40;
    static constexpr int vertices = 50;
    static constexpr int paths = 60;
    static constexpr int marks = 70;
};

/// Bodies, walls, points, and with a world everything outside of it as solid. O(n).
[[nodiscard]] DrawList draw(const Scene2& scene, const DrawOptions& options = {});

/// The scene with a visibility graph on its vertices. The more edges, the thinner and paler they
/// are.
[[nodiscard]] DrawList draw(const Scene2& scene, const VisibilityGraph& graph,
                            const DrawOptions& options = {});

/// The scene with what a point of it sees.
[[nodiscard]] DrawList draw(const Scene2& scene, const VisibilityPolygon& polygon,
                            const DrawOptions& options = {});

/// The scene with a shortest path.
[[nodiscard]] DrawList draw(const Scene2& scene, const ShortestPath& path,
                            const DrawOptions& options = {});

/// The window that shows the whole scene and, besides, the given places.
[[nodiscard]] Box window(const Scene2& scene, std::span<const RationalPoint2> places = {});

/// What `draw` does, on top of a picture that has its view already.
void add_scene(DrawList& list, const Scene2& scene, const DrawOptions& options = {});

/// Adds the edges as segments; edge i is `graph.edges()[i]`. The graph's first vertices are the
/// scene's.
void add_graph(DrawList& list, const Scene2& scene, const VisibilityGraph& graph);

/// Edges read from a file, between the scene's vertices.
void add_graph(DrawList& list, const Scene2& scene, std::span<const VisibilityGraph::Edge> edges);

/// Adds the area that `polygon.from` sees, cut off at the picture's view, its needles and the
/// viewpoint.
void add_view(DrawList& list, const Scene2& scene, const VisibilityPolygon& polygon);

/// A needle's two ends.
using NeedlePoints = std::pair<ViewPoint, ViewPoint>;

/// The same from exact coordinates, as a result file has them.
void add_view(DrawList& list, const RationalPoint2& from, std::span<const ViewPoint> ring,
              std::span<const NeedlePoints> needles = {});

/// Adds a path with its ends and turns marked, and its length (to six digits) in the legend.
void add_path(DrawList& list, std::span<const RationalPoint2> points, const Interval& length);

}  // namespace sightline::viz
