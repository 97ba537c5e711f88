// SPDX-License-Identifier: GPL-3.0-or-later
// Random convex bodies: sparse, dense, packed, scaled, needles.
#include <algorithm>
#include <cmath>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

namespace {

/// Numbers of vertices, 3 to 8 each, that sum to n ≥ 3.
std::vector<std::size_t> split_vertices(Rng& rng, std::size_t n) {
    std::vector<std::size_t> sizes;
    while (n > 8) {
        const std::size_t k = 3 + rng.below(6);
        if (n - k < 3) continue;
        sizes.push_back(k);
        n -= k;
    }
    sizes.push_back(n);
    return sizes;
}

/// Side of the square for so many bodies: 2^20, or more when that leaves a body less than 1024².
std::int64_t extent_for(std::size_t bodies) {
    return std::max<std::int64_t>(std::int64_t{1} << 20, 1024 * ceil_sqrt(bodies));
}

/// A nearly square ring round [0, extent]² whose sides are not parallel to the axes.
IntRing world_ring(std::int64_t extent) {
    const std::int64_t m = extent / 40;
    const std::int64_t far = extent + m;
    return {{-m, -m - 1}, {far, -m}, {far - 1, far + 1}, {-m - 2, far - 1}};
}

/// Puts a ring of k vertices somewhere; boxes of sides between `least` and `most` at first, smaller ones when
/// they don't fit.
void place(Rng& rng, Placer& placer, std::size_t k, std::int64_t extent, std::int64_t least,
           std::int64_t most) {
    const auto smallest = static_cast<std::int64_t>(4 * k);
    for (;; least = std::max(least * 7 / 8, smallest), most = std::max(most * 7 / 8, smallest)) {
        const std::int64_t width = rng.between(std::max(least, smallest), most);
        const std::int64_t height = rng.between(std::max(least, smallest), most);
        IntRing ring = random_convex_ring(rng, k, width, height);
        const std::int64_t x = rng.between(0, extent - width);
        const std::int64_t y = rng.between(0, extent - height);
        for (IntPoint& p : ring) p = p + IntPoint{x, y};
        if (placer.try_add(std::move(ring))) return;
    }
}

std::vector<IntRing> scattered(Rng& rng, const std::vector<std::size_t>& sizes, std::int64_t extent,
                               Density density) {
    const std::int64_t spacing = extent / ceil_sqrt(sizes.size());
    const bool sparse = density == Density::sparse;
    const std::int64_t least = sparse ? spacing / 16 : spacing / 5;
    const std::int64_t most = sparse ? spacing / 5 : spacing * 4 / 5;
    Placer placer(extent, sizes.size());
    for (const std::size_t k : sizes) place(rng, placer, k, extent, least, most);
    return placer.take();
}

/// The quadrilateral shrunk by 1/12 towards its centre. Its corners stay inside: a cell is at least 1024 wide.
IntRing shrunk(const IntRing& quad) {
    IntPoint sum{};
    for (const IntPoint p : quad) sum = sum + p;
    IntRing result;
    for (const IntPoint p : quad)
        result.push_back({(11 * p.x + sum.x / 4) / 12, (11 * p.y + sum.y / 4) / 12});
    return result;
}

/// A convex ring of k vertices, 3 to 8, in a convex quadrilateral: a corner dropped, or k − 4 corners cut.
IntRing cut_to(Rng& rng, const IntRing& quad, std::size_t k) {
    std::vector<std::size_t> order{0, 1, 2, 3};
    rng.shuffle(order);
    IntRing ring;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto rank =
            static_cast<std::size_t>(std::find(order.begin(), order.end(), i) - order.begin());
        const IntPoint p = quad[i];
        if (k == 3 && rank == 0) continue;
        if (k <= 4 || rank >= k - 4) {
            ring.push_back(p);
            continue;
        }
        const std::int64_t part = rng.between(3, 6);
        const IntPoint before = quad[(i + 3) % 4] - p;
        const IntPoint after = quad[(i + 1) % 4] - p;
        ring.push_back({p.x + before.x / part, p.y + before.y / part});
        ring.push_back({p.x + after.x / part, p.y + after.y / part});
    }
    return ring;
}

