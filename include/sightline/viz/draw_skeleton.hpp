// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "sightline/geom/plucker.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"
#include "sightline/viz/draw3.hpp"

/// From critical lines, swaths and visibility skeletons to pictures as plain data. Everything here is
/// rounded.
namespace sightline::viz {

struct SkeletonDrawOptions {
    DrawOptions3 scene{};
    /// Which arcs are drawn; empty: all.
    std::optional<std::vector<ArcId>> arcs{};
    /// Which nodes are drawn; empty: all, or with `arcs` given the nodes at their ends.
    std::optional<std::vector<NodeId>> nodes{};
    /// Of an arc, so many lines are drawn as a surface; at least 3.
    unsigned lines_per_arc = 33;
    /// How far beyond the scene, in parts of its longest side, lines without an end are drawn.
    double margin = 0.3;
};

/// Colours of the kinds of arcs and nodes.
[[nodiscard]] Colour colour_of(ArcType type) noexcept;
[[nodiscard]] Colour colour_of(NodeType type) noexcept;

/// The scene with its visibility skeleton: arcs as translucent surfaces, nodes as lines, coloured by
/// type. Lines without an end are cut off near the scene.
///
/// Layers: those of the scene; for each type of arc that there is `arcs EV` (triangles; the id is the
/// arc) and `outlines EV`; for each type of node `nodes VV` (the id of a polyline is the node).
/// Cost: lines_per_arc exact evaluations an arc.
[[nodiscard]] DrawList draw(const Scene3& scene, const VisibilitySkeleton& skeleton,
                            const SkeletonDrawOptions& options = {});

/// What `draw` does, on top of a picture of space.
void add_skeleton(DrawList& list, const Scene3& scene, const VisibilitySkeleton& skeleton,
                  const SkeletonDrawOptions& options = {});

/// A piece of a line, from one end to the other.
struct LinePiece {
    Position from{};
    Position to{};

    friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

/// The piece of a line with this label: between the planes of the faces at its ends, or, without those,
/// cut off at the box. Empty when nothing of it is in the box, or the ends are nowhere on it.
[[nodiscard]] std::optional<LinePiece> approx_piece(const SurdLine3& line,
                                                    const SegmentLabel& label, const Scene3& scene,
                                                    const Box& box);

/// Lines of one family, one after the other, all the same way round.
struct RuledSurface {
    std::vector<LinePiece> lines{};
    /// Where all of them meet, when they do in a finite point.
    std::optional<Position> centre{};
};

/// Lines of an arc, from one node's to the other's, as pieces with the arc's label. Empty when nothing of them
/// is in the box.
[[nodiscard]] RuledSurface approx_surface(const VisibilitySkeleton& skeleton, ArcId arc,
                                          const Scene3& scene, unsigned count, const Box& box);

/// Adds the surface between consecutive lines as triangles with that id.
void add_surface(Layer& layer, const RuledSurface& surface, std::uint32_t id);
/// Adds the border of that surface as a closed chain.
void add_outline(Layer& layer, const RuledSurface& surface, std::uint32_t id);

}  // namespace sightline::viz
