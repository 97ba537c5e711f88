// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "planar/delaunay.hpp"

namespace sightline::detail {

/// Builds a Triangulation in three steps: places, Delaunay by incremental insertion along a Hilbert
/// curve, scene edges by flipping what they cross.
class TriangulationBuilder {
public:
    TriangulationBuilder(Triangulation& out, const Scene2& scene, std::span<const Point2> within)
        : t_(out), scene_(scene), within_(within) {}
    void build(unsigned threads);

private:
    // places
    void make_frame();
    void make_places();
    void measure_precision();
    void split_frame();
    // Delaunay
    void make_first_triangles();
    void insert_places(unsigned threads);
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
    Delaunay delaunay_{t_};
    Place first_right_ = 0;                 ///< the first place in the right half of the frame
    HalfEdge right_slots_ = 0;              ///< the first triangle of the right half
    std::vector<std::uint32_t> curve_key_;  // a scene place
    std::vector<HalfEdge> found_;           // a scene edge: where it was an edge at once
    std::vector<HalfEdge> boundary_;        // the solid sides of all pieces of boundaries
    std::vector<HalfEdge> pending_;
};

}  // namespace sightline::detail
