// SPDX-License-Identifier: GPL-3.0-or-later
// Random simple polygons, star-shaped and not, and polygons with holes.
#include <algorithm>
#include <span>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

namespace detail {
namespace {

constexpr std::int64_t cut_parts = 256;

/// A direction for a line through s that has `source` and `target` strictly on different sides, or (0, 0) when
/// there is none: it meets the segment between them in a random inner point.
IntPoint cut_direction(Rng& rng, IntPoint source, IntPoint target, IntPoint s) {
    const std::int64_t part = rng.between(1, cut_parts - 1);
    if (cross(source, target, s) != 0) {
        const IntPoint a = source - s;
        const IntPoint b = target - source;
        return {cut_parts * a.x + part * b.x, cut_parts * a.y + part * b.y};
    }
    const IntPoint a = source - s;
    const IntPoint b = target - s;
    const bool between = a.x * b.x + a.y * b.y < 0;
    return between ? IntPoint{a.y - b.y, b.x - a.x} : IntPoint{};
}

/// Orders `chain` so that it is a simple chain from its first to its last point. Each step cuts the points by
/// a line through one of them: the hulls of the two parts have that point only in common, so the parts' chains
/// have, too. False when no cut was found (collinear points).
bool arrange(Rng& rng, std::span<IntPoint> chain) {
    if (chain.size() < 3) return true;
    const IntPoint source = chain.front();
    const IntPoint target = chain.back();
    const std::span<IntPoint> inner = chain.subspan(1, chain.size() - 2);
    for (int attempt = 0; attempt < 32; ++attempt) {
        const std::size_t pivot = rng.below(inner.size());
        const IntPoint s = inner[pivot];
        const IntPoint direction = cut_direction(rng, source, target, s);
        if (direction == IntPoint{}) continue;
        std::swap(inner[pivot], inner.back());
        const bool source_left = cross(direction, source - s) > 0;
        // Points on the line go with the source: then the target's hull meets the line in s alone.
        // (Not std::partition: the order that it leaves may differ between libraries.)
        std::size_t middle = 0;
        for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
            const std::int64_t side = cross(direction, inner[i] - s);
            if (side == 0 || (side > 0) == source_left) std::swap(inner[i], inner[middle++]);
        }
        std::swap(inner[middle], inner.back());
        const std::size_t cut = middle + 1;  // index of s in the chain
        return arrange(rng, chain.first(cut + 1)) && arrange(rng, chain.subspan(cut));
    }
    return false;
}

/// k distinct random lattice points in lexicographic order.
IntRing random_points(Rng& rng, std::size_t k, std::int64_t extent) {
    IntRing points;
    while (points.size() < k) {
        while (points.size() < k)
            points.push_back({rng.between(0, extent), rng.between(0, extent)});
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    return points;
}

}  // namespace

IntRing random_simple_ring(Rng& rng, std::size_t k, std::int64_t extent) {
    SIGHTLINE_EXPECT(k >= 3);
    while (true) {
        const IntRing points = random_points(rng, k, extent);
        const IntPoint first = points.front();
        const IntPoint last = points.back();
        IntRing lower{first};
        IntRing upper{last};
        IntRing on_line;
        for (std::size_t i = 1; i + 1 < k; ++i) {
            const std::int64_t side = cross(first, last, points[i]);
            (side < 0 ? lower : side > 0 ? upper : on_line).push_back(points[i]);
        }
        if (on_line.size() + 2 == k) continue;
        // Points on the line go to an empty side if there is one: the other side's chain leaves the line.
        IntRing& side = upper.size() == 1 ? upper : lower;
        side.insert(side.end(), on_line.begin(), on_line.end());
        lower.push_back(last);
        upper.push_back(first);
        if (!arrange(rng, lower) || !arrange(rng, upper)) continue;
        IntRing ring(lower.begin(), lower.end() - 1);
        ring.insert(ring.end(), upper.begin(), upper.end() - 1);
        return ring;
    }
}

}  // namespace detail

using namespace detail;

namespace {

constexpr std::int64_t plane = std::int64_t{1} << 20;

SceneInput2 one_polygon(Polygon2 polygon, bool world) {
    SceneInput2 scene;
    scene.elements.emplace_back(std::move(polygon));
    scene.world = world;
    return scene;
}

/// Whether consecutive directions are less than half a turn apart: then the ring goes round the origin once.
bool surrounds_origin(const IntRing& ring) {
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
        if (cross(ring[i], ring[(i + 1) % n]) <= 0) return false;
    }
    return true;
}

/// Keeps one point of each direction from the origin, sorted by direction.
void keep_one_of_each_direction(IntRing& points) {
    std::erase(points, IntPoint{});
    std::sort(points.begin(), points.end(), [](IntPoint u, IntPoint v) {
        if (angle_less(u, v)) return true;
        return !angle_less(v, u) && u < v;
    });
    const auto same = [](IntPoint u, IntPoint v) { return !angle_less(u, v) && !angle_less(v, u); };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
}

}  // namespace

