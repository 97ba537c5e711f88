// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A ray between double points against boxes and triangles, in doubles with error bounds: the inner loop of
/// shooting. Private.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sightline/geom/point.hpp"
#include "sightline/spatial/box3.hpp"

namespace sightline::detail {

/// Coordinates up to this size neither overflow nor underflow here in a way that the bounds don't cover.
constexpr double largest_filtered = 0x1p300;

/// p + t (q - p) for t from 0 to 1, or to infinity.
class Ray {
public:
    Ray(const Point3& p, const Point3& q, bool is_segment)
        : p_{p.x, p.y, p.z},
          d_{q.x - p.x, q.y - p.y, q.z - p.z},
          reach_(is_segment ? 1 : Box3::infinite) {
        for (std::size_t i = 0; i < 3; ++i) {
            // A direction too small to divide by excludes nothing, like NaN: all comparisons with it fail.
            const bool small = std::abs(d_[i]) < 0x1p-1000;
            inverse_[i] = small ? std::numeric_limits<double>::quiet_NaN() : 1 / d_[i];
        }
        size_ = std::max({std::abs(d_[0]), std::abs(d_[1]), std::abs(d_[2])});
    }

    [[nodiscard]] const std::array<double, 3>& source() const { return p_; }
    [[nodiscard]] const std::array<double, 3>& direction() const { return d_; }
    /// The largest coordinate of the direction.
    [[nodiscard]] double size() const { return size_; }
    [[nodiscard]] double reach() const { return reach_; }

    /// A lower bound of t where the ray enters the box; infinity only when it misses it.
    /// Each t is the result of four rounded operations: (1 + 2^-53)^4 < 1 + 2^-50.
    [[nodiscard]] double enters(const Box3& box) const {
        double near = 0;
        double far = reach_;
        for (std::size_t i = 0; i < 3; ++i) {
            // Differences of doubles vanish only when exactly zero.
            if (d_[i] == 0 && (p_[i] < box.low[i] || box.high[i] < p_[i])) return Box3::infinite;
            const double a = (box.low[i] - p_[i]) * inverse_[i];
            const double b = (box.high[i] - p_[i]) * inverse_[i];
            const double first = d_[i] > 0 ? a : b;
            const double last = d_[i] > 0 ? b : a;
            if (first > near) near = first;
            if (last < far) far = last;
        }
        const double bound = near * (1 - 0x1p-48) - std::numeric_limits<double>::min();
        return bound <= far * (1 + 0x1p-48) ? std::max(bound, 0.0) : Box3::infinite;
    }

private:
    std::array<double, 3> p_;
    std::array<double, 3> d_;
    std::array<double, 3> inverse_;
    double size_;
    double reach_;
};

using Corners = std::array<std::array<double, 3>, 3>;

/// How a ray passes a triangle, as far as doubles can tell.
struct Passage {
    enum class Kind : std::uint8_t {
        misses,   ///< certainly
        crosses,  ///< certainly the inside of the triangle, strictly between its ends
        unsure,
    };
    Kind kind = Kind::misses;
    /// When crossing: bounds of t.
    double low = 0;
    double high = 0;
};

inline double determinant_of(const std::array<double, 3>& u, const std::array<double, 3>& v,
                             const std::array<double, 3>& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Bounds: with corners relative to the source, none larger than M, and the direction no larger than D,
/// each a rounded difference, a determinant of two corners and the direction has six terms of at
/// most D M², each the result of at most 10 roundings on its way: it errs by less than
/// 6 · 10.1 · 2^-53 D M² < 2^-47 D M². What underflows is below 2^-1074 · 2^602 times a few.
/// `certified` false: no bounds, all signs as they come out.
template <bool certified>
[[nodiscard]] inline Passage pass(const Ray& ray, const Corners& corners) {
    std::array<std::array<double, 3>, 3> c;
    double m = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            c[k][i] = corners[k][i] - ray.source()[i];
            if constexpr (certified) m = std::max(m, std::abs(c[k][i]));
        }
    }
    const auto& d = ray.direction();
    const double error = certified ? 0x1p-47 * ray.size() * m * m + 0x1p-400 : 0;
    const double x = determinant_of(d, c[1], c[2]);
    const double y = determinant_of(d, c[2], c[0]);
    const double z = determinant_of(d, c[0], c[1]);
    const double low = std::min({x, y, z});
    const double high = std::max({x, y, z});
    if (low < -error && high > error) return {};
    if (!(low > error) && !(high < -error)) {
        return {certified ? Passage::Kind::unsure : Passage::Kind::misses};
    }
    // Normal times direction, of the sign of its terms; and normal times (corner - source).
    const double across = std::abs(x + y + z);
    const double height =
        low > 0 ? determinant_of(c[0], c[1], c[2]) : -determinant_of(c[0], c[1], c[2]);
    const double height_error = certified ? 0x1p-47 * m * m * m + 0x1p-400 : 0;
    if (height < -height_error) return {};
    const double across_error = certified ? 3 * error + across * 0x1p-50 : 0;
    constexpr double slack = certified ? 0x1p-50 : 0;
    const double least = (height - height_error) / (across + across_error) * (1 - slack);
    if (least > ray.reach()) return {};
    const double most = (height + height_error) / (across - across_error) * (1 + slack);
    if constexpr (certified) {
        const bool is_sure = height > height_error && across > across_error && most < ray.reach();
        if (!is_sure) return {Passage::Kind::unsure};
    }
    return {Passage::Kind::crosses, least, most};
}

}  // namespace sightline::detail
