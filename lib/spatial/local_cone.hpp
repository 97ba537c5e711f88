// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// On which side of a body's surface a line runs just before and just after it touches a feature.
/// Private.

#include "spatial/exact_line.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

/// Where a line runs near a point of a body, in one direction. For sheets, `in` is behind the
/// sheet's back and `out` before its front, locally; at a border there are no sides: `open`.
struct LocalState {
    enum class Where : std::uint8_t { out, in, on, open };

    Where where = Where::out;
    /// When on: the face, or the two faces at the edge, along which the line runs.
    std::array<FaceId, 2> faces = {FaceId::none(), FaceId::none()};
    EdgeShape shape = EdgeShape::convex;  ///< of that edge
};

/// Forwards along the line, or backwards.
enum class Heading : std::int8_t { backward = -1, forward = 1 };

/// At a point inside face f, in whose plane the line does not lie.
[[nodiscard]] LocalState state_at(const SceneForms& forms, const Line& line, FaceId f,
                                  Heading heading);
/// At a point inside edge e, along which the line does not run.
[[nodiscard]] LocalState state_at(const SceneForms& forms, const Line& line, EdgeId e,
                                  Heading heading);
/// At vertex v.
[[nodiscard]] LocalState state_at(const SceneForms& forms, const Line& line, VertexId v,
                                  Heading heading);

/// Whether the bodies along which a line runs leave no free direction round it: their sections across
/// the line cover the whole turn (semantics 2.4, contact of codimension one is sealed).
/// The line is rational.
[[nodiscard]] bool is_sealed(const SceneForms& forms, const Line& line,
                             const std::vector<LocalState>& along);

}  // namespace sightline::detail
