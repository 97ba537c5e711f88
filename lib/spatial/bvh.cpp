// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sightline/scene/result.hpp"

namespace sightline {
namespace {

// Below this depth the heuristic may split as it likes; from here on halves are equal, and 2^32
// primitives are used up before max_depth.
constexpr std::uint32_t free_depth = 30;
constexpr std::size_t bin_count = 16;

// Halving first: the sum of two large coordinates could overflow.
double middle(const Box3& box, std::size_t axis) { return box.low[axis] / 2 + box.high[axis] / 2; }
double half_width(const Box3& box, std::size_t axis) {
    return box.high[axis] / 2 - box.low[axis] / 2;
}

struct Bin {
    Box3 box;
    std::uint32_t count = 0;
};

struct Split {
    std::size_t axis = 0;
    std::size_t bin = 0;  // bins up to this one go to the first child
    double cost = Box3::infinite;
};

class Builder {
public:
    Builder(std::span<const Box3> boxes, std::vector<std::uint32_t>& order,
            std::vector<Bvh::Node>& nodes)
        : boxes_(boxes), order_(order), nodes_(nodes) {}

    void build(std::uint32_t first, std::uint32_t last, std::uint32_t depth) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        Box3 middles;
        Box3 box;
        for (std::uint32_t i = first; i < last; ++i) {
            const Box3& b = boxes_[order_[i]];
            box.include(b);
            middles.include(Point3{middle(b, 0), middle(b, 1), middle(b, 2)});
        }
        nodes_[index].box = box;
        if (last - first <= Bvh::leaf_size) {
            nodes_[index].next = first;
            nodes_[index].count = last - first;
            return;
        }
        const std::uint32_t cut = divide(first, last, depth, box, middles);
        build(first, cut, depth + 1);
        nodes_[index].next = static_cast<std::uint32_t>(nodes_.size());
        build(cut, last, depth + 1);
    }

private:
    std::uint32_t divide(std::uint32_t first, std::uint32_t last, std::uint32_t depth,
                         const Box3& box, const Box3& middles) {
        if (depth < free_depth) {
            const Split split = best_split(first, last, box, middles);
            if (split.cost < Box3::infinite) {
                const auto cut = std::partition(
                    order_.begin() + first, order_.begin() + last, [&](std::uint32_t i) {
                        return bin_of(boxes_[i], middles, split.axis) <= split.bin;
                    });
                return static_cast<std::uint32_t>(cut - order_.begin());
            }
        }
        return median(first, last, middles);
    }

    std::uint32_t median(std::uint32_t first, std::uint32_t last, const Box3& middles) {
        std::size_t axis = 0;
        for (const std::size_t other : {std::size_t{1}, std::size_t{2}}) {
            if (half_width(middles, other) > half_width(middles, axis)) axis = other;
        }
        const std::uint32_t cut = first + (last - first) / 2;
        const auto key = [&](std::uint32_t i) { return std::pair{middle(boxes_[i], axis), i}; };
        std::nth_element(order_.begin() + first, order_.begin() + cut, order_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        return cut;
    }

    // Rounded: which bin a box falls in decides the shape of the tree, not what it contains.
    static std::size_t bin_of(const Box3& box, const Box3& middles, std::size_t axis) {
        const double offset = middle(box, axis) / 2 - middles.low[axis] / 2;
        const double share = offset / half_width(middles, axis);
        return std::min(static_cast<std::size_t>(share * bin_count), bin_count - 1);
    }

    Split best_split(std::uint32_t first, std::uint32_t last, const Box3& box,
                     const Box3& middles) const {
        Split best;
        const double scale = std::max({half_width(box, 0), half_width(box, 1), half_width(box, 2)});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // Nothing to divide by where all middles, rounded, are one.
            if (!(half_width(middles, axis) > scale * 0x1p-40)) continue;
            std::array<Bin, bin_count> bins;
            for (std::uint32_t i = first; i < last; ++i) {
                Bin& bin = bins[bin_of(boxes_[order_[i]], middles, axis)];
                bin.box.include(boxes_[order_[i]]);
                ++bin.count;
            }
            try_cuts(bins, axis, scale, best);
        }
        return best;
    }

    // A box's surface, relative to the node's size so that nothing overflows.
    static double surface(const Box3& box, double scale) {
        const double x = half_width(box, 0) / scale;
        const double y = half_width(box, 1) / scale;
        const double z = half_width(box, 2) / scale;
        return x * y + y * z + z * x;
    }

    static void try_cuts(const std::array<Bin, bin_count>& bins, std::size_t axis, double scale,
                         Split& best) {
        std::array<double, bin_count> behind{};
        Bin sum;
        for (std::size_t b = bin_count - 1; b > 0; --b) {
            sum.box.include(bins[b].box);
            sum.count += bins[b].count;
            behind[b - 1] = sum.count == 0 ? Box3::infinite : surface(sum.box, scale) * sum.count;
        }
        sum = {};
        for (std::size_t b = 0; b + 1 < bin_count; ++b) {
            sum.box.include(bins[b].box);
            sum.count += bins[b].count;
            if (sum.count == 0) continue;
            const double cost = surface(sum.box, scale) * sum.count + behind[b];
            if (cost < best.cost) best = {axis, b, cost};
        }
    }

    std::span<const Box3> boxes_;
    std::vector<std::uint32_t>& order_;
    std::vector<Bvh::Node>& nodes_;
};

bool is_finite(const Box3& box) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(box.low[i]) || !std::isfinite(box.high[i])) return false;
        if (box.low[i] > box.high[i]) return false;
    }
    return true;
}

}  // namespace

Bvh::Bvh(std::span<const Box3> boxes) : order_(boxes.size()) {
    SIGHTLINE_EXPECT(boxes.size() < std::numeric_limits<std::uint32_t>::max() / 2);
    SIGHTLINE_EXPECT(std::all_of(boxes.begin(), boxes.end(), is_finite));
    if (boxes.empty()) return;
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(boxes.size());
    Builder(boxes, order_, nodes_).build(0, static_cast<std::uint32_t>(boxes.size()), 0);
}

}  // namespace sightline
