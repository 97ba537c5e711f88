// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "sightline/viz/draw_list.hpp"

/// Rounded vectors, for drawing only.
namespace sightline::viz::detail {

[[nodiscard]] inline Position operator+(const Position& a, const Position& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline Position operator-(const Position& a, const Position& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline Position operator*(double k, const Position& a) {
    return {k * a.x, k * a.y, k * a.z};
}
[[nodiscard]] inline double dot(const Position& a, const Position& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Position cross(const Position& a, const Position& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Of length 1; zero for zero. Neither overflows nor underflows.
[[nodiscard]] inline Position unit(const Position& a) {
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
    if (!(largest > 0)) return {};
    const Position scaled{a.x / largest, a.y / largest, a.z / largest};
    return (1 / std::sqrt(dot(scaled, scaled))) * scaled;
}

}  // namespace sightline::viz::detail
