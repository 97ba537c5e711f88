// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/store.hpp"

namespace sightline::detail {

namespace {

constexpr std::uint64_t mix(std::uint64_t h, std::uint64_t x) {
    h = (h ^ x) * 0x9e3779b97f4a7c15U;
    return h ^ (h >> 29U);
}

}  // namespace

std::size_t NodeHash::operator()(const SkeletonNode& node) const noexcept {
    std::uint64_t h = static_cast<std::uint64_t>(node.root);
    for (const VertexId v : node.label.support.vertices) h = mix(h, v.value);
    h = mix(h, 1U << 31U);
    for (const EdgeId e : node.label.support.edges) h = mix(h, e.value);
    for (const auto& end : node.label.ends) {
        h = mix(h, 1U << 30U);
        for (const FaceSide& side : end) h = mix(h, side.face.value);
    }
    return h;
}

std::size_t TripleHash::operator()(const EdgeTriple& t) const noexcept {
    return mix(mix(mix(0, t[0].value), t[1].value), t[2].value);
}

std::pair<std::uint32_t, bool> NodeStore::insert(SkeletonNode&& node) {
    const auto which = static_cast<std::uint32_t>(NodeHash{}(node) >> 40U) % shard_count;
    Shard& shard = shards_[which];
    const std::scoped_lock lock(shard.mutex);
    const auto next = static_cast<std::uint32_t>(shard.numbers.size()) * shard_count + which;
    const auto [known, is_new] = shard.numbers.try_emplace(std::move(node), next);
    if (is_new) size_.fetch_add(1, std::memory_order_relaxed);
    return {known->second, is_new};
}

std::vector<SkeletonNode> NodeStore::take(std::vector<std::uint32_t>& rank) {
    std::vector<SkeletonNode> nodes;
    nodes.reserve(size());
    for (Shard& shard : shards_) {
        while (!shard.numbers.empty()) {
            auto entry = shard.numbers.extract(shard.numbers.begin());
            if (entry.mapped() >= rank.size()) rank.resize(entry.mapped() + 1);
            rank[entry.mapped()] = static_cast<std::uint32_t>(nodes.size());
            nodes.push_back(std::move(entry.key()));
        }
    }
    return nodes;
}

bool TripleStore::insert(const EdgeTriple& triple) {
    Shard& shard = shards_[(TripleHash{}(triple) >> 40U) % shard_count];
    const std::scoped_lock lock(shard.mutex);
    return shard.triples.insert(triple).second;
}

}  // namespace sightline::detail
