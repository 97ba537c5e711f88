// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/families2_detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sightline/scene/result.hpp"

namespace sightline::families::detail {

Ring2 to_ring(const IntRing& ring) {
    Ring2 result;
    result.reserve(ring.size());
    for (const IntPoint p : ring) result.push_back(to_point(p));
    return result;
}

Polygon2 to_polygon(const IntRing& ring) { return {to_ring(ring), {}}; }

Polyline2 to_wall(IntPoint source, IntPoint target) {
    return {{to_point(source), to_point(target)}};
}

IntRing box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

bool angle_less(IntPoint u, IntPoint v) {
    const auto upper = [](IntPoint d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
    if (upper(u) != upper(v)) return upper(u);
    return cross(u, v) > 0;
}

bool turns_left_everywhere(const IntRing& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (cross(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
    }
    return n >= 3;
}

bool strictly_inside(const IntRing& convex, IntPoint p) {
    for (std::size_t i = 0, n = convex.size(); i < n; ++i) {
        if (cross(convex[i], convex[(i + 1) % n], p) <= 0) return false;
    }
    return true;
}

namespace {

/// Whether b lies strictly to the right of one of a's edges.
bool an_edge_separates(const IntRing& a, const IntRing& b) {
    for (std::size_t i = 0, n = a.size(); i < n; ++i) {
        const IntPoint p = a[i];
        const IntPoint q = a[i + 1 == n ? 0 : i + 1];
        if (std::all_of(b.begin(), b.end(), [&](IntPoint r) { return cross(p, q, r) < 0; }))
            return true;
    }
    return false;
}

}  // namespace

bool are_disjoint(const IntRing& a, const IntRing& b) {
    return an_edge_separates(a, b) || an_edge_separates(b, a);
}

namespace {

/// Valtr's steps along one axis: k random integers from 0 to extent (both taken), split into two monotone
/// chains; the differences, which sum to 0.
std::vector<std::int64_t> closed_steps(Rng& rng, std::size_t k, std::int64_t extent) {
    std::vector<std::int64_t> values{0, extent};
    while (values.size() < k) values.push_back(rng.between(0, extent));
    std::sort(values.begin(), values.end());
    std::vector<std::int64_t> steps;
    std::int64_t up = 0;
    std::int64_t down = 0;
    for (std::size_t i = 1; i + 1 < k; ++i) {
        std::int64_t& end = rng.one_in(2) ? up : down;
        steps.push_back(&end == &up ? values[i] - end : end - values[i]);
        end = values[i];
    }
    steps.push_back(extent - up);
    steps.push_back(down - extent);
    return steps;
}

}  // namespace

IntRing random_convex_ring(Rng& rng, std::size_t k, std::int64_t width, std::int64_t height) {
    SIGHTLINE_EXPECT(k >= 3 && width >= 4 * static_cast<std::int64_t>(k) &&
                     height >= 4 * static_cast<std::int64_t>(k));
    while (true) {
        const std::vector<std::int64_t> dx = closed_steps(rng, k, width);
        std::vector<std::int64_t> dy = closed_steps(rng, k, height);
        rng.shuffle(dy);
        IntRing steps;
        for (std::size_t i = 0; i < k; ++i) steps.push_back({dx[i], dy[i]});
        if (std::find(steps.begin(), steps.end(), IntPoint{}) != steps.end()) continue;
        std::sort(steps.begin(), steps.end(), angle_less);
        IntRing ring;
        IntPoint at{};
        IntPoint least{};
        for (const IntPoint step : steps) {
            ring.push_back(at);
            least = {std::min(least.x, at.x), std::min(least.y, at.y)};
            at = at + step;
        }
        for (IntPoint& p : ring) p = p - least;
        if (turns_left_everywhere(ring)) return ring;  // else two steps are parallel
    }
}

namespace {

/// cos and sin of x for |x| ≤ π/4, by their series.
CosSin series(double x) {
    const double square = x * x;
    double cosine = 1;
    double sine = 1;
    for (int i = 20; i >= 2; i -= 2) {
        cosine = 1 - cosine * square / ((i - 1) * i);
        sine = 1 - sine * square / (i * (i + 1));
    }
    return {cosine, sine * x};
}

constexpr double quarter_pi = 0.78539816339744830962;

CosSin turned_by_quarters(CosSin v, unsigned quarters) {
    for (unsigned i = 0; i < quarters % 4; ++i) v = {0.0 - v.sine, v.cosine};
    return v;
}

}  // namespace

IntPoint on_circle(std::uint64_t k, std::uint64_t n, std::int64_t radius) {
    const std::uint64_t eighths = 8 * (k % n);
    const std::uint64_t octant = eighths / n;
    const std::uint64_t rest = eighths % n;
    const auto fraction = [&](std::uint64_t part) {
        return static_cast<double>(part) / static_cast<double>(n) * quarter_pi;
    };
    CosSin v = octant % 2 == 0 ? series(fraction(rest)) : series(fraction(n - rest));
    if (octant % 2 == 1) std::swap(v.cosine, v.sine);
    v = turned_by_quarters(v, static_cast<unsigned>(octant / 2));
    const auto scaled = [&](double t) {
        return static_cast<std::int64_t>(std::floor(t * static_cast<double>(radius) + 0.5));
    };
    return {scaled(v.cosine), scaled(v.sine)};
}

CosSin approx_cos_sin(double degrees) {
    double rest = std::fmod(degrees, 360.0);  // exact
    if (rest < 0) rest += 360.0;
    const double quarters = std::floor(rest / 90.0 + 0.5);
    rest -= 90.0 * quarters;  // exact: |rest| ≤ 45 and both terms are near
    return turned_by_quarters(series(rest / 45.0 * quarter_pi), static_cast<unsigned>(quarters));
}

std::int64_t ceil_sqrt(std::uint64_t n) {
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
    while (root * root < n) ++root;
    while (root > 0 && (root - 1) * (root - 1) >= n) --root;
    return static_cast<std::int64_t>(root);
}

Placer::Placer(std::int64_t extent, std::size_t expected)
    : extent_(extent),
      side_(static_cast<std::size_t>(ceil_sqrt(expected + 1))),
      cells_(side_ * side_) {
    rings_.reserve(expected);
}

Placer::CellRange Placer::cells_of(const IntRing& ring) const {
    IntPoint low = ring.front();
    IntPoint high = low;
    for (const IntPoint p : ring) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto cell = [&](std::int64_t t) {
        return static_cast<std::size_t>(t * static_cast<std::int64_t>(side_) / (extent_ + 1));
    };
    return {cell(low.x), cell(high.x), cell(low.y), cell(high.y)};
}

bool Placer::meets_any(const IntRing& ring, const CellRange& range) const {
    for (std::size_t y = range.y0; y <= range.y1; ++y) {
        for (std::size_t x = range.x0; x <= range.x1; ++x) {
            for (const std::uint32_t other : cells_[y * side_ + x]) {
                if (!are_disjoint(ring, rings_[other])) return true;
            }
        }
    }
    return false;
}

bool Placer::try_add(IntRing ring) {
    for (const IntPoint p : ring) {
        if (p.x < 0 || p.y < 0 || p.x > extent_ || p.y > extent_) return false;
    }
    const CellRange range = cells_of(ring);
    if (meets_any(ring, range)) return false;
    const auto id = static_cast<std::uint32_t>(rings_.size());
    for (std::size_t y = range.y0; y <= range.y1; ++y) {
        for (std::size_t x = range.x0; x <= range.x1; ++x) cells_[y * side_ + x].push_back(id);
    }
    rings_.push_back(std::move(ring));
    return true;
}

}  // namespace sightline::families::detail
