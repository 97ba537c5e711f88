// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/visibility_polygon.hpp"

#include <algorithm>
#include <optional>

#include "reference/sight_line.hpp"

namespace sightline::reference {
namespace {

/// How far the view goes along the two directions that bound a sector; empty: to infinity.
struct Sector {
    std::optional<Place> at_first;
    std::optional<Place> at_last;
};

class Viewer {
public:
    Viewer(const Scene2& scene, const RationalPoint2& q);

    [[nodiscard]] std::vector<ViewPoint> ring() const;
    [[nodiscard]] std::vector<SeenSegment> needles() const;

private:
    void find_critical_directions();
    void add_direction(const Place& tip);
    [[nodiscard]] RationalPoint2 direction(const Place& tip) const;
    [[nodiscard]] Place between(const Place& a, const Place& b) const;
    [[nodiscard]] std::optional<Place> shoot(const Place& tip) const;
    [[nodiscard]] Sector look_between(const Place& a, const Place& b) const;
    [[nodiscard]] ViewPoint view_point(const std::optional<Place>& x, const Place& tip) const;
    [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % tips_.size(); }
    [[nodiscard]] bool is_unbounded(std::size_t i) const { return !sectors_[i].at_first; }
    [[nodiscard]] std::size_t add_unbounded_range(std::size_t first,
                                                  std::vector<ViewPoint>& ring) const;

    const Scene2& scene_;
    Place q_;
    Everything everything_;
    std::vector<Place> axes_;
    std::vector<Place> tips_;      // a place in each critical direction, counter-clockwise
    std::vector<Sector> sectors_;  // sector i lies between directions i and i + 1
};

RationalPoint2 scaled(const RationalPoint2& d) { return at_infinity(d).coordinates; }

Viewer::Viewer(const Scene2& scene, const RationalPoint2& q)
    : scene_(scene), q_(q), everything_(scene) {
    axes_ = {RationalPoint2{q.x + 1, q.y}, RationalPoint2{q.x, q.y + 1},
             RationalPoint2{q.x - 1, q.y}, RationalPoint2{q.x, q.y - 1}};
    find_critical_directions();
    for (std::size_t i = 0; i < tips_.size(); ++i) {
        sectors_.push_back(look_between(tips_[i], tips_[next(i)]));
    }
}

void Viewer::add_direction(const Place& tip) {
    if (tip != q_) tips_.push_back(tip);
}

// The axes are among them so that no sector spans a half-turn.
void Viewer::find_critical_directions() {
    for (const Point2& v : scene_.vertices()) add_direction(v);
    for (const Place& axis : axes_) add_direction(axis);
    const auto edges = scene_.edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < i && edges[i].kind == EdgeKind2::wall; ++j) {
            if (edges[j].kind != EdgeKind2::wall) continue;
            const Place a = scene_[edges[i].source];
            const Place b = scene_[edges[i].target];
            const Place c = scene_[edges[j].source];
            const Place d = scene_[edges[j].target];
            const bool crosses = side(a, b, c) * side(a, b, d) == Sign::negative &&
                                 side(c, d, a) * side(c, d, b) == Sign::negative;
            if (crosses) add_direction(crossing(a, b, c, d));
        }
    }
    const auto before = [this](const Place& a, const Place& b) {
        return order_round(q_, {a}, {b}) < 0;
    };
    const auto same = [this](const Place& a, const Place& b) {
        return order_round(q_, {a}, {b}) == 0;
    };
    std::stable_sort(tips_.begin(), tips_.end(), before);
    tips_.erase(std::unique(tips_.begin(), tips_.end(), same), tips_.end());
}

RationalPoint2 Viewer::direction(const Place& tip) const {
    const RationalPoint2 p = tip.rational();
    const RationalPoint2 q = q_.rational();
    return {p.x - q.x, p.y - q.y};
}

// A place strictly inside the sector, which spans at most 90°; with short coordinates if it can be had.
Place Viewer::between(const Place& a, const Place& b) const {
    const RationalPoint2 q = q_.rational();
    const RationalPoint2 u = scaled(direction(a));
    const RationalPoint2 v = scaled(direction(b));
    const RationalPoint2 exact{q.x + u.x + v.x, q.y + u.y + v.y};
    const Place rounded = approx_point(exact);
    const bool is_inside = rounded != q_ && side(q_, a, rounded) == Sign::positive &&
                           side(q_, rounded, b) == Sign::positive;
    return is_inside ? rounded : Place(exact);
}

