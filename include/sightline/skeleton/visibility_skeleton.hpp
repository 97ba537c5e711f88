// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/free_segment3.hpp"

namespace sightline {

struct NodeTag {
    static constexpr char letter = 'n';
};
struct ArcTag {
    static constexpr char letter = 'a';
};
using NodeId = Id<NodeTag>;
using ArcId = Id<ArcTag>;

/// Which of the two lines that share a support: in the lexicographic order of their Plücker vectors, scaled so
/// that the first nonzero direction coordinate is 1.
enum class Root : std::uint8_t { only, first, second };

/// How a node's line is fixed; the first that applies, in this order. "Lies in the plane of a face" means:
/// the line does, and a vertex of the face or two of its edges are in the support.
enum class NodeType : std::uint8_t {
    vv,  ///< two places with vertices (or with edges that cross in a point)
    fve,  ///< one such place, and a face in whose plane the line lies with two features on its border
    vee,   ///< one such place and two more edges
    ff,    ///< no vertex; two faces, in different planes, in both of which the line lies
    fee,   ///< no vertex; one face in whose plane the line lies, and two more edges
    eeee,  ///< edges only
};

/// What a one-parameter set of lines is (its generators, semantics 3.4).
enum class ArcType : std::uint8_t {
    fv,   ///< lines through a vertex in the plane of a face
    ev,   ///< lines through a vertex that meet an edge: a planar pencil
    fe,   ///< lines in the plane of a face through the point where an edge meets that plane
    eee,  ///< lines that meet three edges: one ruling of a quadric, or a planar pencil
};

[[nodiscard]] std::string_view name_of(NodeType type) noexcept;
[[nodiscard]] std::string_view name_of(ArcType type) noexcept;

/// A 0-cell of the maximal free segments: a segment whose support fixes its line.
struct SkeletonNode {
    NodeType type{};
    SegmentLabel label;
    Root root = Root::only;
    /// The faces in whose plane the line lies (see NodeType), ascending: nodes of type FvE may have equal
    /// labels and differ in them.
    std::vector<FaceId> faces{};

    friend auto operator<=>(const SkeletonNode&, const SkeletonNode&) = default;
};

/// A 1-cell: maximal connected set of maximal free segments with equal support and ends whose support leaves
/// the line one degree of freedom. `nodes` are the two nodes in its closure, ascending.
struct SkeletonArc {
    ArcType type{};
    SegmentLabel label;
    std::array<NodeId, 2> nodes;

    friend auto operator<=>(const SkeletonArc&, const SkeletonArc&) = default;
};

/// The visibility skeleton of a scene: the graph of the 0-cells and 1-cells of its maximal free segments
/// (Durand, Drettakis, Puech, "The visibility skeleton", SIGGRAPH 1997; here for every scene, degenerate ones
/// included; see docs/structures/visibility-skeleton.md).
///
/// Degeneracy rules
///  (1) The support is read as places along the segment: features met at one point belong together. Cells with
///      the same support but other places together are told apart.
///  (2) A place with a vertex, or where two edges that are not on one line meet, fixes a point of the line;
///      otherwise a place fixes that the line meets one line. The dimension of a cell is that of the set of
///      lines that keep these conditions.
///  (3) A line through a vertex v may be the end of an arc of lines that cross two edges at v (mostly the corner
///      of a face, in the plane of that face), although its own support leaves it a degree of freedom. It
///      is a node, of type FvE or VEE, and divides the arc through it. (Past a convex corner of a face every EV
///      arc has such a node where it passes the face's plane.)
///  (4) A degenerate node is one node, named by its whole support, and lies at the end of every arc whose
///      closure contains it.
///
/// Nodes and arcs are sorted; arcs name nodes by their rank. Equal scenes give equal values.
class VisibilitySkeleton {
public:
    VisibilitySkeleton() = default;
    /// Sorts the nodes and arcs; `arcs[i].nodes` are indices into `nodes` as given. Equal nodes are merged,
    /// and so are equal arcs.
    VisibilitySkeleton(std::vector<SkeletonNode> nodes, std::vector<SkeletonArc> arcs);

    [[nodiscard]] std::span<const SkeletonNode> nodes() const noexcept { return nodes_; }
    [[nodiscard]] std::span<const SkeletonArc> arcs() const noexcept { return arcs_; }
    [[nodiscard]] const SkeletonNode& operator[](NodeId n) const { return nodes_[n.index()]; }
    [[nodiscard]] const SkeletonArc& operator[](ArcId a) const { return arcs_[a.index()]; }
    /// The arcs whose closure contains the node, ascending.
    [[nodiscard]] std::span<const ArcId> arcs_at(NodeId n) const {
        return {node_arcs_.data() + first_arc_[n.index()],
                node_arcs_.data() + first_arc_[n.index() + 1]};
    }

    friend bool operator==(const VisibilitySkeleton&, const VisibilitySkeleton&) = default;

private:
    std::vector<SkeletonNode> nodes_;
    std::vector<SkeletonArc> arcs_;
    std::vector<std::uint32_t> first_arc_{0};
    std::vector<ArcId> node_arcs_;
};

}  // namespace sightline
