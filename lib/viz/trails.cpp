// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/trails.hpp"

#include <algorithm>

namespace sightline::viz::detail {
namespace {

/// The segments as a graph in compressed rows, eaten up by walking along it.
class Walk {
public:
    explicit Walk(std::vector<GridSegment> segments) {
        for (auto& [a, b] : segments) {
            if (b < a) std::swap(a, b);
        }
        std::ranges::sort(segments);
        const auto repeats = std::ranges::unique(segments);
        segments.erase(repeats.begin(), repeats.end());
        for (const auto& [a, b] : segments) nodes_.insert(nodes_.end(), {a, b});
        std::ranges::sort(nodes_);
        const auto same = std::ranges::unique(nodes_);
        nodes_.erase(same.begin(), same.end());
        build_rows(segments);
    }

    [[nodiscard]] std::vector<std::vector<GridPoint>> chains() {
        std::vector<std::vector<GridPoint>> result;
        // Odd nodes first: a chain that starts at an even node ends where it began, and would leave
        // the odd ones to many short chains.
        for (const bool odd : {true, false}) {
            for (std::size_t v = 0; v < nodes_.size(); ++v) {
                if (odd && degree_[v] % 2 == 0) continue;
                while (next_unused(v) != rows_[v + 1]) {
                    result.push_back(chain_from(v));
                    if (odd && degree_[v] % 2 == 0) break;
                }
            }
        }
        return result;
    }

private:
    struct Half {
        std::uint32_t to;
        std::uint32_t edge;
    };

    void build_rows(const std::vector<GridSegment>& segments) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        ends.reserve(segments.size());
        rows_.assign(nodes_.size() + 1, 0);
        for (const auto& [a, b] : segments) {
            ends.emplace_back(index_of(a), index_of(b));
            ++rows_[ends.back().first + 1];
            if (a != b) ++rows_[ends.back().second + 1];
        }
        for (std::size_t v = 0; v < nodes_.size(); ++v) {
            degree_.push_back(rows_[v + 1]);
            rows_[v + 1] += rows_[v];
        }
        halves_.resize(rows_.back());
        first_ = {rows_.begin(), rows_.end() - 1};
        std::vector<std::size_t> fill = first_;
        for (std::uint32_t e = 0; e < ends.size(); ++e) {
            const auto [a, b] = ends[e];
            halves_[fill[a]++] = {b, e};
            if (a != b) halves_[fill[b]++] = {a, e};
        }
        used_.assign(ends.size(), false);
    }

    [[nodiscard]] std::uint32_t index_of(const GridPoint& p) const {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(nodes_, p) - nodes_.begin());
    }

    std::size_t next_unused(std::size_t v) {
        while (first_[v] != rows_[v + 1] && used_[halves_[first_[v]].edge]) ++first_[v];
        return first_[v];
    }

    std::vector<GridPoint> chain_from(std::size_t v) {
        std::vector<GridPoint> chain{nodes_[v]};
        while (next_unused(v) != rows_[v + 1]) {
            const Half half = halves_[first_[v]];
            used_[half.edge] = true;
            --degree_[v];
            if (half.to != v) --degree_[half.to];
            v = half.to;
            chain.push_back(nodes_[v]);
        }
        return chain;
    }

    std::vector<GridPoint> nodes_;
    std::vector<std::size_t> rows_;
    std::vector<std::size_t> first_;   ///< of the halves at a node that may be unused
    std::vector<std::size_t> degree_;  ///< unused halves at a node
    std::vector<Half> halves_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<std::vector<GridPoint>> trails(std::vector<GridSegment> segments) {
    return Walk(std::move(segments)).chains();
}

}  // namespace sightline::viz::detail
