// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "sightline/arith/surd.hpp"
#include "sightline/view/view3.hpp"

/// How a view changes along a segment.
///
/// The view from p(t) = source + t (target - source) is one and the same labelled map between two neighbouring
/// events. An event's parameter is a root of a linear form (the viewpoint crosses the plane of a face, or a plane
/// through a vertex and an edge) or of a quadratic one (three edges meet in one point of the image: the viewpoint
/// crosses their quadric), so it is rational or lies in a quadratic field.
namespace sightline {

/// What makes a view change.
struct ViewEventCause {
    enum class Kind : std::uint8_t {
        face_plane,   ///< the viewpoint is in the plane of `face`
        vertex_edge,  ///< `vertex` and a point of edges[0] are on one line of sight
        three_edges   ///< points of all `edges` are on one line of sight
    };
    Kind kind = Kind::face_plane;
    FaceId face;
    VertexId vertex;
    std::array<EdgeId, 3> edges;  ///< ascending; none() where there are fewer

    friend auto operator<=>(const ViewEventCause&, const ViewEventCause&) = default;
    friend std::ostream& operator<<(std::ostream& out, const ViewEventCause& cause);
};

struct ViewEvent {
    Surd at;
    /// Everything that happens on visible lines of sight, or may, at this place; sorted.
    std::vector<ViewEventCause> causes;
    /// The view differs at the event only: it is the same before and behind.
    bool only_there = false;

    friend bool operator==(const ViewEvent&, const ViewEvent&) = default;
};

struct ViewChange3 {
    RationalPoint3 source;
    RationalPoint3 target;
    std::vector<ViewEvent> events;  ///< in the order of their parameters, all between 0 and 1
    /// views[i] is the view from some point between events i - 1 and i.
    std::vector<View3> views;
};

/// The views from the inside of a segment, and where they change. Fails with inside_body (outside_of_world) when the
/// segment runs through a body, with limit_reached when there are more candidates than limits.max_elements, with
/// bad_parameter when source == target, and with cancelled when `stop` says so.
///
/// Rules
///  (1) An event is a place before and behind which views differ; or at which the view differs from those, where
///      the parameter is rational.
///  (2) The ends of the segment are no events.
///
/// Cost: O(E³) quadratic forms for E edges, and a view for each candidate whose lines of sight meet the edges.
[[nodiscard]] Result<ViewChange3> view_change(const PointVisibility3& visibility,
                                              const RationalPoint3& source,
                                              const RationalPoint3& target,
                                              const Limits& limits = {});

}  // namespace sightline
