// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "sightline/event/critical_line.hpp"
#include "sightline/viz/draw_skeleton.hpp"
#include "viz/vector_math.hpp"

namespace sightline::viz {
namespace {

using detail::cross;
using detail::dot;
using detail::operator+;
using detail::operator-;
using detail::operator*;

constexpr double infinity = std::numeric_limits<double>::infinity();

Position position(const Point3& p) { return {p.x, p.y, p.z}; }

/// A line by a point and a direction of length 1; t is the distance from the point.
struct RoundedLine {
    explicit RoundedLine(const SurdLine3& line) {
        const auto rounded = [](const SurdVector3& v) {
            return Position{v.x.approx_double(), v.y.approx_double(), v.z.approx_double()};
        };
        const Position d = rounded(line.d);
        const double length = std::sqrt(dot(d, d));
        direction = (1 / length) * d;
        foot = cross(direction, (1 / length) * rounded(line.m));
    }
    [[nodiscard]] Position at(double t) const { return foot + t * direction; }
    [[nodiscard]] double nearest(const Position& p) const { return dot(direction, p - foot); }

    Position foot{};
    Position direction{};
};

/// Where it comes nearest to the line through a and b.
double nearest(const RoundedLine& line, const Position& a, const Position& b) {
    const Position u = b - a;
    const Position normal = cross(u, cross(line.direction, u));
    const double speed = dot(normal, line.direction);
    return dot(normal, a - line.foot) / speed;
}

/// Places of the features on the line: the least and the greatest.
std::pair<double, double> extent_of(const RoundedLine& line, const Support& support,
                                    const Scene3& scene) {
    double low = infinity;
    double high = -infinity;
    const auto add = [&](double t) {
        if (!std::isfinite(t)) return;
        low = std::min(low, t);
        high = std::max(high, t);
    };
    for (const VertexId v : support.vertices) add(line.nearest(position(scene[v])));
    for (const EdgeId e : support.edges) {
        add(nearest(line, position(scene[scene[e].source]), position(scene[scene[e].target])));
    }
    return {low, high};
}

/// Where it crosses the plane of one of the faces.
std::optional<double> crossing(const RoundedLine& line, const SegmentEnd& end,
                               const Scene3& scene) {
    for (const FaceSide& side : end) {
        const auto& [a, b, c] = scene[side.face].plane;
        const Position p = position(scene[a]);
        const Position normal = detail::unit(cross(position(scene[b]) - p, position(scene[c]) - p));
        const double speed = dot(normal, line.direction);
        const double t = dot(normal, p - line.foot) / speed;
        if (std::abs(speed) > 0x1p-40 && std::isfinite(t)) return t;
    }
    return std::nullopt;
}

/// Cuts [from, to] off at the box; false when nothing is left.
bool clip(const RoundedLine& line, const Box& box, double& from, double& to) {
    const auto cut = [&](double foot, double speed, double low, double high) {
        if (speed == 0) return low <= foot && foot <= high;
        const double s = (low - foot) / speed;
        const double t = (high - foot) / speed;
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
        return from <= to;
    };
    return cut(line.foot.x, line.direction.x, box.low.x, box.high.x) &&
           cut(line.foot.y, line.direction.y, box.low.y, box.high.y) &&
           cut(line.foot.z, line.direction.z, box.low.z, box.high.z);
}

}  // namespace

std::optional<LinePiece> approx_piece(const SurdLine3& line, const SegmentLabel& label,
                                      const Scene3& scene, const Box& box) {
    const RoundedLine rounded(line);
    const auto [low, high] = extent_of(rounded, label.support, scene);
    const auto a = crossing(rounded, label.ends[0], scene);
    const auto b = crossing(rounded, label.ends[1], scene);
    double from = -infinity;
    double to = infinity;
    if (a && b) {
        std::tie(from, to) = std::minmax(*a, *b);
    } else if (a || b) {
        // The features lie behind the one end that there is.
        const double end = a ? *a : *b;
        const double farthest = std::abs(high - end) > std::abs(low - end) ? high : low;
        (farthest > end ? from : to) = end;
    }
    if (!clip(rounded, box, from, to)) return std::nullopt;
    return LinePiece{rounded.at(from), rounded.at(to)};
}

void add_surface(Layer& layer, const RuledSurface& surface, std::uint32_t id) {
    const auto add = [&](const Position& a, const Position& b, const Position& c) {
        if (a == b || b == c || c == a) return;
        layer.polygons.push_back({{a, b, c}, {}, id});
    };
    const auto holds_centre = [&](const LinePiece& piece) {
        const Position along = piece.to - piece.from;
        const double at = dot(*surface.centre - piece.from, along);
        return 0 < at && at < dot(along, along);
    };
    for (std::size_t i = 1; i < surface.lines.size(); ++i) {
        const LinePiece& p = surface.lines[i - 1];
        const LinePiece& q = surface.lines[i];
        if (surface.centre && holds_centre(p) && holds_centre(q)) {
            add(p.from, *surface.centre, q.from);
            add(p.to, q.to, *surface.centre);
        } else {
            add(p.from, p.to, q.to);
            add(p.from, q.to, q.from);
        }
    }
}

void add_outline(Layer& layer, const RuledSurface& surface, std::uint32_t id) {
    const auto& lines = surface.lines;
    if (lines.empty()) return;
    Polyline chain{{}, id};
    for (const LinePiece& piece : lines) chain.points.push_back(piece.from);
    for (std::size_t i = lines.size(); i-- > 0;) chain.points.push_back(lines[i].to);
    chain.points.push_back(lines.front().from);
    layer.polylines.push_back(std::move(chain));
}

}  // namespace sightline::viz
