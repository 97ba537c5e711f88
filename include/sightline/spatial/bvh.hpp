// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/spatial/box3.hpp"

namespace sightline {

/// A bounding volume hierarchy over anything that has boxes: a binary tree of boxes, of which each
/// contains, exactly, those of its children. Primitives are numbered as their boxes were given.
///
/// Built top down by the surface area heuristic over bins, in O(n log n); at most max_depth levels
/// whatever the boxes are, so that a traversal needs no allocation. Immutable: may be traversed from
/// several threads. The same boxes give the same tree. \cite wald_2007
class Bvh {
public:
    static constexpr std::uint32_t leaf_size = 4;
    static constexpr std::uint32_t max_depth = 64;

    /// One node. Nodes stand depth first: an inner node is followed by its first child.
    struct alignas(64) Node {
        Box3 box;
        std::uint32_t next = 0;  ///< inner node: its second child; leaf: where its primitives start
        std::uint32_t count = 0;  ///< leaf: how many primitives; 0 for inner nodes
    };

    Bvh() = default;
    /// Boxes are not empty, and finite. Throws ContractViolation otherwise.
    explicit Bvh(std::span<const Box3> boxes);

    /// Visits every primitive below nodes for which `bool descend(const Box3&)` holds, in the order
    /// of the tree: `leaf(std::uint32_t primitive)`. When leaf returns bool, false ends the traversal.
    /// Returns whether the traversal came to its end. A leaf node's box is asked for, a primitive's
    /// own box is not.
    template <typename Descend, typename Leaf>
    bool traverse(const Descend& descend, const Leaf& leaf) const;

    /// Visits primitives from near to far: of two children the nearer one comes first.
    /// `double distance(const Box3&)` is a lower bound of the distance of what is in the box, infinity
    /// to leave the box out. `double leaf(std::uint32_t primitive)` returns the distance beyond which
    /// nothing more is wanted, infinity at first: nodes that are farther are skipped, nodes at
    /// just that distance are not. -infinity ends the traversal.
    template <typename Distance, typename Leaf>
    void traverse_ordered(const Distance& distance, const Leaf& leaf) const;

    [[nodiscard]] bool is_empty() const noexcept { return nodes_.empty(); }
    [[nodiscard]] std::span<const Node> nodes() const noexcept { return nodes_; }
    /// Primitives in the order of the leaves.
    [[nodiscard]] std::span<const std::uint32_t> order() const noexcept { return order_; }
    /// The box of everything.
    [[nodiscard]] Box3 bounds() const { return is_empty() ? Box3{} : nodes_.front().box; }

private:
    template <typename Leaf>
    static bool goes_on(const Leaf& leaf, std::uint32_t primitive) {
        if constexpr (std::is_void_v<std::invoke_result_t<const Leaf&, std::uint32_t>>) {
            leaf(primitive);
            return true;
        } else {
            return leaf(primitive);
        }
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

template <typename Descend, typename Leaf>
bool Bvh::traverse(const Descend& descend, const Leaf& leaf) const {
    if (nodes_.empty()) return true;
    std::array<std::uint32_t, max_depth> waiting;  // second children; left uninitialised on purpose
    std::uint32_t depth = 0;
    std::uint32_t at = 0;
    while (true) {
        const Node& node = nodes_[at];
        if (descend(node.box)) {
            if (node.count == 0) {
                waiting[depth++] = node.next;
                ++at;
                continue;
            }
            for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
                if (!goes_on(leaf, order_[i])) return false;
            }
        }
        if (depth == 0) return true;
        at = waiting[--depth];
    }
}

template <typename Distance, typename Leaf>
void Bvh::traverse_ordered(const Distance& distance, const Leaf& leaf) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (nodes_.empty()) return;
    struct Entry {
        double distance;
        std::uint32_t node;
    };
    std::array<Entry, max_depth> waiting;
    std::uint32_t depth = 0;
    double bound = infinite;
    const auto push = [&](const Entry& e) {
        if (e.distance < infinite && e.distance <= bound) waiting[depth++] = e;
    };
    push({distance(nodes_[0].box), 0});
    while (depth > 0) {
        const Entry entry = waiting[--depth];
        if (entry.distance > bound) continue;
        const Node& node = nodes_[entry.node];
        if (node.count == 0) {
            Entry near{distance(nodes_[entry.node + 1].box), entry.node + 1};
            Entry far{distance(nodes_[node.next].box), node.next};
            if (far.distance < near.distance) std::swap(near, far);
            push(far);
            push(near);
            continue;
        }
        for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
            bound = leaf(order_[i]);
            if (entry.distance > bound) break;
        }
    }
}

}  // namespace sightline
