// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar/graph_assembly.hpp"

#include <tbb/parallel_for.h>

#include <memory>

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
void for_each_pair(const std::vector<HalfRows>& rows, const Visit& visit) {
    for (const HalfRows& block : rows) {
        std::uint64_t i = 0;
        for (std::size_t r = 0; r < block.ends.size(); ++r)
            for (; i < block.ends[r]; ++i)
                visit(block.first + static_cast<Place>(r), block.places[i]);
    }
}

// Cursors into the rows [begin, end) of a table; everybody else's rows share one that stays put, on a
// spare element, so that a thread can pass over foreign entries without a branch that nobody could
// predict.
class Cursors {
public:
    Cursors(std::vector<std::uint64_t>& at, std::size_t begin, std::size_t end, std::uint64_t spare)
        : at_(at.data()), begin_(begin), size_(end - begin), spare_(spare) {}

    [[nodiscard]] std::uint64_t next(std::size_t row) {
        const bool mine = row - begin_ < size_;
        std::uint64_t* const cursor = mine ? at_ + row : &spare_;
        const std::uint64_t here = *cursor;
        *cursor = here + static_cast<std::uint64_t>(mine);
        return here;
    }

private:
    std::uint64_t* at_;
    std::size_t begin_;
    std::size_t size_;
    std::uint64_t spare_;
};

// For each place its visible places, in both directions, in any order.
class PlaceRows {
public:
    PlaceRows(std::size_t places, const std::vector<HalfRows>& rows, unsigned threads)
        : offsets_(places + 1, 0) {
        std::vector<std::uint64_t> at(places + 1, 0);
        in_parts(places, threads, [&](std::size_t, std::size_t begin, std::size_t end) {
            Cursors counts(at, begin, end, 0);
            for_each_pair(rows, [&](Place p, Place q) {
                static_cast<void>(counts.next(p));
                static_cast<void>(counts.next(q));
            });
        });
        for (std::size_t i = 0; i < places; ++i) offsets_[i + 1] = offsets_[i] + at[i];
        std::copy(offsets_.begin(), offsets_.end(), at.begin());
        const std::uint64_t size = offsets_.back();
        // A spare element a thread; not initialised, so that each thread touches its own part first.
        targets_ = std::make_unique_for_overwrite<Place[]>(size + threads);
        in_parts(places, threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
            Cursors cursors(at, begin, end, size + i);
            for_each_pair(rows, [&](Place p, Place q) {
                targets_[cursors.next(p)] = q;
                targets_[cursors.next(q)] = p;
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

std::vector<std::uint64_t> vertex_offsets(const Triangulation& t, const PlaceRows& rows,
                                          std::size_t n) {
    std::vector<std::uint64_t> offsets(n + 1, 0);
    for (Place p = frame_places; p < t.first_constructed(); ++p) {
        std::uint64_t degree = rows[p].size();
        if (t.has_shared_places()) {
            degree = 0;
            for (const Place q : rows[p]) degree += t.vertices_at(q).size();
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
    std::vector<VertexId> targets;
    targets.resize(offsets[n] + threads);  // a spare element a thread
    std::vector<std::uint64_t> at(offsets.begin(), offsets.end() - 1);
    in_parts(n, threads, [&](std::size_t i, std::size_t begin, std::size_t end) {
        Cursors cursors(at, begin, end, offsets[n] + i);
        for (std::uint32_t v = 0; v < n; ++v)
            for (const Place p : by_place[t.place_of(VertexId{v})])
                for (const VertexId w : t.vertices_at(p))
                    targets[cursors.next(w.index())] = VertexId{v};
    });
    targets.resize(offsets[n]);
    return {std::move(offsets), std::move(targets)};
}

}  // namespace sightline::detail
