// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_assembly.hpp"
#include "planar/graph_rows.hpp"
#include "sightline/planar/visibility_graph.hpp"

namespace sightline {

Result<VisibilityGraph> visibility_graph(const Scene2& scene, const VisibilityGraphOptions& options,
                                         const Limits& limits) {
    using namespace detail;
    static_cast<void>(limits);
    const Triangulation t(scene);
    const Crossings crossings(t);
    GraphRows rows(t, crossings, options);
    HalfRows all{frame_places, {}, {}};
    for (Place p = frame_places; p < t.first_constructed(); ++p) {
        rows.append(p, all.places);
        all.ends.push_back(all.places.size());
    }
    if (options.tally != nullptr) rows.add_to(*options.tally);
    std::vector<HalfRows> blocks;
    blocks.push_back(std::move(all));
    return assemble(t, std::move(blocks));
}

VisibilityGraph visibility_graph(const Scene2& scene, const VisibilityGraphOptions& options) {
    return *visibility_graph(scene, options, Limits{});
}

}  // namespace sightline
