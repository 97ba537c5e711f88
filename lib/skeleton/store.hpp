// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes and visited swaths, shared by the threads that find them. Private.

#include <array>
#include <atomic>
#include <mutex>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "skeleton/sweep.hpp"

namespace sightline::detail {

using EdgeTriple = std::array<EdgeId, 3>;

struct NodeHash {
    std::size_t operator()(const SkeletonNode& node) const noexcept;
};
struct TripleHash {
    std::size_t operator()(const EdgeTriple& t) const noexcept;
};

/// Gives equal nodes one number. Numbers have gaps and depend on the threads' luck; nothing else does.
class NodeStore {
public:
    /// The number, and whether the node is new.
    std::pair<std::uint32_t, bool> insert(SkeletonNode&& node);
    /// All nodes; afterwards numbers are translated by `rank`.
    [[nodiscard]] std::vector<SkeletonNode> take(std::vector<std::uint32_t>& rank);
    [[nodiscard]] std::size_t size() const { return size_.load(std::memory_order_relaxed); }

private:
    static constexpr std::uint32_t shard_count = 64;
    struct Shard {
        std::mutex mutex;
        std::unordered_map<SkeletonNode, std::uint32_t, NodeHash> numbers;
    };
    std::array<Shard, shard_count> shards_;
    std::atomic<std::size_t> size_ = 0;
};

/// The swaths that have been met.
class TripleStore {
public:
    /// Whether the triple is new.
    bool insert(const EdgeTriple& triple);

private:
    static constexpr std::size_t shard_count = 64;
    struct Shard {
        std::mutex mutex;
        std::unordered_set<EdgeTriple, TripleHash> triples;
    };
    std::array<Shard, shard_count> shards_;
};

}  // namespace sightline::detail
