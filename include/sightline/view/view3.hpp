// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/vector3.hpp"
#include "sightline/scene/scene3.hpp"
#include "sightline/spatial/free_segment3.hpp"

/// What is seen in a 3D scene from one point, or along one direction: the labelled planar map of semantics 5.1.
///
/// A direction of sight is seen as far as its free segment from the viewpoint goes (grazing is free). A point
/// of an edge is visible when the segment from the viewpoint to it is free.
///
/// Degeneracy rules
///  (1) The set of visible points of an edge is closed: pieces are closed intervals, and may be single points
///      (seen between two bodies that graze the line of sight from both sides, through a pinhole or a slit).
///  (2) Edges over each other in the image (on one great circle) are one arc that lists all of them that are
///      visible there. An edge seen end-on is no arc; its vertices are nodes when they are visible.
///  (3) A node is a direction; it lists every visible vertex on it and every visible edge that it meets in the
///      edge's relative interior, however many they are.
///  (4) A face seen edge-on has no region. A face seen along curves only (through a slit) has none either.
///  (5) From a point on the boundary of a body one sees what free directions see; the others form regions
///      `blocked`. Features that contain the viewpoint are no nodes or arcs, except a vertex or an edge's end
///      elsewhere. A viewpoint on a sheet sees both of its sides' directions.
///  (6) Touching bodies: a contact of codimension one is sealed. Where faces of several bodies (or a sheet on
///      a face) stop a region's sight at one place, the region lists all of them.

namespace sightline {

/// From where one looks: a point, or infinity; then `coordinates` is the direction in which one looks.
struct Viewpoint3 {
    RationalPoint3 coordinates;
    bool at_infinity = false;

    friend bool operator==(const Viewpoint3&, const Viewpoint3&) = default;
    friend std::strong_ordering operator<=>(const Viewpoint3&, const Viewpoint3&) = default;
};

struct View3Options {
    /// Restricts the view to a convex cone (seen from infinity: a prism), given by points on its corner lines,
    /// counter-clockwise as seen from the viewpoint; at least three, or none for the whole view. Border
    /// directions belong to it.
    std::vector<RationalPoint3> cone{};
    Arithmetic arithmetic = Arithmetic::filtered;
    Tally* tally = nullptr;
};

/// A 0-cell of the map: a direction in which a vertex is seen, edges pass each other, or a piece of an edge ends.
struct ViewNode {
    std::vector<VertexId> vertices;    ///< visible ones in this direction, ascending
    std::vector<EdgeId> edges;         ///< visible ones met in their relative interior, ascending
    std::vector<std::uint32_t> sides;  ///< sides of the cone that pass here, ascending

    friend auto operator<=>(const ViewNode&, const ViewNode&) = default;
};

/// A 1-cell: a piece of a great circle on which edges are seen (or a side of the cone), between two nodes.
struct ViewArc {
    static constexpr std::uint32_t no_side = std::numeric_limits<std::uint32_t>::max();

    std::vector<EdgeId> edges;     ///< visible over each other along it, ascending
    std::uint32_t side = no_side;  ///< the side of the cone that it lies on
    std::uint32_t source = 0;      ///< a node; source < target
    std::uint32_t target = 0;
    std::uint32_t left = 0;  ///< the region on the left of source→target as seen, and on the right
    std::uint32_t right = 0;

    friend auto operator<=>(const ViewArc&, const ViewArc&) = default;
};

/// An arc with a sense.
struct ViewHalfArc {
    std::uint32_t arc = 0;
    bool reversed = false;

    friend auto operator<=>(const ViewHalfArc&, const ViewHalfArc&) = default;
};

/// A 2-cell: a connected set of directions that end on the same face.
struct ViewRegion {
    enum class Kind : std::uint8_t {
        face,      ///< a face is seen, or several at one place: `faces`
        infinity,  ///< nothing is seen
        blocked,   ///< directions into a body that contains the viewpoint on its boundary
        outside    ///< directions that are not in the cone
    };
    Kind kind = Kind::infinity;
    SegmentEnd faces;
    /// Each boundary component, the region on the left; starts with its least half arc. Sorted.
    std::vector<std::vector<ViewHalfArc>> rings;

