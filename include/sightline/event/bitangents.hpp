// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/event/bitangent.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline {

struct BitangentOptions {
    /// Whether both contacts may be on one body, or both on the world: lines across its bays, and
    /// its edges where they are locally tangent at both ends (semantics 4.3). Vertices of walls and
    /// points belong to no body; each counts by itself, and lines between them are always listed.
    bool one_body = false;
};

/// All bitangents of a scene, free or not, each in both directions; ascending.
///
/// - *Locally tangent* at a contact: a short piece of the line round the place is free. That is
///   judged against all of B ∪ W near the place: where bodies touch, a line that supports one and
///   cuts the other is no bitangent. A wall that leaves the place along the line does not block
///   here.
/// - Contacts are vertices at different places. Vertices at one place have their own bitangents,
///   each with its own side.
/// - Of several contacts on one line, the nearest: no other contact of the two bodies lies between.
///   So edges on one line count once. (A contact of a third body between them changes nothing.)
/// - Two disjoint convex bodies have four lines: one LL, one RR, one LR and one RL in each
///   direction.
///
/// The free ones are free_bitangents() (planar). Cost: O(n log n), then O(1) for each pair of
/// vertices that are not reflex corners, and O(log n) for each result, of which there may be O(n²).
[[nodiscard]] std::vector<Bitangent> bitangents(const Scene2& scene,
                                                const BitangentOptions& options = {});

/// The same under limits: `max_elements` bounds the results, a direction counting as one.
[[nodiscard]] Result<std::vector<Bitangent>> bitangents(const Scene2& scene,
                                                        const BitangentOptions& options,
                                                        const Limits& limits);

/// Those between two bodies of the scene, or of one with itself when a == b. In both directions;
/// ascending. Contract: the bodies exist.
[[nodiscard]] std::vector<Bitangent> bitangents(const Scene2& scene, BodyId a, BodyId b);

/// The lines from a point that are locally tangent to a body, at the nearest contact on each ray;
/// ascending. The point may lie anywhere, and the segment may cross anything. A convex body has
/// two, seen from a point outside of it; one on each side. Vertices at the point itself are no
/// contacts. O(n log n). Contract: the body exists, the point is finite.
[[nodiscard]] std::vector<SupportingLine2> supporting_lines(const Scene2& scene, BodyId body,
                                                            const Point2& point);

}  // namespace sightline
