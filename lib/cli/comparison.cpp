// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/comparison.hpp"

#include <algorithm>
#include <iterator>

namespace sightline::detail {

std::vector<VertexId> sampled_vertices(std::size_t n, std::size_t count) {
    count = std::min(n, count);
    std::vector<VertexId> chosen;
    chosen.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        chosen.push_back(VertexId{static_cast<std::uint32_t>(i * n / count)});
    }
    return chosen;
}

void compare_row(const VisibilityGraph& graph, VertexId v, const std::vector<VertexId>& right,
                 GraphComparison& comparison) {
    constexpr std::size_t enough = 8;
    const auto row = graph.neighbours(v);
    const auto note = [v](const std::vector<VertexId>& others, std::size_t& count,
                          std::vector<VisibilityGraph::Edge>& some) {
        count += others.size();
        for (const VertexId w : others) {
            if (some.size() < enough) some.emplace_back(std::min(v, w), std::max(v, w));
        }
    };
    std::vector<VertexId> others;
    std::set_difference(row.begin(), row.end(), right.begin(), right.end(),
                        std::back_inserter(others));
    note(others, comparison.false_count, comparison.false_some);
    others.clear();
    std::set_difference(right.begin(), right.end(), row.begin(), row.end(),
                        std::back_inserter(others));
    note(others, comparison.missed_count, comparison.missed_some);
    ++comparison.rows;
    comparison.edges += right.size();
}

}  // namespace sightline::detail
