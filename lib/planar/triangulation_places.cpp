// SPDX-License-Identifier: GPL-3.0-or-later
// Places of a triangulation: the frame, and the scene's distinct vertex positions along a Hilbert curve.
#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>

#include "planar/triangulation_builder.hpp"

namespace sightline::detail {
namespace {

struct Box {
    double x0, y0, x1, y1;
};

void extend(Box& b, std::span<const Point2> points) {
    for (const Point2& p : points) {
        b.x0 = std::min(b.x0, p.x);
        b.x1 = std::max(b.x1, p.x);
        b.y0 = std::min(b.y0, p.y);
        b.y1 = std::max(b.y1, p.y);
    }
}

Box bounding_box(std::span<const Point2> points, std::span<const Point2> more = {}) {
    const Point2& p = points.empty() ? more[0] : points[0];
    Box b{p.x, p.y, p.x, p.y};
    extend(b, points);
    extend(b, more);
    return b;
}

// Position of (x, y), 16 bits each, along a Hilbert curve.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
    std::uint32_t key = 0;
    for (std::uint32_t s = 1U << 15U; s != 0; s >>= 1U) {
        const std::uint32_t rx = (x & s) != 0 ? 1 : 0;
        const std::uint32_t ry = (y & s) != 0 ? 1 : 0;
        key = (key << 2U) | ((3 * rx) ^ ry);
        if (ry == 0) {
            if (rx == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return key;
}

// Sorts by the upper 32 bits, stably: three passes of 11, 11 and 10 bits.
void sort_by_key(std::vector<std::uint64_t>& entries) {
    std::vector<std::uint64_t> other(entries.size());
    for (int shift = 32; shift < 64; shift += 11) {
        std::array<std::uint32_t, 2049> first{};
        const auto digit = [shift](std::uint64_t entry) { return entry >> shift & 2047U; };
        for (const std::uint64_t entry : entries) ++first[digit(entry) + 1];
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        for (const std::uint64_t entry : entries) other[first[digit(entry)]++] = entry;
        entries.swap(other);
    }
}

// Vertices by Hilbert key of their position; equal positions are neighbours, ids ascending.
std::vector<std::uint64_t> hilbert_order(std::span<const Point2> points, const Box& box) {
    // Scaled before subtracting: the extent of the box may overflow.
    const double width = std::max(box.x1 / 2 - box.x0 / 2, DBL_MIN);
    const double height = std::max(box.y1 / 2 - box.y0 / 2, DBL_MIN);
    std::vector<std::uint64_t> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto cell = [](double v, double low, double size) {
            return static_cast<std::uint32_t>((v / 2 - low / 2) / size * 65535.0);
        };
        const std::uint64_t key =
            hilbert_key(cell(points[i].x, box.x0, width), cell(points[i].y, box.y0, height));
        order[i] = key << 32U | i;
    }
    sort_by_key(order);
    for (std::size_t i = 0; i < order.size();) {
        std::size_t j = i + 1;
        while (j < order.size() && order[j] >> 32U == order[i] >> 32U) ++j;
        if (j - i > 1)
            std::sort(order.begin() + static_cast<std::ptrdiff_t>(i),
                      order.begin() + static_cast<std::ptrdiff_t>(j),
                      [&](std::uint64_t a, std::uint64_t b) {
                          const auto u = static_cast<std::uint32_t>(a);
                          const auto v = static_cast<std::uint32_t>(b);
                          if (points[u] == points[v]) return u < v;
                          return points[u] < points[v];
                      });
        i = j;
    }
    return order;
}

// The exponent of the lowest set bit of x, or a large number for 0.
int lowest_bit(double x) {
    if (x == 0) return 4096;
    if (std::fabs(x) < 0x1p53 && x == std::trunc(x))  // the common case, quicker
        return std::countr_zero(static_cast<std::uint64_t>(std::fabs(x)));
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const auto digits = static_cast<std::uint64_t>(std::ldexp(std::fabs(mantissa), 53));
    return exponent - 53 + std::countr_zero(digits);
}

}  // namespace

void TriangulationBuilder::make_frame() {
    const Box b = bounding_box(scene_.vertices(), within_);
    // A margin of about the scene's size, a power of two to stay on the scene's grid; and wide enough for
    // some doubles to lie in it.
    const double size = std::max({b.x1 - b.x0, b.y1 - b.y0, DBL_MIN});
    const double largest =
        std::max({std::fabs(b.x0), std::fabs(b.x1), std::fabs(b.y0), std::fabs(b.y1), DBL_MIN});
    const double margin = std::ldexp(
        1.0, std::clamp(std::max(std::ilogb(size) + 1, std::ilogb(largest) - 49), -1021, 1022));
    const auto down = [&](double v) { return v - margin; };
    const auto up = [&](double v) { return v + margin; };
    t_.position_ = {{down(b.x0), down(b.y0)},
                    {up(b.x1), down(b.y0)},
                    {up(b.x1), up(b.y1)},
                    {down(b.x0), up(b.y1)},
                    {},  // 4 and 5: split_frame
                    {}};
}

void TriangulationBuilder::make_places() {
    const std::span<const Point2> points = scene_.vertices();
    const std::vector<std::uint64_t> order = hilbert_order(points, bounding_box(points));
    t_.position_.reserve(points.size() + frame_places);
    t_.place_of_.resize(points.size());
    t_.vertices_at_.reserve(points.size());
    for (const std::uint64_t entry : order) {
        const auto v = static_cast<std::uint32_t>(entry);
        if (t_.vertices_at_.empty() || points[v] != points[t_.vertices_at_.back().index()]) {
            t_.first_vertex_.push_back(static_cast<std::uint32_t>(t_.vertices_at_.size()));
            t_.position_.push_back(points[v]);
            curve_key_.push_back(static_cast<std::uint32_t>(entry >> 32U));
        }
        t_.place_of_[v] = static_cast<Place>(t_.position_.size() - 1);
        t_.vertices_at_.push_back(VertexId{v});
    }
    t_.first_vertex_.push_back(static_cast<std::uint32_t>(t_.vertices_at_.size()));
    t_.first_constructed_ = static_cast<Place>(t_.position_.size());
}

// The frame is cut at some x strictly between the places of the two halves of the Hilbert curve, which
// are its left and right half; or, when no double lies between, at the very left with all places right.
void TriangulationBuilder::split_frame() {
    const auto left_half = [&](Place p) { return curve_key_[p - frame_places] >> 31U == 0; };
    Place first_right = frame_places;
    double left = t_.position_[0].x;
    while (first_right < t_.first_constructed_ && left_half(first_right))
        left = std::max(left, t_.position_[first_right++].x);
    double right = t_.position_[2].x;
    for (Place p = first_right; p < t_.first_constructed_; ++p)
        right = std::min(right, t_.position_[p].x);
    double cut = left / 2 + right / 2;
    if (!(left < cut && cut < right)) {
        first_right = frame_places;
        left = t_.position_[0].x;
        right = t_.position_[frame_places].x;
        for (Place p = frame_places; p < t_.first_constructed_; ++p)
            right = std::min(right, t_.position_[p].x);
        cut = left / 2 + right / 2;
    }
    first_right_ = first_right;
    t_.position_[4] = {cut, t_.position_[0].y};
    t_.position_[5] = {cut, t_.position_[2].y};
    curve_key_ = {};
}

// With M the largest coordinate difference, fl(dx·dy') has |error| ≤ 3u·M² and the subtraction adds
// u·2M²(1+3u): in all at most (8 + 32u) u M², and 2 DBL_MIN for underflow. Rounded up to 9 u M².
void TriangulationBuilder::measure_precision() {
    const Point2& low = t_.position_[0];
    const Point2& high = t_.position_[2];
    const double mx = high.x - low.x;
    const double my = high.y - low.y;
    int lowest = 4096;
    for (const Point2& p : t_.position_)
        lowest = std::min({lowest, lowest_bit(p.x), lowest_bit(p.y)});
    // Differences below 2^26 grid steps have products below 2^52 and a determinant below 2^53.
    const double steps = std::ldexp(std::max(mx, my), -lowest);
    t_.exact_grid_ = steps <= 0x1p26 && lowest > -500 && lowest < 400;
    t_.grid_step_ = t_.exact_grid_ ? std::ldexp(1.0, lowest) : 0;
    // A coordinate that was rounded once is off by u·|x|: twice that times the other factor, twice.
    const double largest =
        std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(high.x), std::fabs(high.y)});
    t_.rounded_point_bound_ = 9 * (DBL_EPSILON / 2) * (mx * my) +
                              4 * (DBL_EPSILON / 2) * largest * (mx + my) + 4 * DBL_MIN;
    t_.orientation_bound_ = t_.exact_grid_ ? 0 : 9 * (DBL_EPSILON / 2) * (mx * my) + 2 * DBL_MIN;
}

}  // namespace sightline::detail
