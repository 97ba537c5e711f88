// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline {

/// Which arcs are wanted. Default: all. Several restrictions hold together.
struct SkeletonPart {
    /// Arcs that end at both faces.
    std::optional<std::array<FaceId, 2>> between;
    /// Arcs with this edge in their support.
    std::optional<EdgeId> edge;
};

struct SkeletonOptions {
    /// `interval` and `double_` may miss or invent nodes; they exist to be measured.
    Arithmetic arithmetic = Arithmetic::filtered;
    /// Counts which tier decided; may be null.
    Tally* tally = nullptr;
    /// Threads to use; 0 takes what the machine has. The result does not depend on it.
    unsigned threads = 1;
    /// Only these arcs and the nodes at their ends.
    SkeletonPart part{};
};

/// The visibility skeleton of a scene.
///
/// Every vertex is joined with every edge that it may see: the lines through both are a pencil, along which
/// the free segments through both are followed from event to event. At every node so found, all swaths
/// of three edges that may leave it are followed in turn, until nothing new is found
/// (docs/decisions/0007-skeleton-from-pencils.md says why that finds all).
///
/// A part costs what its surroundings do: the arcs of an edge, one family of pencils and the swaths over that edge;
/// those between two faces, the swaths over the edges in the shaft between them.
[[nodiscard]] VisibilitySkeleton visibility_skeleton(const Scene3& scene,
                                                     const SkeletonOptions& options = {});

/// The same, with limits on nodes and arcs together, a question whether to stop, and progress.
[[nodiscard]] Result<VisibilitySkeleton> visibility_skeleton(const Scene3& scene,
                                                             const SkeletonOptions& options,
                                                             const Limits& limits);

}  // namespace sightline
