// SPDX-License-Identifier: GPL-3.0-or-later
// On one line, exactly or but for an ulp; and sizes from 1e-300 to 1e300.
#include <cmath>
#include <limits>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

namespace {

void expect_count(const Count& parameters) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 1'000'000);
}

/// y or one of its two neighbours among the doubles.
double within_one_ulp(Rng& rng, double y) {
    const double infinity = std::numeric_limits<double>::infinity();
    switch (rng.below(3)) {
        case 0:
            return std::nextafter(y, -infinity);
        case 1:
            return std::nextafter(y, infinity);
        default:
            return y;
    }
}

/// The point at parameter t of the line of slope 24/7 through the origin, `aside` to its left (times 25).
IntPoint on_line(std::int64_t t, std::int64_t aside) {
    return {7 * t - 24 * aside, 24 * t + 7 * aside};
}

}  // namespace

SceneInput2 near_collinear(const Count& parameters, std::uint64_t seed) {
    expect_count(parameters);
    Rng rng(seed);
    SceneInput2 scene;
    Polyline2 wall;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const double x = 8.0 * static_cast<double>(i) + 1.0;
        const double tip = within_one_ulp(rng, x / 3.0 + 1.0 / 7.0);
        const double depth = static_cast<double>(rng.between(1, 8));
        const double base = rng.one_in(2) ? tip - depth : tip + depth;
        scene.elements.emplace_back(Polygon2{{{x - 1.0, base}, {x + 1.0, base}, {x, tip}}, {}});
        wall.points.push_back({x, within_one_ulp(rng, x / 3.0 + 100.0 / 7.0)});
    }
    if (wall.points.size() >= 2) scene.elements.emplace_back(std::move(wall));
    return scene;
}

SceneInput2 slivers(const Count& parameters, std::uint64_t seed) {
    expect_count(parameters);
    Rng rng(seed);
    SceneInput2 scene;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const double y = (1.0 + static_cast<double>(i)) / 3.0;
        const double left = static_cast<double>(rng.between(0, 1000)) / 7.0;
        const double right = left + static_cast<double>(rng.between(2, 100));
        const double middle = left + (right - left) / 3.0;
        const double above = std::nextafter(y, 2.0 * y);
        scene.elements.emplace_back(Polygon2{{{left, y}, {right, y}, {middle, above}}, {}});
    }
    return scene;
}

SceneInput2 collinear_bodies(const Count& parameters, std::uint64_t seed) {
    expect_count(parameters);
    Rng rng(seed);
    SceneInput2 scene;
    std::int64_t t = 0;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const std::int64_t length = rng.between(2, 6);
        const std::int64_t height = rng.one_in(2) ? rng.between(1, 9) : -rng.between(1, 9);
        const IntRing ring{on_line(t, 0), on_line(t + length, 0), on_line(t + 1, height)};
        scene.elements.emplace_back(to_polygon(ring));
        t += length + rng.between(0, 3);  // 0: touches the next one
    }
    return scene;
}

SceneInput2 collinear_points(const Count& parameters, std::uint64_t seed) {
    expect_count(parameters);
    Rng rng(seed);
    std::vector<IntPoint> points;
    std::int64_t t = 0;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        points.push_back(on_line(t, 0));
        t += rng.between(1, 9);
    }
    rng.shuffle(points);
    SceneInput2 scene;
    for (const IntPoint p : points) scene.elements.emplace_back(to_point(p));
    return scene;
}

SceneInput2 collinear_walls(const Count& parameters, std::uint64_t seed) {
    expect_count(parameters);
    Rng rng(seed);
    SceneInput2 scene;
    std::int64_t t = 0;
    for (std::size_t i = 0; i < parameters.count; ++i) {
        const std::int64_t length = rng.between(1, 9);
        scene.elements.emplace_back(to_wall(on_line(t, 0), on_line(t + length, 0)));
        t += length + rng.between(0, 3);
    }
    return scene;
}

SceneInput2 magnitudes(const Count& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 1000);
    Rng rng(seed);
    SceneInput2 scene;
    const auto count = static_cast<int>(parameters.count);
    for (int i = 0; i < count; ++i) {
        const int exponent = 2 * i - count;  // the triangle spans x from 2^exponent to twice that
        const auto at = [&](std::int64_t x, std::int64_t y) {
            return Point2{std::ldexp(static_cast<double>(x), exponent - 8),
                          std::ldexp(static_cast<double>(y), exponent - 8)};
        };
        const std::int64_t low = rng.between(-256, 255);
        const std::int64_t high = rng.between(low + 1, 256);
        const std::int64_t middle = rng.between(257, 511);
        const bool upright = rng.one_in(2);
        const Ring2 ring = upright ? Ring2{at(256, low), at(512, low), at(middle, high)}
                                   : Ring2{at(256, high), at(middle, low), at(512, high)};
        scene.elements.emplace_back(Polygon2{ring, {}});
    }
    return scene;
}

}  // namespace sightline::families
