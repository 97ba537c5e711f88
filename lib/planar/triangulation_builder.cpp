// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the steps, and the Delaunay step: both halves of the frame at once when threads allow.
#include "planar/triangulation_builder.hpp"

#include <tbb/parallel_invoke.h>

#include "planar/delaunay.hpp"

namespace sightline::detail {

void TriangulationBuilder::build(unsigned threads) {
    make_frame();
    make_places();
    split_frame();
    measure_precision();
    make_first_triangles();
    insert_places(threads);
    insert_edges();
    label();
}

// Two rectangles, left and right of the places 4 and 5, of two triangles each; not linked yet. A rectangle
// and what will be inserted there take consecutive slots.
void TriangulationBuilder::make_first_triangles() {
    const std::size_t slots = 4 * (4 + 2 * (t_.position_.size() - frame_places));
    t_.origin_.resize(slots, no_index);
    t_.twin_.resize(slots, no_index);
    t_.kind_.resize(slots, 0);
    t_.leaving_.resize(t_.position_.size(), no_index);
    right_slots_ = 4 * (2 + 2 * (first_right_ - frame_places));
    const auto rectangle = [&](HalfEdge slot, Place p, Place q, Place r, Place s) {
        const Place corners[2][3] = {{p, q, r}, {r, s, p}};
        for (HalfEdge i = 0; i < 6; ++i)
            t_.origin_[slot + 4 * (i / 3) + i % 3] = corners[i / 3][i % 3];
        t_.twin_[slot + 2] = slot + 6;
        t_.twin_[slot + 6] = slot + 2;
    };
    rectangle(0, 0, 4, 5, 3);
    rectangle(right_slots_, 4, 1, 2, 5);
}

void TriangulationBuilder::insert_places(unsigned threads) {
    const auto left = [&] { Delaunay(t_, 8).insert(frame_places, first_right_, 0); };
    const auto right = [&] {
        Delaunay(t_, right_slots_ + 8).insert(first_right_, t_.first_constructed_, right_slots_);
    };
    if (threads > 1) {
        tbb::parallel_invoke(left, right);
    } else {
        left();
        right();
    }
    HalfEdge from_left = no_index;
    HalfEdge from_right = no_index;
    for (HalfEdge h = 0; h < t_.origin_.size(); ++h) {
        if ((h & 3U) == 3U) continue;
        const Place p = t_.origin_[h];
        t_.leaving_[p] = h;
        if (p == 4 && t_.origin_[next(h)] == 5) from_left = h;
        if (p == 5 && t_.origin_[next(h)] == 4) from_right = h;
    }
    delaunay_.link(from_left, from_right);
    delaunay_.restore({from_left});
}

}  // namespace sightline::detail
