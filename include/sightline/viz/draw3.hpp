// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sightline/scene/scene3.hpp"
#include "sightline/viz/draw_list.hpp"

/// From scenes of space to pictures as plain data.
namespace sightline::viz {

struct DrawOptions3 {
    std::string title{};
    /// From where the picture is looked at.
    Camera camera{};
    /// Whether the feature vertices are marked.
    bool vertices = false;
    /// Whether the feature vertices are named v0, v1…
    bool vertex_labels = false;
    /// Whether the feature edges are named e0, e1… in their middles.
    bool edge_labels = false;
    /// Of the faces of solids; below 1 what is behind them shines through.
    double solid_opacity = 1;
    /// What the picture shows; empty: the scene and the result, with a margin. Lines without bounds
    /// are cut off at it.
    Box view{};
};

/// The faces of solids, shaded, the feature edges, and sheets, through which one sees. O(n).
///
/// Layers: `faces` and `sheets` (triangles; the id is the face), `world` (the faces of the world,
/// hardly visible), `edges` (segment i is edge i), `vertices`. Empty layers are left out.
[[nodiscard]] DrawList draw(const Scene3& scene, const DrawOptions3& options = {});

/// The box round the scene, larger by `margin` times its longest side in each direction.
[[nodiscard]] Box box_around(const Scene3& scene, double margin);

/// What `draw` does, on top of a picture of space.
void add_scene(DrawList& list, const Scene3& scene, const DrawOptions3& options = {});

}  // namespace sightline::viz
