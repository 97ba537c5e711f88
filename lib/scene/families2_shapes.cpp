// SPDX-License-Identifier: GPL-3.0-or-later
// Combs, spirals, stars, pinwheels.
#include <algorithm>
#include <utility>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

namespace {

constexpr std::int64_t tooth_pitch = 8;
constexpr std::int64_t tooth_reach = 64;

/// The profile of a comb from left to right: teeth of width 3, from y = 0 up to random heights.
IntRing teeth_profile(Rng& rng, std::size_t teeth) {
    IntRing profile;
    for (std::size_t i = 0; i < teeth; ++i) {
        const std::int64_t x = static_cast<std::int64_t>(i) * tooth_pitch;
        const std::int64_t height = rng.between(tooth_reach / 2, tooth_reach);
        profile.insert(profile.end(), {{x, 0}, {x, height}, {x + 3, height}, {x + 3, 0}});
    }
    return profile;
}

/// Counter-clockwise: a back of thickness 4 below the profile.
IntRing comb_ring(Rng& rng, std::size_t teeth) {
    IntRing ring = teeth_profile(rng, teeth);
    const std::int64_t width = ring.back().x;
    ring.front().y = ring.back().y = -4;  // the back's corners
    std::reverse(ring.begin(), ring.end());
    SIGHTLINE_EXPECT(width > 0);
    return ring;
}

SceneInput2 one_ring(const IntRing& ring, bool world) {
    SceneInput2 scene;
    scene.elements.emplace_back(to_polygon(ring));
    scene.world = world;
    return scene;
}

}  // namespace

SceneInput2 comb(const Comb& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.teeth >= 1 && parameters.teeth <= 1'000'000);
    Rng rng(seed);
    return one_ring(comb_ring(rng, parameters.teeth), parameters.world);
}

SceneInput2 facing_combs(const Comb& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.teeth >= 1 && parameters.teeth <= 1'000'000);
    Rng rng(seed);
    const IntRing lower = comb_ring(rng, parameters.teeth);
    IntRing upper = comb_ring(rng, parameters.teeth);
    // Half a turn, and half a pitch aside: its teeth come down in the gaps, 1 from either neighbour.
    const std::int64_t width = static_cast<std::int64_t>(parameters.teeth - 1) * tooth_pitch + 3;
    for (IntPoint& p : upper) p = {width + 4 - p.x, tooth_reach + 8 - p.y};
    SceneInput2 scene;
    const IntRing world = box(-8, -8, width + 12, tooth_reach + 16);
    if (parameters.world) scene.elements.emplace_back(to_polygon(world));
    scene.world = parameters.world;
    scene.elements.emplace_back(to_polygon(lower));
    scene.elements.emplace_back(to_polygon(upper));
    return scene;
}

SceneInput2 spiral(const Spiral& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.corners >= 1 && parameters.corners <= 1'000'000);
    constexpr std::int64_t pitch = 4;  // of the middle line; half the width is 1
    const auto left_of = [](IntPoint d) { return IntPoint{-d.y, d.x}; };
    IntPoint at{};
    IntPoint direction{1, 0};
    IntRing left{at + left_of(direction)};
    IntRing right{at - left_of(direction)};
    for (std::size_t corner = 0; corner <= parameters.corners; ++corner) {
        const std::int64_t length = pitch * static_cast<std::int64_t>(corner / 2 + 1);
        at = at + IntPoint{direction.x * length, direction.y * length};
        const IntPoint next = left_of(direction);
        const bool last = corner == parameters.corners;
        const IntPoint aside = last ? left_of(direction) : left_of(direction) + left_of(next);
        left.push_back(at + aside);
        right.push_back(at - aside);
        direction = next;
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    const std::uint64_t image = seed % 8;
    for (IntPoint& p : right) {
        for (std::uint64_t i = 0; i < image % 4; ++i) p = left_of(p);
        if (image >= 4) p = {p.y, p.x};
    }
    return one_ring(right, parameters.world);
}

SceneInput2 star(const Star& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.spikes >= 3 && parameters.spikes <= 100'000);
    Rng rng(seed);
    // At radius ≥ 2^24 neighbouring directions stay distinct after rounding.
    const std::int64_t inner = std::int64_t{1} << 24;
    IntRing ring;
    for (std::size_t i = 0; i < parameters.spikes; ++i) {
        ring.push_back(on_circle(2 * i, 2 * parameters.spikes, rng.between(2 * inner, 8 * inner)));
        ring.push_back(on_circle(2 * i + 1, 2 * parameters.spikes, inner));
    }
    return one_ring(ring, parameters.world);
}

SceneInput2 pinwheel(const Pinwheel& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.blades >= 3 && parameters.blades <= 2000);
    Rng rng(seed);
    const std::uint64_t n = parameters.blades;
    const std::int64_t radius = std::int64_t{1} << 26;
    const auto offset = rng.below(1024);  // turns the whole wheel
    const auto direction = [&](std::uint64_t i, std::int64_t length) {
        return on_circle(1024 * i + offset, 1024 * n, length);
    };
    std::vector<IntRing> blades;  // at first segments from foot to tip, on tangents of the circle
    for (std::uint64_t i = 0; i < n; ++i) {
        const IntPoint foot = direction(i, radius);
        const IntPoint along = direction(i, rng.between(radius / 2, 3 * radius / 2));
        blades.push_back({foot, {foot.x - along.y, foot.y + along.x}});
    }
    // Then each becomes a triangle, as thick at its foot as lets all others pass.
    for (std::uint64_t i = 0; i < n; ++i) {
        const IntRing segment = blades[i];
        const auto hits = [&](const IntRing& other) {
            return &other != &blades[i] && !are_disjoint(blades[i], other);
        };
        std::int64_t thickness = radius / 4;
        do {
            SIGHTLINE_EXPECT(thickness > 0);
            blades[i] = {segment[0], direction(i, radius + thickness), segment[1]};
            thickness /= 2;
        } while (std::any_of(blades.begin(), blades.end(), hits));
    }
    SceneInput2 scene;
    for (const IntRing& blade : blades) scene.elements.emplace_back(to_polygon(blade));
    return scene;
}

}  // namespace sightline::families
