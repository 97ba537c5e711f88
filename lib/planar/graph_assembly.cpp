// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_assembly.hpp"

#include <tbb/parallel_for.h>

namespace sightline::detail {
namespace {

std::size_t multiplicity(const Triangulation& t, Place p) { return t.vertices_at(p).size(); }

// Work on [0, n) in `threads` equal parts: part(begin, end).
template <typename Part>
void in_parts(std::size_t n, unsigned threads, const Part& part) {
    if (threads <= 1) {
        part(std::size_t{0}, n);
        return;
    }
    tbb::parallel_for(0U, threads,
                      [&](unsigned i) { part(n * i / threads, n * (i + 1) / threads); });
}

template <typename Visit>
void for_each_pair(const std::vector<HalfRows>& rows, const Visit& visit) {
    for (const HalfRows& block : rows) {
        std::uint64_t i = 0;
        for (std::size_t r = 0; r < block.ends.size(); ++r)
            for (; i < block.ends[r]; ++i)
                visit(block.first + static_cast<Place>(r), block.places[i]);
    }
}

// For each place its visible places, in both directions, in any order.
class PlaceRows {
public:
    PlaceRows(std::size_t places, const std::vector<HalfRows>& rows, unsigned threads)
        : offsets_(places + 1, 0) {
        std::vector<std::uint64_t> at(places + 1, 0);
        in_parts(places, threads, [&](std::size_t begin, std::size_t end) {
            for_each_pair(rows, [&](Place p, Place q) {
                if (p >= begin && p < end) ++at[p];  // the others are another thread's
                if (q >= begin && q < end) ++at[q];
            });
        });
        for (std::size_t i = 0; i < places; ++i) offsets_[i + 1] = offsets_[i] + at[i];
        targets_.resize(offsets_.back());
        std::copy(offsets_.begin(), offsets_.end(), at.begin());
        in_parts(places, threads, [&](std::size_t begin, std::size_t end) {
            for_each_pair(rows, [&](Place p, Place q) {
                if (p >= begin && p < end) targets_[at[p]++] = q;
                if (q >= begin && q < end) targets_[at[q]++] = p;
            });
        });
    }

    [[nodiscard]] std::span<const Place> operator[](Place p) const {
        return {targets_.data() + offsets_[p], targets_.data() + offsets_[p + 1]};
    }

private:
    std::vector<std::uint64_t> offsets_;
    std::vector<Place> targets_;
};

std::vector<std::uint64_t> vertex_offsets(const Triangulation& t, const PlaceRows& rows,
                                          std::size_t n) {
    std::vector<std::uint64_t> offsets(n + 1, 0);
    for (Place p = frame_places; p < t.first_constructed(); ++p) {
        std::uint64_t degree = rows[p].size();
        if (t.has_shared_places()) {
            degree = 0;
            for (const Place q : rows[p]) degree += multiplicity(t, q);
        }
        for (const VertexId v : t.vertices_at(p)) offsets[v.index() + 1] = degree;
    }
    for (std::size_t i = 1; i <= n; ++i) offsets[i] += offsets[i - 1];
    return offsets;
}

}  // namespace

// Visiting the vertices in ascending order and appending each to the rows of its neighbours leaves
// every row sorted: a transposition instead of a sort.
VisibilityGraph assemble(const Triangulation& t, std::vector<HalfRows> rows, unsigned threads) {
    const PlaceRows by_place(t.first_constructed(), rows, threads);
    rows.clear();
    rows.shrink_to_fit();
    const std::size_t n = t.vertex_count();
    std::vector<std::uint64_t> offsets = vertex_offsets(t, by_place, n);
    std::vector<VertexId> targets(offsets[n]);
    std::vector<std::uint64_t> at(offsets.begin(), offsets.end() - 1);
    in_parts(n, threads, [&](std::size_t begin, std::size_t end) {
        for (std::uint32_t v = 0; v < n; ++v)
            for (const Place p : by_place[t.place_of(VertexId{v})])
                for (const VertexId w : t.vertices_at(p))
                    if (w.index() >= begin && w.index() < end)
                        targets[at[w.index()]++] = VertexId{v};
    });
    return {std::move(offsets), std::move(targets)};
}

}  // namespace sightline::detail
