// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/triangulation.hpp"

namespace sightline::detail {

/// Builds a Triangulation in three steps: places, Delaunay by incremental insertion along a Hilbert
/// curve, scene edges by flipping what they cross.
class TriangulationBuilder {
public:
    TriangulationBuilder(Triangulation& out, const Scene2& scene, std::span<const Point2> within)
        : t_(out), scene_(scene), within_(within) {}
    void build();

private:
    // places
    void make_frame();
    void make_places();
    void measure_precision();
    // Delaunay
    void make_first_triangles();
    void insert_places();
    [[nodiscard]] HalfEdge locate(Place p, HalfEdge start);
    HalfEdge insert(Place p, HalfEdge start);
    void insert_in_triangle(Place p, HalfEdge h);
    void insert_on_edge(Place p, HalfEdge h);
    void restore_delaunay();
    void flip(HalfEdge e);
    [[nodiscard]] bool is_certainly_in_circle(HalfEdge e) const;
    HalfEdge add_triangle();
    void link(HalfEdge a, HalfEdge b) {
        t_.twin_[a] = b;
        if (b != no_index) t_.twin_[b] = a;
    }
    [[nodiscard]] Sign side(HalfEdge h, Place p) const {
        return t_.orientation(t_.origin_[h], t_.origin_[next(h)], p);
    }
    // constraints
    void insert_edges();
    void insert_edge(Place a, Place b, std::uint8_t kind);
    Place insert_edge_piece(Place a, Place b, std::uint8_t kind);
    [[nodiscard]] HalfEdge find(Place a, Place b) const;
    [[nodiscard]] HalfEdge first_crossed(Place a, Place b, Place& on_edge) const;
    Place split_crossing(Place a, Place b, HalfEdge crossed);
    void flip_away(Place a, Place b, std::vector<std::pair<Place, Place>> crossed,
                   std::uint8_t kind);
    void improve(const std::vector<std::pair<Place, Place>>& edges);
    [[nodiscard]] bool is_flippable(HalfEdge h) const;
    void set_kind(HalfEdge h, std::uint8_t kind);
    // labels
    void label();
    void label_edge(EdgeId e);
    void flood_solid();
    void find_pinches();

    Triangulation& t_;
    const Scene2& scene_;
    std::span<const Point2> within_;
    std::vector<HalfEdge> pending_;
    std::uint32_t turn_ = 0;
};

}  // namespace sightline::detail
