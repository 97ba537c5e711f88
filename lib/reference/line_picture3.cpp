// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/line_picture3.hpp"

#include <algorithm>
#include <limits>

#include "arith/interval_cgal.hpp"

namespace sightline::reference::detail {
namespace {

using sightline::detail::IntervalNumber;
using sightline::detail::RoundingUp;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval everything{-infinity, infinity};

IntervalNumber number(const Interval& x) { return {x.lower, x.upper}; }
Interval interval(const IntervalNumber& x) {
    // A comparison with NaN is false.
    return x.inf() <= x.sup() ? Interval{x.inf(), x.sup()} : everything;
}

struct RoundedLine {
    std::size_t axis;
    std::array<Interval, 3> base;
    std::array<Interval, 3> direction;
};

[[gnu::noinline]] void project(const RoundedLine& line, std::span<const Point3> points,
                               std::vector<std::array<Interval, 2>>& out) {
    const RoundingUp rounding;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const std::array<double, 3> p{points[v].x, points[v].y, points[v].z};
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t c = (line.axis + 1 + i) % 3;
            const IntervalNumber t(p[line.axis]);
            out[v][i] = interval(IntervalNumber(p[c]) - number(line.base[c]) -
                                 t * number(line.direction[c]));
        }
    }
}

using RoundedPoint = std::array<Interval, 2>;

[[gnu::noinline]] Interval rounded_turn(const RoundedPoint& a, const RoundedPoint& b) {
    const RoundingUp rounding;
    return interval(number(a[0]) * number(b[1]) - number(a[1]) * number(b[0]));
}

// (ta wb - tb wa) / (wb - wa), for the heights and a projected coordinate of the ends of a segment.
[[gnu::noinline]] Interval rounded_crossing(double ta, double tb, const Interval& wa,
                                            const Interval& wb) {
    const RoundingUp rounding;
    const IntervalNumber below = number(wb) - number(wa);
    if (!(below.inf() > 0) && !(below.sup() < 0)) return everything;
    return interval((IntervalNumber(ta) * number(wb) - IntervalNumber(tb) * number(wa)) / below);
}

[[gnu::noinline]] Interval rounded_mean(const std::array<double, 3>& t,
                                        const std::array<Interval, 3>& weights) {
    const RoundingUp rounding;
    IntervalNumber sum(0);
    IntervalNumber mean(0);
    for (std::size_t i = 0; i < 3; ++i) {
        sum += number(weights[i]);
        mean += number(weights[i]) * IntervalNumber(t[i]);
    }
    if (!(sum.inf() > 0) && !(sum.sup() < 0)) return everything;
    return interval(mean / sum);
}

double coordinate(const Point3& p, std::size_t axis) {
    return std::array<double, 3>{p.x, p.y, p.z}[axis];
}

int sign_of_interval(const Interval& x) {  // 0 when not certain, too
    return x.lower > 0 ? 1 : x.upper < 0 ? -1 : 0;
}

}  // namespace

ExactLine::ExactLine(const SurdTriple& p, const SurdTriple& d) {
    SIGHTLINE_EXPECT(!is_zero(d));
    while (is_zero(d[axis])) ++axis;
    for (std::size_t i = 0; i < 3; ++i) direction[i] = d[i] / d[axis];
    base = minus(p, times(p[axis], direction));
}

LinePicture::LinePicture(const ExactScene& scene, const ExactLine& line)
    : scene_(&scene), line_(line), rounded_(scene.vertices.size()), exact_(scene.vertices.size()) {
    RoundedLine rounded{line.axis, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        rounded.base[i] = enclosure(line.base[i]);
        rounded.direction[i] = enclosure(line.direction[i]);
    }
    project(rounded, scene.scene.vertices(), rounded_);
}

std::array<Surd, 2> LinePicture::projected(const SurdTriple& vector) const {
    std::array<Surd, 2> result;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t c = (line_.axis + 1 + i) % 3;
        result[i] = vector[c] - vector[line_.axis] * line_.direction[c];
    }
    return result;
}

const LinePicture::Point& LinePicture::exact(VertexId v) const {
    auto& point = exact_[v.index()];
    if (!point) point = projected(minus(to_surd(scene_->vertices[v.index()]), line_.base));
    return *point;
}

int LinePicture::sign(VertexId v, std::size_t coordinate) const {
    const int certain = sign_of_interval(rounded_[v.index()][coordinate]);
    return certain != 0 ? certain : to_int(exact(v)[coordinate].sign());
}

Surd LinePicture::exact_turn(VertexId a, VertexId b) const {
    return exact(a)[0] * exact(b)[1] - exact(a)[1] * exact(b)[0];
}

