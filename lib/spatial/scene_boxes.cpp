// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/scene_boxes.hpp"

namespace sightline {

std::vector<Box3> triangle_boxes(const Scene3& scene) {
    std::vector<Box3> boxes;
    boxes.reserve(scene.triangles().size());
    for (const Triangle3& t : scene.triangles()) {
        boxes.push_back(Box3::of(scene[t.corners[0]], scene[t.corners[1]], scene[t.corners[2]]));
    }
    return boxes;
}

std::vector<Box3> edge_boxes(const Scene3& scene) {
    std::vector<Box3> boxes;
    boxes.reserve(scene.edges().size());
    for (const Edge3& e : scene.edges())
        boxes.push_back(Box3::of(scene[e.source], scene[e.target]));
    return boxes;
}

std::vector<Box3> face_boxes(const Scene3& scene) {
    std::vector<Box3> boxes(scene.faces().size());
    // The triangles, not the rings: they cover the face, whichever vertices its rings mention.
    for (const Triangle3& t : scene.triangles()) {
        for (const VertexId v : t.corners) boxes[t.face.index()].include(scene[v]);
    }
    return boxes;
}

}  // namespace sightline
