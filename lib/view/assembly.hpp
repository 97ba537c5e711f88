// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// From the visible pieces of edges to the planar map. Private.

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "view/edge_sight.hpp"
#include "view/image.hpp"
#include "view/sight.hpp"

namespace sightline::detail {

class Assembly {
public:
    Assembly(Image& image, const Facings& facings, std::uint32_t cone_sides);

    /// Takes in what is seen of a placed edge.
    void add(std::uint32_t edge, const EdgeView& view);
    /// The map of everything taken in; `blocked_by` is set when all directions are blocked.
    [[nodiscard]] ViewMap3 finish(std::optional<BodyId>& blocked_by);

private:
    struct Node {
        std::vector<std::uint32_t> edges;  ///< met in their relative interior
        std::vector<std::uint32_t> points;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts;  ///< see EdgePlace
    };
    /// A place that an edge knows of itself.
    struct Own {
        EdgeEvent at;
        std::uint32_t node = 0;
        bool begins = false;
        bool ends = false;
    };
    struct Arc {
        std::vector<std::uint32_t> edges;
        std::uint32_t source = 0;
        std::uint32_t target = 0;
        // On its first edge: from source to target it runs towards the edge's target or source.
        bool forward = true;
        EdgeEvent from;
        EdgeEvent to;
        std::array<std::uint32_t, 2>
            ring{};  ///< on the left of source→target, and of target→source
    };
    struct Ring {
        std::vector<ViewHalfArc> arcs;
        SightEnd end;
        std::uint32_t region = 0;
    };
    struct Junction {
        std::uint32_t front;
        std::uint32_t back;
        std::uint32_t node;
    };

    [[nodiscard]] std::array<std::uint32_t, 2> ends(std::uint32_t edge) const;
    [[nodiscard]] bool is_side(std::uint32_t edge) const { return edge >= edge_count_; }
    [[nodiscard]] bool collinear(std::uint32_t e, std::uint32_t f);
    [[nodiscard]] std::uint32_t root(std::uint32_t node);
    void join(std::uint32_t a, std::uint32_t b);
    void join_vertex(std::uint32_t point, std::uint32_t node);
    void join_pair(std::uint32_t e, std::uint32_t f, std::uint32_t node);
    void name_place(std::uint32_t edge, const EdgePlace& place, std::uint32_t node);
    void add_sides();
    void ask_vertices();
    void merge_nodes();
    void cut_edges();
    void cut_edge(std::uint32_t edge);
    /// Where two edges in an edge's sight plane, which cross in space, do so in the image.
    [[nodiscard]] EdgeEvent contact_on(std::uint32_t edge, std::size_t axis, std::uint32_t g,
                                       std::uint32_t h);
    void add_arc(std::uint32_t edge, const Own& from, const Own& to);
    void sort_round_nodes();
    void trace_rings();
    [[nodiscard]] std::optional<SightEnd> known_left(std::uint32_t edge, bool forward) const;
    [[nodiscard]] SightEnd look_left(const Arc& arc, bool reversed);
    void label_ring(Ring& ring);
    [[nodiscard]] std::array<double, 3> middle(const Arc& arc);
    [[nodiscard]] Vector3 exact_middle(const Arc& arc);
    void link_rings();
    [[nodiscard]] bool collinear_against(std::uint32_t e, std::uint32_t f);
    /// Where a way crosses an arc: `at` grows along the way.
    struct Crossing {
        Rational at;
        std::uint32_t arc;
        bool leaves_left;  ///< the way comes from the arc's left
    };
    [[nodiscard]] bool cross_arcs(const Vector3& a, const Vector3& b,
                                  std::vector<Crossing>& crossings);
    void walk(std::uint32_t from_arc, std::uint32_t to_arc, std::uint64_t& seed);
    [[nodiscard]] SightEnd look_anywhere();
    [[nodiscard]] ViewMap3 canonical(std::optional<BodyId>& blocked_by);
    void name_nodes(ViewMap3& map, std::vector<std::uint32_t>& rank) const;
    [[nodiscard]] std::vector<EdgeId> ids_of(const std::vector<std::uint32_t>& edges) const;

    Image& image_;
    const Facings& facings_;
    std::uint32_t edge_count_;
    std::uint32_t sides_;
    EdgeOrder order_;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> vertex_node_;
    std::unordered_map<std::uint64_t, std::uint32_t> pair_node_;
    std::vector<std::vector<Own>> own_;                ///< per edge and side
    std::vector<std::vector<std::uint32_t>> passing_;  ///< nodes on an edge that others know of
    struct Question {
        std::uint32_t vertex;
        std::uint32_t edge;
        EdgePlace place;
    };
    std::vector<Question> questions_;
    std::vector<Junction> junctions_;
    struct Piece {
        std::uint32_t edge;
        std::uint32_t from;
        std::uint32_t to;
    };
    std::vector<Piece> pieces_;
    std::vector<Arc> arcs_;
    std::unordered_map<std::uint64_t, std::uint32_t> arc_of_;
    std::vector<std::vector<ViewHalfArc>>
        round_;  ///< per node: half arcs that leave it, counter-clockwise
    std::vector<Ring> rings_;
    std::vector<std::uint32_t> ring_parent_;
};

}  // namespace sightline::detail
