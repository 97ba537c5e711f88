// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_assembly.hpp"

namespace sightline::detail {
namespace {

struct Compressed {
    std::vector<std::uint64_t> offsets;
    std::vector<VertexId> targets;
};

std::size_t multiplicity(const Triangulation& t, Place p) { return t.vertices_at(p).size(); }

// For each place its visible places, in both directions, any order.
Compressed both_directions(const Triangulation& t, const std::vector<HalfRows>& rows) {
    Compressed c;
    c.offsets.assign(t.first_constructed() + 1, 0);
    const auto each = [&](auto&& visit) {
        for (const HalfRows& block : rows) {
            std::uint64_t i = 0;
            for (std::size_t r = 0; r < block.ends.size(); ++r)
                for (; i < block.ends[r]; ++i)
                    visit(block.first + static_cast<Place>(r), block.places[i]);
        }
    };
    each([&](Place p, Place q) {
        ++c.offsets[p + 1];
        ++c.offsets[q + 1];
    });
    for (std::size_t i = 1; i < c.offsets.size(); ++i) c.offsets[i] += c.offsets[i - 1];
    c.targets.resize(c.offsets.back());
    std::vector<std::uint64_t> at(c.offsets.begin(), c.offsets.end() - 1);
    each([&](Place p, Place q) {
        c.targets[at[p]++] = VertexId{q};
        c.targets[at[q]++] = VertexId{p};
    });
    return c;
}

}  // namespace

// Visiting the vertices in ascending order and appending each to the rows of its neighbours leaves
// every row sorted: a transposition instead of a sort.
VisibilityGraph assemble(const Triangulation& t, std::vector<HalfRows> rows) {
    Compressed by_place = both_directions(t, rows);
    rows.clear();
    rows.shrink_to_fit();
    std::size_t n = 0;
    for (Place p = frame_places; p < t.first_constructed(); ++p) n += multiplicity(t, p);
    std::vector<std::uint64_t> offsets(n + 1, 0);
    for (Place p = frame_places; p < t.first_constructed(); ++p) {
        std::uint64_t degree = by_place.offsets[p + 1] - by_place.offsets[p];
        if (t.has_shared_places()) {
            degree = 0;
            for (std::uint64_t i = by_place.offsets[p]; i < by_place.offsets[p + 1]; ++i)
                degree += multiplicity(t, by_place.targets[i].value);
        }
        for (const VertexId v : t.vertices_at(p)) offsets[v.index() + 1] = degree;
    }
    for (std::size_t i = 1; i <= n; ++i) offsets[i] += offsets[i - 1];
    std::vector<VertexId> targets(offsets[n]);
    std::vector<std::uint64_t> at(offsets.begin(), offsets.end() - 1);
    for (std::uint32_t v = 0; v < n; ++v) {
        const Place p = t.place_of(VertexId{v});
        for (std::uint64_t i = by_place.offsets[p]; i < by_place.offsets[p + 1]; ++i)
            for (const VertexId w : t.vertices_at(by_place.targets[i].value))
                targets[at[w.index()]++] = VertexId{v};
    }
    return {std::move(offsets), std::move(targets)};
}

}  // namespace sightline::detail
