// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline {

enum class Needles : std::uint8_t { regularised, with_needles };

struct VisibilityPolygonOptions {
    /// Whether one-dimensional parts of the visible set are reported (as `needles`) or dropped.
    Needles needles = Needles::regularised;
    Arithmetic arithmetic = Arithmetic::filtered;
    Tally* tally = nullptr;
};

/// A vertex of a visibility polygon, kept as its generators.
struct ViewVertex {
    enum class Kind : std::uint8_t {
        vertex,    ///< the scene vertex `vertex`
        on_edge,   ///< where the ray from the viewpoint through `vertex` meets the edge `edge`
        infinity,  ///< the direction from the viewpoint through `vertex`
        crossing,  ///< where the walls `edge` and `other` cross
        from,      ///< the viewpoint itself (it lies on the boundary of what it sees)
        direction  ///< at infinity, in direction `axis` (one of the four axes, where nothing bounds the view)
    };
    Kind kind = Kind::vertex;
    std::uint8_t axis = 0;  ///< 0 +x, 1 +y, 2 -x, 3 -y
    VertexId vertex{};
    EdgeId edge{};
    EdgeId other{};

    friend auto operator<=>(const ViewVertex&, const ViewVertex&) = default;
};

/// A point, or a direction when the vertex is at infinity.
struct ViewPoint {
    RationalPoint2 coordinates;
    bool at_infinity = false;

    friend bool operator==(const ViewPoint&, const ViewPoint&) = default;
    friend std::strong_ordering operator<=>(const ViewPoint&, const ViewPoint&) = default;
};

/// A needle: a visible segment that no open set of visible points surrounds.
struct Needle {
    ViewVertex near;
    ViewVertex far;

    friend auto operator<=>(const Needle&, const Needle&) = default;
};

/// What a point sees: counter-clockwise, weakly simple, kept as generators.
struct VisibilityPolygon {
    RationalPoint2 from;
    std::vector<ViewVertex> ring;
    std::vector<Needle> needles;
};

/// Exact coordinates of one vertex of a visibility polygon.
[[nodiscard]] ViewPoint exact_point(const Scene2& scene, const RationalPoint2& from,
                                    const ViewVertex& v);

/// The canonical ring of semantics and formats: exact, counter-clockwise from the lexicographically least
/// finite vertex, consecutive equal points and straight (180°) vertices removed.
[[nodiscard]] std::vector<ViewPoint> exact_ring(const Scene2& scene,
                                                const VisibilityPolygon& polygon);

class ExactPoints;

/// A scene prepared for many visibility polygons. Immutable and safe to share between threads.
class PointVisibility2 {
public:
    explicit PointVisibility2(const Scene2& scene);
    ~PointVisibility2();
    PointVisibility2(PointVisibility2&&) noexcept;
    PointVisibility2& operator=(PointVisibility2&&) noexcept;

    /// Fails with inside_body, outside_of_world, or coordinate_too_large (beyond 2^1020).
    [[nodiscard]] Result<VisibilityPolygon> from(
        const Point2& q, const VisibilityPolygonOptions& options = {}) const;
    [[nodiscard]] Result<VisibilityPolygon> from(
        const RationalPoint2& q, const VisibilityPolygonOptions& options = {}) const;
    /// The same into storage that the caller reuses.
    [[nodiscard]] Result<void> from(const Point2& q, const VisibilityPolygonOptions& options,
                                    VisibilityPolygon& out) const;
    /// Exact coordinates of a polygon that this object gave, vertex by vertex (planar/exact_points.hpp).
    [[nodiscard]] ExactPoints exact_points(const VisibilityPolygon& polygon) const;

private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

/// The visibility polygon of one point, one-off.
[[nodiscard]] Result<VisibilityPolygon> visibility_polygon(
    const Scene2& scene, const RationalPoint2& q, const VisibilityPolygonOptions& options = {});

}  // namespace sightline
