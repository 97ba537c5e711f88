// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "planar/corners.hpp"
#include "planar/view_scene.hpp"
#include "planar/visible_places.hpp"
#include "sightline/planar/shortest_path.hpp"

namespace sightline::detail {

/// The nodes of a path search: scene places, and where walls part the neighbourhood of a place into
/// sectors that a path cannot change between, one node a sector.
class PathNodes {
public:
    explicit PathNodes(const Triangulation& t);

    [[nodiscard]] std::uint32_t count() const noexcept { return first_.back(); }
    [[nodiscard]] Place place(std::uint32_t node) const noexcept { return place_[node]; }
    [[nodiscard]] std::uint32_t first(Place p) const noexcept { return first_[p]; }
    [[nodiscard]] std::uint32_t sectors(Place p) const noexcept {
        return first_[p + 1] - first_[p];
    }

    /// The nodes of p in which a segment towards q leaves: two when it runs along a wall (on its left
    /// and on its right, seen from p), otherwise one twice.
    [[nodiscard]] std::array<std::uint32_t, 2> towards(Place p, const Viewpoint& q,
                                                       ConeSigns& signs) const;

private:
    struct Sector {
        HalfEdge half_edge;  // leaves p; its triangle lies in the sector
        std::uint32_t node;
    };
    void add_sectors(Place p);
    [[nodiscard]] std::uint32_t node_of(HalfEdge h) const;

    const Triangulation& t_;
    std::vector<std::uint32_t> first_;  // a place
    std::vector<Place> place_;          // a node
    std::vector<Sector> sector_;        // of places with several nodes, by half-edge
};

/// An undirected edge of the search.
struct PathEdge {
    std::uint32_t u, v;  // nodes
};

/// The graph on which a shortest path between two points lies: visible pairs that are tangent at both
/// ends (any at a pinch or a wall, where a path may bend either way), and the ends of the path.
struct PathGraph {
    std::uint32_t source = 0;  ///< the node of the start; nodes of places come first
    std::uint32_t target = 0;
    std::vector<PathEdge> edges;
};

/// Builds path graphs of one scene.
class PathGraphBuilder {
public:
    PathGraphBuilder(const ViewScene& view, const ShortestPathOptions& options);

    [[nodiscard]] const PathNodes& nodes() const noexcept { return nodes_; }
    /// The graph for a path of several segments.
    [[nodiscard]] PathGraph build(const Standpoint& from, const Standpoint& to);

private:
    struct Worker;

    void add_tangents(PathGraph& graph);
    void add_between(Place u, Place w, ConeSigns& signs, std::vector<PathEdge>& out) const;
    void add_end(PathGraph& graph, const Standpoint& end, std::uint32_t node);

    const ViewScene& view_;
    const ShortestPathOptions& options_;
    PathNodes nodes_;
    Corners corners_;
    ConeSigns signs_;
};

}  // namespace sightline::detail
