// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "sightline/reference/visibility_polygon.hpp"

namespace sightline::reference {
namespace {

RationalPoint2 difference(const RationalPoint2& a, const RationalPoint2& b) {
    return {a.x - b.x, a.y - b.y};
}

// Whether the ring goes straight on at b.
bool is_straight(const ViewPoint& a, const ViewPoint& b, const ViewPoint& c) {
    if (b.at_infinity || (a.at_infinity && c.at_infinity)) return false;
    const RationalPoint2 in = a.at_infinity ? RationalPoint2{-a.coordinates.x, -a.coordinates.y}
                                            : difference(b.coordinates, a.coordinates);
    const RationalPoint2 out =
        c.at_infinity ? c.coordinates : difference(c.coordinates, b.coordinates);
    return in.x * out.y == in.y * out.x && (in.x * out.x + in.y * out.y).sign() == Sign::positive;
}

bool finite_first(const ViewPoint& a, const ViewPoint& b) {
    if (a.at_infinity != b.at_infinity) return b.at_infinity;
    return a.coordinates < b.coordinates;
}

bool sequence_less(const std::vector<ViewPoint>& a, const std::vector<ViewPoint>& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), finite_first);
}

}  // namespace

ViewPoint at_infinity(const RationalPoint2& direction) {
    const Rational scale = std::max(abs(direction.x), abs(direction.y));
    return {{direction.x / scale, direction.y / scale}, true};
}

std::vector<ViewPoint> canonical_ring(std::vector<ViewPoint> ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    std::vector<ViewPoint> corners;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_straight(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]))
            corners.push_back(ring[i]);
    }
    if (corners.empty()) return corners;
    const ViewPoint least = *std::min_element(corners.begin(), corners.end(), finite_first);
    std::vector<ViewPoint> best;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] != least) continue;
        std::vector<ViewPoint> candidate = corners;
        std::rotate(candidate.begin(), candidate.begin() + static_cast<std::ptrdiff_t>(i),
                    candidate.end());
        if (best.empty() || sequence_less(candidate, best)) best = std::move(candidate);
    }
    return best;
}

Rational twice_area(const std::vector<ViewPoint>& ring) {
    Rational sum;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        SIGHTLINE_EXPECT(!ring[i].at_infinity);
        const RationalPoint2& a = ring[i].coordinates;
        const RationalPoint2& b = ring[(i + 1) % ring.size()].coordinates;
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

}  // namespace sightline::reference
