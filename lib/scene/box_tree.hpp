// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "sightline/geom/polygon2.hpp"

namespace sightline::detail {

/// A closed axis-parallel box.
struct Box2 {
    Point2 low;
    Point2 high;

    [[nodiscard]] static Box2 of(const Point2& a, const Point2& b) {
        return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
    }
    void include(const Box2& other) {
        low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
        high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    [[nodiscard]] bool meets(const Box2& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y;
    }
};

/// A static tree over boxes, split at medians; only min and max of doubles, so
/// exact.
class BoxTree {
public:
    explicit BoxTree(std::span<const Box2> boxes) : boxes_(boxes), order_(boxes.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
    }

    /// Calls visit(index) for each box that meets `box`, after asking
    /// `may_meet(tree box)` on the way.
    template <typename MayMeet, typename Visit>
    void query(const Box2& box, const MayMeet& may_meet, const Visit& visit) const {
        std::vector<std::uint32_t> stack;
        if (!nodes_.empty()) stack.push_back(0);
        while (!stack.empty()) {
            const Node& node = nodes_[stack.back()];
            stack.pop_back();
            if (!node.box.meets(box) || !may_meet(node.box)) continue;
            if (node.right != 0) {
                stack.push_back(node.right);
                stack.push_back(static_cast<std::uint32_t>(&node - nodes_.data()) + 1);
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                if (boxes_[order_[i]].meets(box)) visit(order_[i]);
            }
        }
    }

private:
    static constexpr std::uint32_t leaf_size = 8;
    struct Node {
        Box2 box;
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        std::uint32_t right = 0;  ///< 0 in leaves; the left child follows its parent
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({boxes_[order_[first]], first, last, 0});
        Box2 box = nodes_[index].box;
        for (std::uint32_t i = first; i < last; ++i) box.include(boxes_[order_[i]]);
        nodes_[index].box = box;
        if (last - first <= leaf_size) return index;
        const std::uint32_t middle = first + (last - first) / 2;
        // Halving first: the sum of two large coordinates could overflow.
        const bool wide = box.high.x / 2 - box.low.x / 2 > box.high.y / 2 - box.low.y / 2;
        const auto key = [&](std::uint32_t i) {
            return wide ? boxes_[i].low.x / 2 + boxes_[i].high.x / 2
                        : boxes_[i].low.y / 2 + boxes_[i].high.y / 2;
        };
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        build(first, middle);
        const std::uint32_t right = build(middle, last);
        nodes_[index].right = right;
        return index;
    }

    std::span<const Box2> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace sightline::detail
