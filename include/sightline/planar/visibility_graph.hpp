// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline {

/// Whether a vertex sees, along one line, only the next vertex or all those behind it.
enum class Collinear : std::uint8_t { nearest_only, every_vertex };

struct VisibilityGraphOptions {
    /// Which of several vertices on one line of sight are adjacent (semantics 4.1).
    Collinear collinear = Collinear::nearest_only;
    /// Whether edges that run along a body's boundary are edges of the graph.
    bool body_edges = true;
    /// Only edges that are locally tangent to B ∪ W at both ends: those of shortest paths, but for bends
    /// at pinholes and walls (docs/structures/shortest-path.md).
    bool tangent_only = false;
    /// No effect on the result unless `interval` or `double_`, which may be wrong.
    Arithmetic arithmetic = Arithmetic::filtered;
    /// No effect on the result. 0: one a core.
    unsigned threads = 1;
    /// When set, the counts of this build are added to it.
    Tally* tally = nullptr;
};

/// An undirected graph on the vertices of a scene; canonical: neighbours ascending, no loops, no repeats.
/// Memory: 8 bytes an edge and 8 a vertex.
class VisibilityGraph {
public:
    using Edge = std::pair<VertexId, VertexId>;

    VisibilityGraph() : offsets_(1, 0) {}
    /// From the ascending symmetric adjacency in compressed rows; the caller vouches for its form.
    VisibilityGraph(std::vector<std::uint64_t> offsets, std::vector<VertexId> targets)
        : offsets_(std::move(offsets)), targets_(std::move(targets)) {}
    /// From any list of edges, in any order and direction, repeats allowed.
    [[nodiscard]] static VisibilityGraph from_edges(std::size_t vertex_count,
                                                    std::vector<Edge> edges);

    [[nodiscard]] std::size_t vertex_count() const noexcept { return offsets_.size() - 1; }
    [[nodiscard]] std::size_t edge_count() const noexcept { return targets_.size() / 2; }
    /// Ascending.
    [[nodiscard]] std::span<const VertexId> neighbours(VertexId v) const {
        return {targets_.data() + offsets_[v.index()], targets_.data() + offsets_[v.index() + 1]};
    }
    [[nodiscard]] bool has_edge(VertexId u, VertexId v) const;
    /// All edges (u, v) with u < v, lexicographic.
    [[nodiscard]] std::vector<Edge> edges() const;

    friend bool operator==(const VisibilityGraph&, const VisibilityGraph&) = default;

private:
    std::vector<std::uint64_t> offsets_;
    std::vector<VertexId> targets_;
};

/// The visibility graph: u and v adjacent when the open segment uv is free and, with `nearest_only`,
/// contains no scene vertex. Running along edges, grazing and pinholes are free (semantics 2.4); vertices
/// at one place are not adjacent to each other, and each has the edges of the place.
///
/// Cost: a constrained triangulation, then work that follows the edges found (triangular expansion).
/// Source: Bungiu, Hemmer, Hershberger, Huang, Kröller, "Efficient computation of visibility polygons", 2014.
[[nodiscard]] VisibilityGraph visibility_graph(const Scene2& scene,
                                               const VisibilityGraphOptions& options = {});

/// The same under limits: `max_elements` bounds the edges.
[[nodiscard]] Result<VisibilityGraph> visibility_graph(const Scene2& scene,
                                                       const VisibilityGraphOptions& options,
                                                       const Limits& limits);

}  // namespace sightline
