// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/event/bitangent.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline {

struct FreeBitangentOptions {
    /// Whether both contacts may be on one body, or both on the world: its edges where they are
    /// locally tangent, and lines across its bays. With them these are the vertices of the
    /// visibility complex (semantics 4.3); without, what joins different bodies, walls and points.
    bool one_body = true;
    /// No effect on the result unless `interval` or `double_`, which may miss or invent bitangents;
    /// the sides are exact always.
    Arithmetic arithmetic = Arithmetic::filtered;
    /// No effect on the result. 0: one a core.
    unsigned threads = 1;
    /// When set, the counts of the tangent graph are added to it.
    Tally* tally = nullptr;
};

/// The free bitangents of a scene: the edges of its tangent graph (semantics 4.1) with the side of
/// what is touched at each end. Each in both directions, ascending: source by source, target by
/// target.
///
/// - Free: the open segment is free and contains no scene vertex; locally tangent at both ends,
///   judged against B ∪ W near the place. Vertices at one place have their own bitangents.
/// - Bitangents (event) that are free; those of `bitangents(scene, {.one_body = true})` whose
///   segment is free and contains no scene vertex.
/// - A body edge is one of them when it is locally tangent at both ends: convex at both.
///
/// Cost: the tangent graph, and 4 orientations for each of its edges. 20 bytes a direction.
[[nodiscard]] std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                                         const FreeBitangentOptions& options = {});

/// The same under limits: `max_elements` bounds the edges of the tangent graph.
[[nodiscard]] Result<std::vector<FreeBitangent>> free_bitangents(
    const Scene2& scene, const FreeBitangentOptions& options, const Limits& limits);

/// The same from the scene's tangent graph, when it is at hand. The caller vouches for that:
/// visibility_graph(scene, {.tangent_only = true}).
[[nodiscard]] std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                                         const VisibilityGraph& tangent_graph,
                                                         const FreeBitangentOptions& options = {});

}  // namespace sightline
