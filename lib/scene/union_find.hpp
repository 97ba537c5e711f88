// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Disjoint sets of numbers. Private.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace sightline::detail {

/// Disjoint sets of 0 … n - 1; the least member is a set's root.
class UnionFind {
public:
    explicit UnionFind(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    [[nodiscard]] std::uint32_t root(std::uint32_t x) {
        while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
        return x;
    }
    void join(std::uint32_t x, std::uint32_t y) {
        x = root(x);
        y = root(y);
        parent_[std::max(x, y)] = std::min(x, y);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace sightline::detail
