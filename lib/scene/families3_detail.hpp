// SPDX-License-Identifier: GPL-3.0-or-later
// What the generators of 3D scenes share: integer geometry, a builder of meshes, places for bodies.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "scene/families2_detail.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::families::detail {

__extension__ using Wide = __int128;

/// A lattice point or vector. Coordinates stay below 2^38 in size, so that `triple` is exact.
struct Int3 {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;

    friend auto operator<=>(const Int3&, const Int3&) = default;
    friend Int3 operator+(Int3 a, Int3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Int3 operator-(Int3 a, Int3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Int3 operator*(std::int64_t s, Int3 a) { return {s * a.x, s * a.y, s * a.z}; }
};
using Ring3 = std::vector<Int3>;

/// det(u, v, w).
[[nodiscard]] Wide triple(Int3 u, Int3 v, Int3 w);
/// Sign of the volume of the tetrahedron abcd: +1 when abc is counter-clockwise seen from the side away from d.
[[nodiscard]] int orientation_sign(Int3 a, Int3 b, Int3 c, Int3 d);
[[nodiscard]] inline std::int64_t squared_length(Int3 v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// Nonzero integer vector u × v; u and v below 2^30.
[[nodiscard]] inline Int3 cross3(Int3 u, Int3 v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

using FaceList = std::vector<std::vector<std::uint32_t>>;

/// The boundary of a convex hull: its vertices in the order of the points, and one polygon a facet.
struct ConvexSolid {
    Ring3 vertices;
    FaceList faces;
    bool simplicial = true;  ///< all facets are triangles
};
/// Points that are not all coplanar; those that are no vertices of the hull are left out. O(n^3) as a rule.
[[nodiscard]] ConvexSolid convex_hull(std::span<const Int3> points);

/// A rotation times a whole number: the columns are orthogonal and of equal length.
struct Turn {
    Int3 x{1, 0, 0};
    Int3 y{0, 1, 0};
    Int3 z{0, 0, 1};
    std::int64_t length = 1;  ///< of each column

    [[nodiscard]] Int3 operator()(Int3 p) const { return p.x * x + p.y * y + p.z * z; }
};
/// From the quaternion a + bi + cj + dk, not zero; the length is its norm.
[[nodiscard]] Turn turn_of(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d);
/// A random turn of length below 400, in which no column is parallel to an axis.
[[nodiscard]] Turn random_turn(Rng& rng);
/// A random turn round the z axis by a Pythagorean triple, of length below 100, with no other column parallel to
/// an axis.
[[nodiscard]] Turn random_upright_turn(Rng& rng);

/// Collects vertices and faces of a mesh. Whatever it adds is a component with its own vertices.
class MeshBuilder {
public:
    /// Faces are cycles of indices into `vertices`, counter-clockwise seen from outside.
    void add(std::span<const Int3> vertices, const FaceList& faces);
    void add(const ConvexSolid& solid) { add(solid.vertices, solid.faces); }
    /// An axis-parallel box; low < high in each coordinate.
    void add_box(Int3 low, Int3 high);
    /// The parallelepiped at `corner` with edges u, v, w, of either orientation but not flat.
    void add_parallelepiped(Int3 corner, Int3 u, Int3 v, Int3 w);
    /// The box `low`…`high` after turn and shift: p → shift + turn(p).
    void add_turned_box(const Turn& turn, Int3 shift, Int3 low, Int3 high);
    /// A planar ring, and its translate by `along`; det(ring, along) may have either sign.
    void add_prism(const Ring3& ring, Int3 along);
    /// The tetrahedron of four points that are not coplanar, in any order.
    void add_tetrahedron(Int3 a, Int3 b, Int3 c, Int3 d);
    /// One polygon, for sheets.
    void add_polygon(const Ring3& ring);

    [[nodiscard]] bool empty() const { return mesh_.faces.empty(); }
    [[nodiscard]] std::size_t face_count() const { return mesh_.faces.size(); }
    [[nodiscard]] MeshInput3 take(SurfaceKind kind = SurfaceKind::solid);
    /// A scene of this mesh alone.
    [[nodiscard]] SceneInput3 take_scene(SurfaceKind kind = SurfaceKind::solid);

private:
    MeshInput3 mesh_;
};

[[nodiscard]] inline Point3 to_point(Int3 p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// Centres of `count` disjoint balls of this radius in a cube, at random. They fill about `percent` of the cube,
/// or less where so many are not to be had.
[[nodiscard]] std::vector<Int3> random_balls(Rng& rng, std::size_t count, std::int64_t radius,
                                             std::uint64_t percent);
/// A random lattice point next to the sphere about the origin, not outside it. The radius is below 2^24.
[[nodiscard]] Int3 on_sphere(Rng& rng, std::int64_t radius);

/// The least n with n^3 ≥ value; value below 2^90.
[[nodiscard]] std::int64_t ceil_cbrt(Wide value);

}  // namespace sightline::families::detail
