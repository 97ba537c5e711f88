// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// From half-edges to features: coplanar faces merged, edges merged along lines. Private.

#include "scene/mesh3.hpp"

namespace sightline::detail {

/// The features of a mesh, as Scene3 holds them.
struct Features3 {
    std::vector<Edge3> edges;
    std::vector<Face3> faces;
    std::vector<FaceId> face_of_input;  ///< an input face
};

/// Turns faces of sheets that are merged with a face of lower number so that they look the same way.
/// Fills in the pairs again when it had to turn some.
[[nodiscard]] Result<void> orient_sheets(Mesh3& mesh);

/// `body_of_component`: the body that each component belongs to.
[[nodiscard]] Result<Features3> find_features(const Mesh3& mesh,
                                              const std::vector<BodyId>& body_of_component);

/// The triangles of a face with no other corners than its ring vertices; empty when its rings cross.
[[nodiscard]] std::vector<std::array<VertexId, 3>> triangulate(const std::vector<Point3>& vertices,
                                                               const Face3& face);

}  // namespace sightline::detail
