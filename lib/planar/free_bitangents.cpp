// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/free_bitangents.hpp"

#include <algorithm>

#include "event/contacts.hpp"

namespace sightline {

// Vertices in ascending order, each with its greater neighbours: the reversed bitangents then come to
// their rows in ascending order, too, and nothing has to be sorted.
std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                           const VisibilityGraph& tangent_graph,
                                           const FreeBitangentOptions& options) {
    SIGHTLINE_EXPECT(tangent_graph.vertex_count() == scene.vertex_count());
    const detail::Contacts contacts(scene);
    const auto n = static_cast<std::uint32_t>(scene.vertex_count());
    std::vector<std::size_t> next(n + 1, 0);
    for (std::uint32_t v = 0; v < n; ++v)
        next[v + 1] = next[v] + tangent_graph.neighbours({v}).size();
    std::vector<FreeBitangent> found(next[n]);
    for (VertexId v{0}; v.value < n; ++v.value) {
        const auto row = tangent_graph.neighbours(v);
        for (auto w = std::upper_bound(row.begin(), row.end(), v); w != row.end(); ++w) {
            const Bitangent b = contacts.bitangent(v, *w);
            found[next[v.index()]++] = b;
            found[next[w->index()]++] = reversed(b);
        }
    }
    if (!options.one_body) {
        std::erase_if(found, [&](const Bitangent& b) {
            return contacts.owner(b.source) == contacts.owner(b.target);
        });
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
