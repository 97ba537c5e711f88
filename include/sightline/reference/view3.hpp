// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <iosfwd>
#include <vector>

#include "sightline/view/view3.hpp"

/// Views of space by definition: every edge is cut wherever another feature could pass before it, and each cut and
/// each piece between two cuts is shot at, through all triangles in exact numbers.
namespace sightline::reference {

/// A view's cells by what they show; what a planar map says, but for which rings bound one region.
struct ViewLabels3 {
    struct Arc {
        std::vector<EdgeId> edges;
        ViewNode source;  ///< the lesser end
        ViewNode target;
        /// What is seen on the left of source→target, and on its right.
        ViewRegion::Kind left_kind{};
        ViewRegion::Kind right_kind{};
        SegmentEnd left;
        SegmentEnd right;

        friend auto operator<=>(const Arc&, const Arc&) = default;
    };
    std::vector<ViewNode> nodes;
    std::vector<Arc> arcs;

    friend bool operator==(const ViewLabels3&, const ViewLabels3&) = default;
    friend std::ostream& operator<<(std::ostream& out, const ViewLabels3& labels);
};

/// What a view says.
[[nodiscard]] ViewLabels3 labels_of(const View3& view);

/// The view by brute force; without a cone. Contract: a viewpoint is in no body's interior.
/// Cost: O(E (E + V)) exact shots for E edges and V vertices.
[[nodiscard]] ViewLabels3 view3(const Scene3& scene, const Viewpoint3& from);

}  // namespace sightline::reference
