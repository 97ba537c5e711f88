// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/clip_view.hpp"

#include <algorithm>
#include <array>

#include "planar/exact_ring.hpp"

namespace sightline {
namespace {

/// The side of the box along which `coordinate` (times `sense`) is at most `bound`.
struct Side {
    Rational RationalPoint2::* coordinate;
    bool is_upper;
    Rational bound;

    [[nodiscard]] bool is_inside(const RationalPoint2& p) const {
        return is_upper ? p.*coordinate <= bound : p.*coordinate >= bound;
    }
    /// Where the segment pq, whose ends lie on different sides, meets the line.
    [[nodiscard]] RationalPoint2 meet(const RationalPoint2& p, const RationalPoint2& q) const {
        const Rational t = (bound - p.*coordinate) / (q.*coordinate - p.*coordinate);
        return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
    }
};

std::array<Side, 4> sides_of(const RationalBox2& box) {
    return {{{&RationalPoint2::x, true, box.high.x},
             {&RationalPoint2::y, true, box.high.y},
             {&RationalPoint2::x, false, box.low.x},
             {&RationalPoint2::y, false, box.low.y}}};
}

/// How far to go from q in the directions d and e so that the segment between there passes behind
/// the box, within the cone that the two span.
Rational reach(const RationalPoint2& q, const RationalPoint2& d, const RationalPoint2& e,
               const RationalBox2& box) {
    Rational most = 1;
    const Rational det = d.x * e.y - d.y * e.x;
    for (const Rational& x : {box.low.x, box.high.x}) {
        for (const Rational& y : {box.low.y, box.high.y}) {
            const Rational dx = x - q.x;
            const Rational dy = y - q.y;
            // At least as far as any corner along either axis, as the larger of |d.x| and |d.y| is 1.
            most = std::max(most, abs(dx) + abs(dy));
            if (det.sign() != Sign::positive) continue;
            const Rational a = (dx * e.y - dy * e.x) / det;
            const Rational b = (d.x * dy - d.y * dx) / det;
            if (a.sign() != Sign::negative && b.sign() != Sign::negative) {
                most = std::max(most, a + b);
            }
        }
    }
    return most;
}

/// The ring with its vertices at infinity replaced by points behind the box.
std::vector<RationalPoint2> bounded(const RationalPoint2& q, std::span<const ViewPoint> ring,
                                    const RationalBox2& box) {
    Rational far = 1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const ViewPoint& next = ring[(i + 1) % ring.size()];
        if (!ring[i].at_infinity) continue;
        const RationalPoint2& d = ring[i].coordinates;
        far = std::max(far, reach(q, d, next.at_infinity ? next.coordinates : d, box));
    }
    std::vector<RationalPoint2> points;
    for (const ViewPoint& p : ring) {
        const RationalPoint2& c = p.coordinates;
        points.push_back(p.at_infinity ? RationalPoint2{q.x + far * c.x, q.y + far * c.y} : c);
    }
    return points;
}

std::vector<RationalPoint2> cut(const std::vector<RationalPoint2>& ring, const Side& side) {
    std::vector<RationalPoint2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RationalPoint2& p = ring[i];
        const RationalPoint2& next = ring[(i + 1) % ring.size()];
        const bool here = side.is_inside(p);
        if (here) kept.push_back(p);
        if (here != side.is_inside(next)) kept.push_back(side.meet(p, next));
    }
    return kept;
}

/// Removes vertices at which the ring turns back on itself: what is left of parts that meet the
/// half-plane in its border only.
void drop_spikes(std::vector<RationalPoint2>& ring) {
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2;) {
        const std::size_t n = ring.size();
        const RationalPoint2& a = ring[(i + n - 1) % n];
        const RationalPoint2& b = ring[i];
        const RationalPoint2& c = ring[(i + 1) % n];
        const RationalPoint2 in{b.x - a.x, b.y - a.y};
        const RationalPoint2 out{c.x - b.x, c.y - b.y};
        const bool turns = (in.x * out.y - in.y * out.x).sign() != Sign::zero;
        if (turns || (in.x * out.x + in.y * out.y).sign() == Sign::positive) {
            ++i;
            continue;
        }
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        i = i == 0 ? 0 : i - 1;
    }
}

}  // namespace

std::vector<ViewPoint> clipped_ring(const RationalPoint2& from, std::span<const ViewPoint> ring,
                                    const RationalBox2& box) {
    SIGHTLINE_EXPECT(box.low.x < box.high.x && box.low.y < box.high.y && box.contains(from));
    std::vector<RationalPoint2> points = bounded(from, ring, box);
    for (const Side& side : sides_of(box)) points = cut(points, side);
    drop_spikes(points);
    std::vector<ViewPoint> result;
    result.reserve(points.size());
    for (RationalPoint2& p : points) result.push_back({std::move(p), false});
    result = detail::canonical_form(std::move(result));
    if (result.size() < 3) result.clear();
    return result;
}

std::optional<std::pair<ViewPoint, ViewPoint>> clipped_needle(
    const RationalPoint2& from, const std::pair<ViewPoint, ViewPoint>& needle,
    const RationalBox2& box) {
    SIGHTLINE_EXPECT(box.low.x < box.high.x && box.low.y < box.high.y && box.contains(from));
    const RationalPoint2& near = needle.first.coordinates;
    RationalPoint2 far = needle.second.coordinates;
    if (!box.contains(near)) return std::nullopt;
    if (needle.second.at_infinity) {
        const Rational beyond = reach(from, far, far, box);
        far = {from.x + beyond * far.x, from.y + beyond * far.y};
    }
    for (const Side& side : sides_of(box)) {
        if (!side.is_inside(far)) far = side.meet(near, far);
    }
    if (near == far) return std::nullopt;
    return std::pair{needle.first, ViewPoint{far, false}};
}

}  // namespace sightline