int LinePicture::turn(VertexId a, VertexId b) const {
    const int certain = sign_of_interval(rounded_turn(rounded_[a.index()], rounded_[b.index()]));
    return certain != 0 ? certain : to_int(exact_turn(a, b).sign());
}

// The sign of a × b seen from (ε, ε²): at zero the term in ε decides, then that in ε².
int LinePicture::turn_when_moved(VertexId a, VertexId b) const {
    if (const int s = turn(a, b); s != 0) return s;
    if (const int s = to_int((exact(a)[1] - exact(b)[1]).sign()); s != 0) return s;
    return to_int((exact(b)[0] - exact(a)[0]).sign());
}

std::optional<Surd> LinePicture::crossing(VertexId a, VertexId b) const {
    for (std::size_t i = 0; i < 2; ++i) {
        const int side = sign(a, i);
        if (side != -sign(b, i)) return std::nullopt;
        if (side == 0) continue;
        if (turn(a, b) != 0) return std::nullopt;
        const Surd& wa = exact(a)[i];
        const Surd& wb = exact(b)[i];
        return (height(a) * wb - height(b) * wa) / (wb - wa);
    }
    return std::nullopt;
}

bool LinePicture::may_meet(VertexId a, VertexId b) const {
    for (std::size_t i = 0; i < 2; ++i) {
        const int side = sign_of_interval(rounded_[a.index()][i]);
        if (side != 0 && side == sign_of_interval(rounded_[b.index()][i])) return false;
    }
    return sign_of_interval(rounded_turn(rounded_[a.index()], rounded_[b.index()])) == 0;
}

Interval LinePicture::approx_crossing(VertexId a, VertexId b) const {
    const double ta = coordinate(scene_->scene[a], line_.axis);
    const double tb = coordinate(scene_->scene[b], line_.axis);
    for (std::size_t i = 0; i < 2; ++i) {
        const Interval t = rounded_crossing(ta, tb, rounded_[a.index()][i], rounded_[b.index()][i]);
        if (t != everything) return t;
    }
    return everything;
}

std::optional<std::array<Surd, 2>> LinePicture::trace(const Triangle3& t) const {
    const auto& c = t.corners;
    std::array<int, 3> turns;
    for (std::size_t i = 0; i < 3; ++i) turns[i] = turn(c[(i + 1) % 3], c[(i + 2) % 3]);
    const auto [least, most] = std::ranges::minmax(turns);
    if (least < 0 && most > 0) return std::nullopt;
    if (least == 0 && most == 0) return trace_in_plane(t);
    Surd sum;
    Surd mean;
    for (std::size_t i = 0; i < 3; ++i) {
        if (turns[i] == 0) continue;
        const Surd weight = exact_turn(c[(i + 1) % 3], c[(i + 2) % 3]);
        sum += weight;
        mean += weight * height(c[i]);
    }
    const Surd at = mean / sum;
    return std::array{at, at};
}

std::optional<std::array<Surd, 2>> LinePicture::trace_in_plane(const Triangle3& t) const {
    std::vector<Surd> met;
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_at(t.corners[i])) met.emplace_back(height(t.corners[i]));
        if (const auto at = crossing(t.corners[i], t.corners[(i + 1) % 3])) met.push_back(*at);
    }
    if (met.empty()) return std::nullopt;
    const auto [least, most] = std::ranges::minmax_element(met);
    return std::array{*least, *most};
}

bool LinePicture::is_crossed_when_moved(const Triangle3& t) const {
    const auto& [a, b, c] = t.corners;
    const int side = turn_when_moved(a, b);
    if (side == 0 || turn_when_moved(b, c) != side || turn_when_moved(c, a) != side) return false;
    return true;
}

bool LinePicture::certainly_blocks(const Triangle3& t, const Interval& between) const {
    std::array<Interval, 3> weights;
    std::array<double, 3> heights;
    for (std::size_t i = 0; i < 3; ++i) {
        weights[i] = rounded_turn(rounded_[t.corners[(i + 1) % 3].index()],
                                  rounded_[t.corners[(i + 2) % 3].index()]);
        heights[i] = coordinate(scene_->scene[t.corners[i]], line_.axis);
    }
    const int side = sign_of_interval(weights[0]);
    if (side == 0 || sign_of_interval(weights[1]) != side || sign_of_interval(weights[2]) != side) {
        return false;
    }
    const Interval at = rounded_mean(heights, weights);
    return between.lower < at.lower && at.upper < between.upper;
}

}  // namespace sightline::reference::detail
