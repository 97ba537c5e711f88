// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/free_bitangents.hpp"

#include "event/contacts.hpp"

namespace sightline {

// First the side at the source of each arc, row by row. Then the arcs themselves: as the rows
// ascend, the arcs back to a vertex come in the order of its own row, so a counter a row finds the
// other side and nothing is searched or sorted.
std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                           const VisibilityGraph& tangent_graph,
                                           const FreeBitangentOptions& options) {
    SIGHTLINE_EXPECT(tangent_graph.vertex_count() == scene.vertex_count());
    const detail::Contacts contacts(scene);
    const auto n = static_cast<std::uint32_t>(scene.vertex_count());
    std::vector<Side> sides;
    sides.reserve(2 * tangent_graph.edge_count());
    std::vector<std::size_t> next;
    next.reserve(n);
    for (VertexId v{0}; v.value < n; ++v.value) {
        next.push_back(sides.size());
        for (const VertexId w : tangent_graph.neighbours(v))
            sides.push_back(contacts.side(scene[v], scene[w], v));
    }
    std::vector<FreeBitangent> found;
    found.reserve(sides.size());
    auto side = sides.begin();
    for (VertexId v{0}; v.value < n; ++v.value) {
        for (const VertexId w : tangent_graph.neighbours(v)) {
            const Side at_source = *side++;
            const Side at_target = reversed(sides[next[w.index()]++]);
            if (!options.one_body && contacts.owner(v) == contacts.owner(w)) continue;
            found.push_back({contacts.body(v), contacts.body(w), at_source, at_target, v, w});
        }
    }
    return found;
}

Result<std::vector<FreeBitangent>> free_bitangents(const Scene2& scene,
                                                   const FreeBitangentOptions& options,
                                                   const Limits& limits) {
    const auto graph = visibility_graph(scene,
                                        {.tangent_only = true,
                                         .arithmetic = options.arithmetic,
                                         .threads = options.threads,
                                         .tally = options.tally},
                                        limits);
    if (!graph) return tl::unexpected<Error>(graph.error());
    return free_bitangents(scene, *graph, options);
}

std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                           const FreeBitangentOptions& options) {
    return *free_bitangents(scene, options, Limits{});
}

}  // namespace sightline
