// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/skeleton/visibility_skeleton.hpp"

#include <algorithm>
#include <numeric>
#include <ostream>

namespace sightline {

std::string_view name_of(NodeType type) noexcept {
    constexpr std::array names{"VV", "FvE", "VEE", "FF", "FEE", "EEEE"};
    return names[static_cast<std::size_t>(type)];
}

std::string_view name_of(ArcType type) noexcept {
    constexpr std::array names{"Fv", "EV", "FE", "EEE"};
    return names[static_cast<std::size_t>(type)];
}

namespace {

/// Sorts and removes repetitions; gives, for each old index, the new one.
template <typename T>
std::vector<std::uint32_t> canonicalise(std::vector<T>& items) {
    std::vector<std::uint32_t> order(items.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](auto a, auto b) { return items[a] < items[b]; });
    std::vector<std::uint32_t> rank(items.size());
    std::vector<T> sorted;
    sorted.reserve(items.size());
    for (const auto i : order) {
        if (sorted.empty() || sorted.back() != items[i]) sorted.push_back(std::move(items[i]));
        rank[i] = static_cast<std::uint32_t>(sorted.size() - 1);
    }
    items = std::move(sorted);
    return rank;
}

}  // namespace

VisibilitySkeleton::VisibilitySkeleton(std::vector<SkeletonNode> nodes,
                                       std::vector<SkeletonArc> arcs)
    : nodes_(std::move(nodes)), arcs_(std::move(arcs)) {
    const auto rank = canonicalise(nodes_);
    for (auto& arc : arcs_) {
        for (auto& node : arc.nodes) {
            SIGHTLINE_EXPECT(node.index() < rank.size());
            node = NodeId{rank[node.index()]};
        }
        std::ranges::sort(arc.nodes);
    }
    canonicalise(arcs_);
    first_arc_.assign(nodes_.size() + 1, 0);
    for (const auto& arc : arcs_) {
        ++first_arc_[arc.nodes[0].index() + 1];
        if (arc.nodes[1] != arc.nodes[0]) ++first_arc_[arc.nodes[1].index() + 1];
    }
    std::partial_sum(first_arc_.begin(), first_arc_.end(), first_arc_.begin());
    node_arcs_.resize(first_arc_.back());
    auto next = first_arc_;
    for (std::uint32_t a = 0; a < arcs_.size(); ++a) {
        const auto& ends = arcs_[a].nodes;
        node_arcs_[next[ends[0].index()]++] = ArcId{a};
        if (ends[1] != ends[0]) node_arcs_[next[ends[1].index()]++] = ArcId{a};
    }
}

}  // namespace sightline