/// One body in each cell of a square lattice whose points have been moved by up to 1/5 of the spacing:
/// below 1/4 all cells are strictly convex.
std::vector<IntRing> packed(Rng& rng, const std::vector<std::size_t>& sizes, std::int64_t extent) {
    const std::int64_t side = ceil_sqrt(sizes.size());
    const std::int64_t spacing = extent / side;
    IntRing lattice;
    for (std::int64_t y = 0; y <= side; ++y) {
        for (std::int64_t x = 0; x <= side; ++x) {
            const auto moved = [&](std::int64_t i) {
                const std::int64_t by = rng.between(-spacing / 5, spacing / 5);
                return std::clamp<std::int64_t>(i * spacing + by, 0, extent);
            };
            lattice.push_back({moved(x), moved(y)});
        }
    }
    std::vector<IntRing> rings;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::size_t columns = static_cast<std::size_t>(side);
        const std::size_t corner = i / columns * (columns + 1) + i % columns;
        const IntRing cell{lattice[corner], lattice[corner + 1], lattice[corner + columns + 2],
                           lattice[corner + columns + 1]};
        rings.push_back(cut_to(rng, shrunk(cell), sizes[i]));
    }
    return rings;
}

}  // namespace

SceneInput2 random_convex(const ConvexBodies& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.vertices >= 3 && parameters.vertices <= 10'000'000);
    Rng rng(seed);
    const std::vector<std::size_t> sizes = split_vertices(rng, parameters.vertices);
    const std::int64_t extent = extent_for(sizes.size());
    const std::vector<IntRing> rings = parameters.density == Density::packed
                                           ? packed(rng, sizes, extent)
                                           : scattered(rng, sizes, extent, parameters.density);
    SceneInput2 scene;
    scene.world = parameters.world;
    if (!parameters.world) {
        for (const IntRing& ring : rings) scene.elements.emplace_back(to_polygon(ring));
        return scene;
    }
    Polygon2 world = to_polygon(world_ring(extent));
    for (const IntRing& ring : rings) world.holes.push_back(to_ring(ring));
    scene.elements.emplace_back(std::move(world));
    return scene;
}

SceneInput2 scaled_convex(const ScaledConvex& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.exponent >= -1074 && parameters.exponent <= 990);
    SceneInput2 scene = random_convex({.vertices = parameters.vertices}, seed);
    const auto scale = [&](Ring2& ring) {
        for (Point2& p : ring)
            p = {std::ldexp(p.x, parameters.exponent), std::ldexp(p.y, parameters.exponent)};
    };
    auto& world = std::get<Polygon2>(scene.elements.front());
    scale(world.outer);
    for (Ring2& hole : world.holes) scale(hole);
    return scene;
}

SceneInput2 needles(const Needles& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 1'000'000);
    Rng rng(seed);
    const std::int64_t side = ceil_sqrt(parameters.count);
    const std::int64_t extent = std::max<std::int64_t>(std::int64_t{1} << 20, side * 16384);
    Placer placer(extent, parameters.count);
    std::int64_t length = std::min(extent / side * 3 / 2, extent / 2);
    for (std::size_t placed = 0; placed < parameters.count;) {
        const IntPoint foot{rng.between(0, extent), rng.between(0, extent)};
        const IntPoint reach{rng.between(-length, length), rng.between(-length, length)};
        const IntPoint tip = foot + reach;
        const IntPoint side_step = std::abs(reach.x) < std::abs(reach.y)
                                       ? IntPoint{reach.y > 0 ? -1 : 1, 0}
                                       : IntPoint{0, reach.x > 0 ? 1 : -1};
        const IntRing ring{foot, tip, foot + side_step};
        const bool long_enough = std::max(std::abs(reach.x), std::abs(reach.y)) > length / 4;
        if (long_enough && placer.try_add(ring)) {
            ++placed;
            length = std::min(extent / side * 3 / 2, extent / 2);
        } else if (length > 4096) {
            length = length * 31 / 32;
        }
    }
    SceneInput2 scene;
    for (const IntRing& ring : placer.take()) scene.elements.emplace_back(to_polygon(ring));
    return scene;
}

}  // namespace sightline::families
