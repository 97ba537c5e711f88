// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "sightline/geom/point.hpp"

namespace sightline::detail {

/// A closed axis-parallel box of space. The module `spatial` has a public one, but comes after this module.
struct SceneBox3 {
    std::array<double, 3> low;
    std::array<double, 3> high;

    [[nodiscard]] static SceneBox3 of(const Point3& p) {
        return {{p.x, p.y, p.z}, {p.x, p.y, p.z}};
    }
    void include(const SceneBox3& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
    [[nodiscard]] bool meets(const SceneBox3& other) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
        return true;
    }
};

/// A static tree over boxes, split at medians; only min and max of doubles, so exact.
class SceneBoxTree3 {
public:
    explicit SceneBoxTree3(std::vector<SceneBox3> boxes)
        : boxes_(std::move(boxes)), order_(boxes_.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
    }

    [[nodiscard]] const SceneBox3& box(std::uint32_t index) const { return boxes_[index]; }

    /// Calls visit(index) for each box that meets `box`.
    template <typename Visit>
    void query(const SceneBox3& box, const Visit& visit) const {
        std::array<std::uint32_t, 128> stack;  // no tree over 2^32 boxes is deeper than half of it
        std::size_t depth = 0;
        if (!nodes_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const std::uint32_t index = stack[--depth];
            const Node& node = nodes_[index];
            if (!node.box.meets(box)) continue;
            if (node.right != 0) {
                stack[depth++] = node.right;
                stack[depth++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i)
                if (boxes_[order_[i]].meets(box)) visit(order_[i]);
        }
    }

private:
    static constexpr std::uint32_t leaf_size = 4;
    struct Node {
        SceneBox3 box;
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        std::uint32_t right = 0;  ///< 0 in leaves; the left child follows its parent
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        SceneBox3 box = boxes_[order_[first]];
        for (std::uint32_t i = first; i < last; ++i) box.include(boxes_[order_[i]]);
        nodes_.push_back({box, first, last, 0});
        if (last - first <= leaf_size) return index;
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis]) axis = i;
        const std::uint32_t middle = first + (last - first) / 2;
        const auto key = [&](std::uint32_t i) {
            return boxes_[i].low[axis] + boxes_[i].high[axis];
        };
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        build(first, middle);
        const std::uint32_t right = build(middle, last);
        nodes_[index].right = right;
        return index;
    }

    std::vector<SceneBox3> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace sightline::detail
