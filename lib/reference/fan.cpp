// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace sightline::reference {
namespace {

// Few parts for few edges: then all lines have all candidates.
std::size_t part_count(const Scene2& scene) { return scene.edge_count() < 64 ? 1 : 2048; }

double distance(const Point2& a, const Point2& b) {
    return std::max(std::abs(0.25 * a.x - 0.25 * b.x), std::abs(0.25 * a.y - 0.25 * b.y));
}

}  // namespace

Fan::Fan(const Scene2& scene, VertexId apex)
    : apex_(scene[apex]), all_(scene), parts_(part_count(scene)) {
    // Near edges first: most lines are blocked by one of them.
    std::vector<std::pair<double, EdgeId>> by_distance;
    for (std::uint32_t i = 0; i < scene.edge_count(); ++i) {
        const Edge2& e = scene[EdgeId{i}];
        by_distance.emplace_back(
            std::min(distance(apex_, scene[e.source]), distance(apex_, scene[e.target])),
            EdgeId{i});
    }
    std::sort(by_distance.begin(), by_distance.end());
    for (const auto& [_, e] : by_distance) deal(e, scene[scene[e].source], scene[scene[e].target]);
    for (const VertexId v : scene.points()) deal(v, scene[v]);
}

// NaN when the differences overflow or the point is the apex. The differences of doubles carry a
// relative error of 2^-53 each, so that the angle is right to a few 1e-16, far less than the width
// of a part.
double Fan::angle_of(const Point2& p) const {
    const double dx = p.x - apex_.x;
    const double dy = p.y - apex_.y;
    if (!std::isfinite(dx) || !std::isfinite(dy) || (dx == 0 && dy == 0)) return std::nan("");
    return std::atan2(dy, dx);
}

std::size_t Fan::part_of(double angle) const {
    const double turn = (angle + std::numbers::pi) / (2 * std::numbers::pi);
    const auto part = static_cast<std::size_t>(turn * static_cast<double>(parts_.size()));
    return std::min(part, parts_.size() - 1);
}

void Fan::deal(EdgeId edge, const Point2& a, const Point2& b) {
    const double angle_a = angle_of(a);
    const double angle_b = angle_of(b);
    std::size_t first = 0;
    std::size_t count = parts_.size();
    // An edge seen under nearly a half-turn or more may pass the apex on either side: it goes
    // everywhere.
    double span = std::abs(angle_a - angle_b);
    const bool wraps = span > std::numbers::pi;
    if (wraps) span = 2 * std::numbers::pi - span;
    if (span < 3) {  // false for NaN
        const std::size_t low =
            part_of(wraps ? std::max(angle_a, angle_b) : std::min(angle_a, angle_b));
        const std::size_t high =
            part_of(wraps ? std::min(angle_a, angle_b) : std::max(angle_a, angle_b));
        first = low + parts_.size() - 1;
        count = (high + parts_.size() - low) % parts_.size() + 3;
    }
    for (std::size_t i = 0; i < std::min(count, parts_.size()); ++i) {
        parts_[(first + i) % parts_.size()].edges.push_back(edge);
    }
}

void Fan::deal(VertexId point, const Point2& p) {
    const double angle = angle_of(p);
    const bool anywhere = std::isnan(angle) || parts_.size() < 4;
    const std::size_t first = anywhere ? 0 : part_of(angle) + parts_.size() - 1;
    const std::size_t count = anywhere ? parts_.size() : 3;
    for (std::size_t i = 0; i < count; ++i) {
        parts_[(first + i) % parts_.size()].points.push_back(point);
    }
}

Candidates Fan::towards(const Point2& w) const {
    const double angle = angle_of(w);
    if (std::isnan(angle)) return all_.candidates();
    const Part& part = parts_[part_of(angle)];
    return {part.edges, part.points};
}

}  // namespace sightline::reference
