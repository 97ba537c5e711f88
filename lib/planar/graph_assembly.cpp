// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_assembly.hpp"

#include <tbb/parallel_for.h>

#include <memory>
#include <utility>

namespace sightline::detail {
namespace {

// Work on [0, n) in `threads` equal parts: part(i, begin, end).
template <typename Part>
void in_parts(std::size_t n, unsigned threads, const Part& part) {
    if (threads <= 1) {
        part(std::size_t{0}, std::size_t{0}, n);
        return;
    }
    tbb::parallel_for(0U, threads,
                      [&](unsigned i) { part(i, n * i / threads, n * (i + 1) / threads); });
}

template <typename Visit>
void for_each_pair(std::span<const HalfRows> rows, const Visit& visit) {
    for (const HalfRows& block : rows) {
        std::uint64_t i = 0;
        for (std::size_t r = 0; r < block.ends.size(); ++r)
            for (; i < block.ends[r]; ++i)
                visit(block.first + static_cast<Place>(r), block.places[i]);
    }
}

// Where each part writes into the rows of a table: one cursor a row and part, so that the parts of the
// input can be distributed at once and nobody reads what another part distributes.
class Cursors {
public:
    Cursors(unsigned parts, std::size_t rows) : at_(parts, std::vector<std::uint64_t>(rows, 0)) {}

    /// First the part counts its entries a row, …
    [[nodiscard]] std::uint64_t& operator()(std::size_t part, std::size_t row) {
        return at_[part][row];
    }
    /// … then the counts become cursors, the parts' entries of a row in the order of the parts; the
    /// offsets of the rows are returned.
    [[nodiscard]] std::vector<std::uint64_t> start(std::size_t rows) {
        std::vector<std::uint64_t> offsets(rows + 1, 0);
        std::uint64_t sum = 0;
        for (std::size_t row = 0; row < rows; ++row) {
            offsets[row] = sum;
            for (auto& part : at_) sum += std::exchange(part[row], sum);
        }
        offsets[rows] = sum;
        return offsets;
    }

private:
    std::vector<std::vector<std::uint64_t>> at_;
};

// For each place its visible places, in both directions, in any order.
class PlaceRows {
public:
    PlaceRows(std::size_t places, std::span<const HalfRows> rows, unsigned threads) {
        Cursors at(threads, places);
        in_parts(rows.size(), threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
            for_each_pair(rows.subspan(begin, end - begin), [&](Place p, Place q) {
                ++at(i, p);
                ++at(i, q);
            });
        });
        offsets_ = at.start(places);
        // Not initialised: each part touches its own first.
        targets_ = std::make_unique_for_overwrite<Place[]>(offsets_.back());
        in_parts(rows.size(), threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
            for_each_pair(rows.subspan(begin, end - begin), [&](Place p, Place q) {
                targets_[at(i, p)++] = q;
                targets_[at(i, q)++] = p;
            });
        });
    }

    [[nodiscard]] std::span<const Place> operator[](Place p) const {
        return {targets_.get() + offsets_[p], targets_.get() + offsets_[p + 1]};
    }

private:
    std::vector<std::uint64_t> offsets_;
    std::unique_ptr<Place[]> targets_;
};

// Visits (v, w) for all vertices v of a range, ascending, and all vertices w that v sees.
template <typename Visit>
void for_each_arc(const Triangulation& t, const PlaceRows& rows, std::size_t begin, std::size_t end,
                  const Visit& visit) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
        for (const Place p : rows[t.place_of(VertexId{v})])
            for (const VertexId w : t.vertices_at(p)) visit(VertexId{v}, w);
}

}  // namespace

// Visiting the vertices in ascending order and appending each to the rows of its neighbours leaves
// every row sorted: a transposition instead of a sort.
VisibilityGraph assemble(const Triangulation& t, std::vector<HalfRows> rows, unsigned threads) {
    const PlaceRows by_place(t.first_constructed(), rows, threads);
    rows.clear();
    rows.shrink_to_fit();
    const std::size_t n = t.vertex_count();
    Cursors at(threads, n);
    if (threads <= 1 && !t.has_shared_places()) {  // then a row's size is known without counting
        for (std::uint32_t v = 0; v < n; ++v) at(0, v) = by_place[t.place_of(VertexId{v})].size();
    } else {
        in_parts(n, threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
            for_each_arc(t, by_place, begin, end,
                         [&](VertexId, VertexId w) { ++at(i, w.index()); });
        });
    }
    std::vector<std::uint64_t> offsets = at.start(n);
    std::vector<VertexId> targets(offsets[n]);
    in_parts(n, threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
        for_each_arc(t, by_place, begin, end,
                     [&](VertexId v, VertexId w) { targets[at(i, w.index())++] = v; });
    });
    return {std::move(offsets), std::move(targets)};
}

}  // namespace sightline::detail