std::optional<Place> Viewer::shoot(const Place& tip) const {
    return SightLine(scene_, everything_.candidates(), q_, tip, Reach::ray).stop();
}

// Inside the sector nothing ends or crosses: what stops one ray stops them all.
Sector Viewer::look_between(const Place& a, const Place& b) const {
    const std::optional<Place> stop = shoot(between(a, b));
    if (!stop || *stop == q_) return {stop, stop};
    for (const EdgeId e : everything_.candidates().edges) {
        if (!is_on(scene_, e, *stop)) continue;
        const Place source = scene_[scene_[e].source];
        const Place target = scene_[scene_[e].target];
        return {crossing(q_, a, source, target), crossing(q_, b, source, target)};
    }
    SIGHTLINE_EXPECT(!"a ray stops at an edge");
    return {};
}

ViewPoint Viewer::view_point(const std::optional<Place>& x, const Place& tip) const {
    return x ? ViewPoint{x->rational(), false} : at_infinity(direction(tip));
}

// Adds the vertices at infinity of the unbounded range that begins with sector `first`; the sector after it.
std::size_t Viewer::add_unbounded_range(std::size_t first, std::vector<ViewPoint>& ring) const {
    std::size_t end = first;
    while (is_unbounded(end)) end = next(end);
    const bool is_wide = side(q_, tips_[first], tips_[end]) != Sign::positive;
    ring.push_back(at_infinity(direction(tips_[first])));
    for (std::size_t i = next(first); i != end && is_wide; i = next(i)) {
        const auto is_same = [&](const Place& axis) {
            return order_round(q_, {axis}, {tips_[i]}) == 0;
        };
        if (std::any_of(axes_.begin(), axes_.end(), is_same)) {
            ring.push_back(at_infinity(direction(tips_[i])));
        }
    }
    ring.push_back(at_infinity(direction(tips_[end])));
    return end;
}

std::vector<ViewPoint> Viewer::ring() const {
    std::vector<ViewPoint> ring;
    std::size_t start = 0;  // a bounded sector
    while (start < sectors_.size() && is_unbounded(start)) ++start;
    if (start == sectors_.size()) {
        for (const Place& axis : axes_) ring.push_back(at_infinity(direction(axis)));
        return canonical_ring(std::move(ring));
    }
    std::size_t i = start;
    do {
        const Sector& sector = sectors_[i];
        if (!sector.at_first || !sector.at_last) {  // unbounded: both are missing
            i = add_unbounded_range(i, ring);
            continue;
        }
        ring.push_back({sector.at_first->rational(), false});
        ring.push_back({sector.at_last->rational(), false});
        i = next(i);
    } while (i != start);
    return canonical_ring(std::move(ring));
}

std::vector<SeenSegment> Viewer::needles() const {
    std::vector<SeenSegment> result;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
        const std::optional<Place>& left = sectors_[i].at_first;
        const std::optional<Place>& right = sectors_[(i + tips_.size() - 1) % tips_.size()].at_last;
        if (!left || !right) continue;
        const bool up = q_ < tips_[i];
        const auto farther = [up](const Place& a, const Place& b) { return up ? b < a : a < b; };
        const Place& near = farther(*left, *right) ? *left : *right;
        const std::optional<Place> far = shoot(tips_[i]);
        SIGHTLINE_EXPECT(!far || !farther(near, *far));
        if (far && *far == near) continue;
        result.push_back({view_point(near, tips_[i]), view_point(far, tips_[i])});
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

Result<PointView> visibility_polygon(const Scene2& scene, const RationalPoint2& q,
                                     const VisibilityPolygonOptions& options) {
    if (is_interior(scene, q)) return tl::unexpected(inside_error(scene, q));
    const Viewer viewer(scene, q);
    PointView view{q, viewer.ring(), {}};
    if (options.needles == Needles::with_needles) view.needles = viewer.needles();
    return view;
}

}  // namespace sightline::reference