SceneInput2 star_shaped(const SimplePolygon& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.vertices >= 3 && parameters.vertices <= 1'000'000);
    Rng rng(seed);
    IntRing ring;
    do {
        ring.clear();
        while (ring.size() < parameters.vertices) {
            while (ring.size() < parameters.vertices) {
                ring.push_back({rng.between(-plane, plane), rng.between(-plane, plane)});
            }
            keep_one_of_each_direction(ring);
        }
    } while (!surrounds_origin(ring));
    return one_polygon(to_polygon(ring), parameters.world);
}

SceneInput2 simple_polygon(const SimplePolygon& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.vertices >= 3 && parameters.vertices <= 1'000'000);
    Rng rng(seed);
    return one_polygon(to_polygon(random_simple_ring(rng, parameters.vertices, plane)),
                       parameters.world);
}

SceneInput2 simple_polygons(const SimplePolygons& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.polygons >= 1 && parameters.polygons <= 100'000);
    SIGHTLINE_EXPECT(parameters.vertices >= 3 && parameters.vertices <= 10'000);
    Rng rng(seed);
    const std::int64_t cell = 4096 + 4 * static_cast<std::int64_t>(parameters.vertices);
    const std::int64_t side = ceil_sqrt(parameters.polygons);
    SceneInput2 scene;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(parameters.polygons); ++i) {
        IntRing ring = random_simple_ring(rng, parameters.vertices, cell);
        const IntPoint corner{i % side * (cell + cell / 16), i / side * (cell + cell / 16)};
        for (IntPoint& p : ring) p = p + corner;
        scene.elements.emplace_back(to_polygon(ring));
    }
    return scene;
}

namespace {

/// A counter-clockwise ring round [0, size]² whose sides are random zigzags within `margin` of it.
IntRing jagged_ring(Rng& rng, std::int64_t size, std::int64_t margin) {
    constexpr std::int64_t pieces = 6;
    IntRing bottom;  // x from −margin to size, y < 0; the other sides are its likes, turned
    IntRing ring;
    for (int turn = 0; turn < 4; ++turn) {
        bottom.assign({{-margin, -margin}});
        for (std::int64_t i = 1; i < pieces; ++i) {
            const std::int64_t x = size * i / pieces + rng.between(0, size / (2 * pieces));
            bottom.push_back({x, -rng.between(1, margin)});
        }
        for (IntPoint p : bottom) {
            for (int i = 0; i < turn; ++i) p = {size - p.y, p.x};
            ring.push_back(p);
        }
    }
    return ring;
}

/// A copy of a convex ring at half its size in its middle, or nothing when rounding spoils it.
IntRing island_of(const IntRing& hole) {
    IntPoint sum{};
    for (const IntPoint p : hole) sum = sum + p;
    const auto n = static_cast<std::int64_t>(hole.size());
    IntRing island;
    for (const IntPoint p : hole) island.push_back({(p.x + sum.x / n) / 2, (p.y + sum.y / n) / 2});
    const bool inside = std::all_of(island.begin(), island.end(),
                                    [&](IntPoint p) { return strictly_inside(hole, p); });
    return inside && turns_left_everywhere(island) ? island : IntRing{};
}

}  // namespace

SceneInput2 polygons_with_holes(const PolygonsWithHoles& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.polygons >= 1 && parameters.polygons <= 10'000);
    SIGHTLINE_EXPECT(parameters.holes >= 1 && parameters.holes <= 10'000);
    Rng rng(seed);
    const std::int64_t spacing = 1024;
    const std::int64_t size = spacing * ceil_sqrt(parameters.holes);
    const std::int64_t margin = size / 8;
    const std::int64_t side = ceil_sqrt(parameters.polygons);
    SceneInput2 scene;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(parameters.polygons); ++i) {
        const IntPoint corner{i % side * (size + 3 * margin), i / side * (size + 3 * margin)};
        const auto moved = [&](IntRing ring) {
            for (IntPoint& p : ring) p = p + corner;
            return to_ring(ring);
        };
        Placer placer(size, parameters.holes);
        for (std::size_t placed = 0; placed < parameters.holes;) {
            IntRing ring = random_convex_ring(rng, 3 + rng.below(5), spacing / 3, spacing / 3);
            const IntPoint at{rng.between(0, size), rng.between(0, size)};
            for (IntPoint& p : ring) p = p + at;
            if (placer.try_add(std::move(ring))) ++placed;
        }
        const std::vector<IntRing> holes = placer.take();
        Polygon2 polygon{moved(jagged_ring(rng, size, margin)), {}};
        for (const IntRing& hole : holes) polygon.holes.push_back(moved(hole));
        scene.elements.emplace_back(std::move(polygon));
        for (std::size_t k = 0; k < holes.size(); k += 2) {
            const IntRing island = island_of(holes[k]);
            if (!island.empty()) scene.elements.emplace_back(Polygon2{moved(island), {}});
        }
    }
    return scene;
}

}  // namespace sightline::families
