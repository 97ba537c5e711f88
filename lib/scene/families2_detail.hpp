// SPDX-License-Identifier: GPL-3.0-or-later
// What the generators share: randomness that is the same everywhere, and integer geometry.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::families::detail {

/// Random integers. The standard fixes the engine's output; its distributions it does not, hence our own.
class Rng {
public:
    explicit Rng(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, n), n > 0.
    [[nodiscard]] std::uint64_t below(std::uint64_t n) {
        const std::uint64_t excess = (UINT64_MAX % n + 1) % n;  // 2^64 mod n
        std::uint64_t word = engine_();
        while (word > UINT64_MAX - excess) word = engine_();
        return word % n;
    }
    /// Uniform in [low, high].
    [[nodiscard]] std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
    }
    [[nodiscard]] bool one_in(std::uint64_t n) { return below(n) == 0; }

    template <typename T>
    void shuffle(std::vector<T>& items) {
        for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
    }

private:
    std::mt19937_64 engine_;
};

/// A lattice point. Coordinates stay below 2^29 in size, so that `cross` is exact.
struct IntPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend auto operator<=>(const IntPoint&, const IntPoint&) = default;
    friend IntPoint operator+(IntPoint a, IntPoint b) { return {a.x + b.x, a.y + b.y}; }
    friend IntPoint operator-(IntPoint a, IntPoint b) { return {a.x - b.x, a.y - b.y}; }
};
using IntRing = std::vector<IntPoint>;

[[nodiscard]] inline std::int64_t cross(IntPoint u, IntPoint v) { return u.x * v.y - u.y * v.x; }
/// Twice the signed area of the triangle abc.
[[nodiscard]] inline std::int64_t cross(IntPoint a, IntPoint b, IntPoint c) {
    return cross(b - a, c - a);
}

[[nodiscard]] inline Point2 to_point(IntPoint p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
[[nodiscard]] Ring2 to_ring(const IntRing& ring);
[[nodiscard]] Polygon2 to_polygon(const IntRing& ring);
[[nodiscard]] Polyline2 to_wall(IntPoint source, IntPoint target);
/// Counter-clockwise.
[[nodiscard]] IntRing box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1);

/// Counter-clockwise order of directions, from (1, 0). u and v are not zero.
[[nodiscard]] bool angle_less(IntPoint u, IntPoint v);
/// Whether the ring turns left at every vertex (and so, for rings that go round once, is convex).
[[nodiscard]] bool turns_left_everywhere(const IntRing& ring);
/// Whether p lies in the interior of a counter-clockwise convex ring.
[[nodiscard]] bool strictly_inside(const IntRing& convex, IntPoint p);
/// Whether two convex rings (counter-clockwise, or two points: a segment) have no point in common.
/// Two segments on one line count as not disjoint.
[[nodiscard]] bool are_disjoint(const IntRing& a, const IntRing& b);

/// A random strictly convex counter-clockwise ring of k vertices that spans the box [0, width] × [0, height].
[[nodiscard]] IntRing random_convex_ring(Rng& rng, std::size_t k, std::int64_t width,
                                         std::int64_t height);

/// k random distinct lattice points of [0, extent]², k ≥ 3, not all on one line, joined to a simple polygon.
[[nodiscard]] IntRing random_simple_ring(Rng& rng, std::size_t k, std::int64_t extent);

/// The lattice point next to radius · (cos, sin) of k/n of a full turn. Sums and products only, no library
/// function, so it is the same everywhere.
[[nodiscard]] IntPoint on_circle(std::uint64_t k, std::uint64_t n, std::int64_t radius);

/// cos and sin of an angle in degrees, to about an ulp; the same everywhere.
struct CosSin {
    double cosine;
    double sine;
};
[[nodiscard]] CosSin approx_cos_sin(double degrees);

/// The square root of n, rounded up.
[[nodiscard]] std::int64_t ceil_sqrt(std::uint64_t n);

/// Disjoint convex rings in a square, found by a grid of their boxes.
class Placer {
public:
    /// The square is [0, extent]²; about `expected` rings will come.
    Placer(std::int64_t extent, std::size_t expected);

    /// Adds the ring unless it meets one that is already there, or leaves the square.
    bool try_add(IntRing ring);
    [[nodiscard]] std::vector<IntRing> take() { return std::move(rings_); }

private:
    struct CellRange {
        std::size_t x0, x1, y0, y1;
    };
    [[nodiscard]] CellRange cells_of(const IntRing& ring) const;
    [[nodiscard]] bool meets_any(const IntRing& ring, const CellRange& range) const;

    std::int64_t extent_;
    std::size_t side_;
    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<IntRing> rings_;
};

}  // namespace sightline::families::detail
