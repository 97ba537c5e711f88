// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "sightline/scene/families.hpp"
#include "sightline/scene/locate2.hpp"

namespace sightline::experiments {
namespace {

using families::Density;

std::size_t side_of(double area) {
    return std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(std::sqrt(area))));
}

std::size_t vertices_of(const SceneInput2& input) {
    return Scene2::make(input).value().vertex_count();
}

// A square plan with about n vertices, where only generating it tells how many it has.
SceneInput2 plan(std::size_t n, const std::function<SceneInput2(std::size_t)>& of_side) {
    std::size_t side = side_of(static_cast<double>(n));
    for (int i = 0; i < 2; ++i) {
        const double found = static_cast<double>(vertices_of(of_side(side)));
        side = std::max<std::size_t>(
            4, static_cast<std::size_t>(std::lround(static_cast<double>(side) *
                                                    std::sqrt(static_cast<double>(n) / found))));
    }
    return of_side(side);
}

SceneInput2 convex(std::size_t n, Density density, std::uint64_t seed) {
    return families::random_convex({.vertices = n, .density = density, .world = true}, seed);
}

}  // namespace

SceneInput2 family_scene(std::string_view family, std::size_t n, std::uint64_t seed) {
    const std::size_t side = side_of(static_cast<double>(n) / 4);
    if (family == "dense") return convex(n, Density::dense, seed);
    if (family == "sparse") return convex(n, Density::sparse, seed);
    if (family == "packed") return convex(n, Density::packed, seed);
    if (family == "grid") return families::grid({side, side}, seed);
    if (family == "rotated_grid") return families::rotated_grid({side, side, 3, 4}, seed);
    if (family == "needles") return families::needles({std::max<std::size_t>(1, n / 3)}, seed);
    if (family == "floor_plan") {
        return plan(n, [&](std::size_t s) { return families::floor_plan({s, s, true}, seed); });
    }
    if (family == "cave") {
        return plan(n, [&](std::size_t s) { return families::cave({s, s}, seed); });
    }
    throw std::invalid_argument("no family " + std::string(family));
}

std::vector<Point2> free_points(const Scene2& scene, std::size_t count, std::uint64_t seed) {
    Point2 low = scene.vertices().front();
    Point2 high = low;
    for (const Point2& p : scene.vertices()) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    std::mt19937_64 random(seed);
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random() >> 11U) * 0x1p-53);
    };
    std::vector<Point2> points;
    while (points.size() < count) {
        const Point2 p{between(low.x, high.x), between(low.y, high.y)};
        if (locate(scene, p).kind == PlaceKind2::free) points.push_back(p);
    }
    return points;
}

}  // namespace sightline::experiments
