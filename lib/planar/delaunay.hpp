// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/triangulation.hpp"

namespace sightline::detail {

/// Incremental insertion of places into a triangulation, kept nearly Delaunay by flips. Uses triangle
/// slots of its own, so that two of these can work on separate parts of one triangulation at once.
class Delaunay {
public:
    /// New triangles take the slots from first_slot on; without one the arrays grow for them.
    explicit Delaunay(Triangulation& t, HalfEdge first_slot = no_index)
        : t_(t), slot_(first_slot) {}

    /// Inserts the places [begin, end), one near the other, starting in the triangle of `start`.
    void insert(Place begin, Place end, HalfEdge start);
    /// Splits an edge at a new place on it, without restoring anything.
    void insert_on_edge(Place p, HalfEdge h);
    /// Flips from these edges on until no edge is certainly not Delaunay; constrained edges stay.
    void restore(const std::vector<HalfEdge>& edges);
    /// Exchanges the diagonal of the two triangles at e. `leaving` of the places is not kept up.
    void flip(HalfEdge e);
    void link(HalfEdge a, HalfEdge b) {
        t_.twin_[a] = b;
        if (b != no_index) t_.twin_[b] = a;
    }

private:
    HalfEdge insert(Place p, HalfEdge start);
    [[nodiscard]] HalfEdge locate(Place p, HalfEdge start);
    void insert_in_triangle(Place p, HalfEdge h);
    void restore_star();
    [[nodiscard]] bool is_certainly_in_circle(HalfEdge e) const;
    HalfEdge add_triangle();
    [[nodiscard]] Sign side(HalfEdge h, Place p) const {
        return t_.orientation(t_.origin_[h], t_.origin_[next(h)], p);
    }

    Triangulation& t_;
    HalfEdge slot_;  // of the next triangle, or no_index: at the end
    std::vector<HalfEdge> pending_;
    std::uint32_t turn_ = 0;
};

}  // namespace sightline::detail