    friend auto operator<=>(const ViewRegion&, const ViewRegion&) = default;
};

/// A visible piece of `back` ends where `front` passes before it.
struct TJunction {
    EdgeId front;
    EdgeId back;
    std::uint32_t node = 0;

    friend auto operator<=>(const TJunction&, const TJunction&) = default;
};

/// A piece of an edge between two neighbouring nodes on it, or a single node; nodes in the order of
/// source→target.
struct ViewPiece {
    EdgeId edge;
    std::uint32_t from = 0;
    std::uint32_t to = 0;

    friend auto operator<=>(const ViewPiece&, const ViewPiece&) = default;
};

/// The view. Everything is sorted, nodes by their labels; names are ranks in these lists. Two views are the same
/// labelled map when their maps are equal.
struct ViewMap3 {
    std::vector<ViewNode> nodes;
    std::vector<ViewArc> arcs;
    std::vector<ViewRegion> regions;
    std::vector<TJunction> t_junctions;
    /// The maximal visible pieces of edges.
    std::vector<ViewPiece> pieces;

    friend bool operator==(const ViewMap3&, const ViewMap3&) = default;
    /// One cell a line.
    friend std::ostream& operator<<(std::ostream& out, const ViewMap3& map);
};

struct View3 {
    Viewpoint3 from;
    std::vector<RationalPoint3> cone;
    ViewMap3 map;

    /// The faces that are seen, ascending.
    [[nodiscard]] std::vector<FaceSide> visible_faces() const;
    /// The vertices that are seen, ascending.
    [[nodiscard]] std::vector<VertexId> visible_vertices() const;

    friend bool operator==(const View3&, const View3&) = default;
};

/// A point on the line of sight of a node: its first vertex, else the point of its first edge there, else the
/// point that was given for the corner of the cone. Exact.
[[nodiscard]] RationalPoint3 exact_point(const Scene3& scene, const View3& view,
                                         std::uint32_t node);

/// Where a node lies on a feature edge that it lists (or whose end it lists): t of source + t (target - source).
[[nodiscard]] Rational exact_parameter(const Scene3& scene, const View3& view, std::uint32_t node,
                                       EdgeId edge);

namespace detail {
struct PlacedScene;
class Image;
}  // namespace detail

/// A scene prepared for many views. Immutable and safe to share between threads; the scene must outlive it.
class PointVisibility3 {
public:
    explicit PointVisibility3(const Scene3& scene);
    ~PointVisibility3();
    PointVisibility3(PointVisibility3&&) noexcept;
    PointVisibility3& operator=(PointVisibility3&&) noexcept;

    /// The view from a point. Fails with inside_body, which names the body (outside_of_world for the world);
    /// with bad_parameter when the cone is no convex cone.
    /// Cost, for n edges of which each has k triangles before it: O(n (log n + k log k)).
    [[nodiscard]] Result<View3> from(const RationalPoint3& p,
                                     const View3Options& options = {}) const;
    [[nodiscard]] Result<View3> from(const Point3& p, const View3Options& options = {}) const {
        return from(to_rational(p), options);
    }
    /// The view from infinity along a direction. Fails with bad_parameter when it is zero, or the cone wrong, and
    /// with outside_of_world when the scene is a world's inside.
    [[nodiscard]] Result<View3> along(const Vector3& direction,
                                      const View3Options& options = {}) const;

    [[nodiscard]] const detail::PlacedScene& prepared() const noexcept { return *scene_; }

private:
    [[nodiscard]] Result<View3> look(const Viewpoint3& from, const View3Options& options) const;

    std::unique_ptr<const detail::PlacedScene> scene_;
};

/// One view, one-off.
[[nodiscard]] Result<View3> view3(const Scene3& scene, const Viewpoint3& from,
                                  const View3Options& options = {});

}  // namespace sightline
