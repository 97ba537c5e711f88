// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "sightline/geom/plucker.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

/// Coordinates of a skeleton's nodes and arcs, computed when asked for: a skeleton itself keeps features only.

namespace sightline {

/// Where a segment of the skeleton ends.
struct SkeletonSegmentEnd {
    bool is_infinite = false;
    /// The end point; at infinity the direction in which the segment goes there.
    SurdVector3 at;

    friend bool operator==(const SkeletonSegmentEnd&, const SkeletonSegmentEnd&) = default;
};

/// A maximal free segment with coordinates.
struct SkeletonSegment {
    SurdLine3 line;  ///< scaled
    /// In the order of the label's ends.
    std::array<SkeletonSegmentEnd, 2> ends;

    friend bool operator==(const SkeletonSegment&, const SkeletonSegment&) = default;
};

/// Rounded ends of a segment, for drawing: a point each, or a direction where it is infinite.
struct ApproxSegment {
    std::array<Point3, 2> ends;
    std::array<bool, 2> is_infinite{};
    /// A point of the segment: an end that is one, else that of the line which is nearest to the origin.
    Point3 through;

    friend bool operator==(const ApproxSegment&, const ApproxSegment&) = default;
};

[[nodiscard]] ApproxSegment approx_end_points(const SkeletonSegment& segment);

/// The least subset of an arc's support that fixes its family of lines: a vertex and an edge, or three edges;
/// the first one in lexicographic order. Where the lines are held in the plane of a contact between bodies too, behind
/// an end, that plane goes with what the support has: a vertex, or edges.
struct ArcGenerators {
    std::vector<VertexId> vertices;
    std::vector<EdgeId> edges;

    friend auto operator<=>(const ArcGenerators&, const ArcGenerators&) = default;
};

/// Computes coordinates of nodes and arcs of one scene, which must outlive it. Keeps buffers: use one a thread.
///
/// A node's line follows from its support: two places with vertices, or one and two planes, or four lines. When
/// the vertices and the carriers of the edges leave more than finitely many lines, points where two edges of
/// the support cross are taken to be places, and lines in planes of faces that the support touches are looked at.
/// Which of several lines it is, the relative interiors of the edges say, then the ends, then the node's root.
///
/// Answers are empty when no line has the label: never for nodes and arcs of the scene's skeleton, unless
/// they come from inexact arithmetic.
/// Cost: a few hundred products of rational numbers a node; O(n) shots where the ends lie in planes of the
/// faces they name.
class SkeletonGeometry {
public:
    explicit SkeletonGeometry(const Scene3& scene);
    SkeletonGeometry(SkeletonGeometry&& other) noexcept;
    SkeletonGeometry& operator=(SkeletonGeometry&& other) noexcept;
    ~SkeletonGeometry();

    /// The line, scaled. Laws
    ///  (1) it passes through the support's vertices and meets the relative interiors of its edges
    ///  (2) two nodes with roots `first` and `second` and one support have ascending lines
    [[nodiscard]] std::optional<SurdLine3> line(const SkeletonNode& node);
    [[nodiscard]] std::optional<SkeletonSegment> segment(const SkeletonNode& node);

    [[nodiscard]] std::optional<ArcGenerators> generators(const VisibilitySkeleton& skeleton,
                                                          ArcId arc);
    /// Lines of an arc, in order from its first node to its second: at even steps, rounded, of the point where they
    /// meet one of the arc's edges. Fewer than `count` when doubles are too coarse for that.
    [[nodiscard]] std::vector<RationalLine3> lines(const VisibilitySkeleton& skeleton, ArcId arc,
                                                   std::size_t count);
    /// Whether a line is in the arc's family, strictly between the lines of its nodes. Nothing is said about what
    /// blocks it.
    [[nodiscard]] bool contains(const VisibilitySkeleton& skeleton, ArcId arc,
                                const SurdLine3& line);
    /// The arc's first node, the segments of lines(), and its second node, all rounded.
    [[nodiscard]] std::vector<ApproxSegment> approx_segments(const VisibilitySkeleton& skeleton,
                                                             ArcId arc, std::size_t count);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// The line of a node, scaled. Contract: a node of the scene's skeleton. To ask for many, use one SkeletonGeometry.
[[nodiscard]] SurdLine3 plucker(const Scene3& scene, const SkeletonNode& node);
/// The maximal free segment of a node, likewise.
[[nodiscard]] SkeletonSegment segment(const Scene3& scene, const SkeletonNode& node);

}  // namespace sightline
