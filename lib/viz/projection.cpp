// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "sightline/scene/result.hpp"
#include "sightline/viz/draw_list.hpp"
#include "viz/vector_math.hpp"

namespace sightline::viz {
namespace {

using detail::cross;
using detail::dot;
using detail::unit;

/// Three unit vectors at right angles: to the right, upwards, towards the eye.
struct Frame {
    explicit Frame(const Camera& camera) : nearer(unit(camera.from)) {
        SIGHTLINE_EXPECT(dot(nearer, nearer) > 0);
        right = cross(unit(camera.up), nearer);
        // Along the direction of looking nothing points upwards: y does then, or else x.
        for (const Position& other : {Position{0, 1, 0}, Position{1, 0, 0}}) {
            if (dot(right, right) > 0) break;
            right = cross(other, nearer);
        }
        right = unit(right);
        up = cross(nearer, right);
    }
    [[nodiscard]] Position operator()(const Position& p) const {
        return {dot(right, p), dot(up, p), dot(nearer, p)};
    }

    Position nearer;
    Position right;
    Position up;
};

Box projected_box(const Box& box, const Frame& frame) {
    Box result;
    for (const double x : {box.low.x, box.high.x}) {
        for (const double y : {box.low.y, box.high.y}) {
            for (const double z : {box.low.z, box.high.z}) result.add(frame({x, y, z}));
        }
    }
    return result;
}

}  // namespace

DrawList projected(const DrawList& list) {
    DrawList result = list;
    if (!list.camera) return result;
    const Frame frame(*list.camera);
    if (!list.view.is_empty()) result.view = window_around(projected_box(list.view, frame));
    const auto move = [&](Position& p) { p = frame(p); };
    for (Layer& layer : result.layers) {
        for (Polygon& polygon : layer.polygons) {
            std::ranges::for_each(polygon.outer, move);
            for (auto& hole : polygon.holes) std::ranges::for_each(hole, move);
        }
        for (Polyline& line : layer.polylines) std::ranges::for_each(line.points, move);
        std::ranges::for_each(layer.segments, move);
        std::ranges::for_each(layer.points, move);
        for (Label& label : layer.labels) move(label.at);
    }
    return result;
}

}  // namespace sightline::viz
