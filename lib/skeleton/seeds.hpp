// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which edges a vertex may see: what is left after tests that are cheap and never wrong. Private.

#include <vector>

#include "spatial/exact_line.hpp"
#include "spatial/scene_forms.hpp"

namespace sightline::detail {

class VertexSight {
public:
    VertexSight(const SceneForms& forms, const Policy& policy);

    /// The edges that are not surely hidden from v along their whole length, ascending. Those whose line
    /// passes through v may be among them.
    [[nodiscard]] const std::vector<EdgeId>& edges_from(VertexId v);

private:
    /// A convex face whose interior the segment from the viewpoint to w surely crosses; none when unknown.
    [[nodiscard]] FaceId hiding_face(VertexId w);
    [[nodiscard]] bool surely_crosses(std::uint32_t triangle, const PluckerOf<Real>& line,
                                      VertexId w) const;
    [[nodiscard]] bool surely_hides(FaceId f, VertexId w) const;
    [[nodiscard]] bool is_turned_away(EdgeId e) const;
    [[nodiscard]] bool leaves_into_own_body(EdgeId e) const;
    [[nodiscard]] Sign height(VertexId w, FaceId f) const;
    void find_convex_faces();

    const SceneForms& forms_;
    const Policy& policy_;
    VertexId v_;
    std::vector<Sign> side_of_face_;  ///< of the viewpoint to each face's plane
    std::vector<FaceId> hidden_by_;   ///< of each vertex
    std::vector<bool> is_asked_;
    std::vector<bool> is_convex_;
    std::vector<std::vector<std::uint32_t>> triangles_of_;
    std::vector<EdgeId> edges_;
    FaceId last_;
};

}  // namespace sightline::detail
