// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sightline/scene/families.hpp"
#include "sightline/scene/result.hpp"
#include "sightline/scene/scene3.hpp"

/// Generators of 3D scenes, like those of 2D scenes (families.hpp): each is a function of its parameters and a
/// seed and of nothing else, the same bytes on every platform. Every scene passes Scene3::make. Coordinates are
/// integers below 2^27 in size unless the comment says otherwise. All meshes are solids, or all are sheets.
/// Parameters out of the range that `all3()` lists break the contract (SIGHTLINE_EXPECT); `generate3` returns an
/// error instead.
namespace sightline::families {

// ---- single solids ---------------------------------------------------------------------------------------

enum class SolidShape : std::uint8_t {
    tetrahedron,   ///< 4 vertices, 6 edges, 4 triangles, all regular
    cube,          ///< 8, 12, 6
    octahedron,    ///< 6, 12, 8, regular
    icosahedron,   ///< 12, 30, 20; combinatorially the regular one, with golden ratio 13/8
    dodecahedron,  ///< 20, 30, 12: the pyritohedron of height 1/2 (the regular one is not rational)
    l_shape,       ///< 12, 18, 8: a cube less a quarter; one reflex edge
    u_shape,       ///< 16, 24, 10: a bar with two arms
    ring,  ///< 16, 24, 10 after merging: a square torus; top and bottom are faces with a hole
    notched_cube,  ///< 14, 21, 9: a cube less a corner: three reflex edges at a reflex vertex
};
[[nodiscard]] SceneInput3 solid(SolidShape shape);

struct Sides {
    std::size_t sides =
        6;  ///< of the base, a strictly convex polygon of lattice points near a circle; 3 … 1000
};
/// 2 N vertices, 3 N edges, N + 2 faces.
[[nodiscard]] SceneInput3 prism(const Sides& parameters);
/// N + 1 vertices, 2 N edges, N + 1 faces.
[[nodiscard]] SceneInput3 pyramid(const Sides& parameters);
/// A solid comb: a bar with teeth of random lengths. 8 TEETH vertices, 12 TEETH edges, 4 TEETH + 2 faces.
[[nodiscard]] SceneInput3 comb3(const Comb& parameters, std::uint64_t seed);

// ---- random disjoint bodies --------------------------------------------------------------------------------

struct Bodies {
    std::size_t count = 10;
    /// Bodies lie in disjoint balls of one radius that fill this much of a cube; 1 … 30.
    std::uint64_t percent = 10;
};
/// Tetrahedra whose corners are random points of spheres, not too flat.
[[nodiscard]] SceneInput3 random_tetrahedra(const Bodies& parameters, std::uint64_t seed);
/// L-shaped prisms, not convex, turned at random. 12 vertices, 18 edges, 8 faces each.
[[nodiscard]] SceneInput3 random_l_shapes(const Bodies& parameters, std::uint64_t seed);
/// Needles: tetrahedra some 30 times longer than wide.
[[nodiscard]] SceneInput3 thin_tetrahedra(const Bodies& parameters, std::uint64_t seed);
/// Sheets: triangles some 30 times longer than wide.
[[nodiscard]] SceneInput3 thin_triangles(const Bodies& parameters, std::uint64_t seed);
/// Axis-parallel boxes.
[[nodiscard]] SceneInput3 random_boxes(const Bodies& parameters, std::uint64_t seed);
/// Boxes, exactly right-angled, each turned at random (by a rational rotation).
[[nodiscard]] SceneInput3 turned_boxes(const Bodies& parameters, std::uint64_t seed);

struct Polytopes {
    std::size_t count = 10;
    /// Edges n/k of a body on average, 6 … 1000: bodies have ⌊V/k⌋ or ⌈V/k⌉ vertices, where
    /// V = round(k (n/k + 6) / 3) is their number in all.
    std::size_t edges_per_body = 20;
    std::uint64_t percent = 10;  ///< see Bodies
};
/// The benchmark of skeleton sizes: hulls of random points of spheres, in general position (no four vertices of
/// a body coplanar, no edge parallel to an axis), in disjoint balls of equal radius placed at random in a cube.
/// In all V vertices (see above), 3 V − 6 k edges, 2 V − 4 k triangles: for n/k = 20, 26 k/3 vertices, 20 k edges
/// and 40 k/3 faces when 3 divides k; k = 60 has 520, 1200 and 800.
/// Model: L. Zhang, H. Everett, S. Lazard, C. Weibel, S. Whitesides, "On the size of the 3D visibility skeleton:
/// experimental results" (ESA 2008).
[[nodiscard]] SceneInput3 random_polytopes(const Polytopes& parameters, std::uint64_t seed);

// ---- lattices and contacts: degenerate -----------------------------------------------------------------------

struct Grid3 {
    std::size_t columns = 3;
    std::size_t rows = 3;
    std::size_t layers = 3;
};
/// Equal boxes on a cubic lattice. Fully degenerate; the seed is not used.
[[nodiscard]] SceneInput3 grid3(const Grid3& parameters, std::uint64_t seed = 0);
/// The grid after one rational rotation: as degenerate, and no edge is parallel to an axis.
[[nodiscard]] SceneInput3 rotated_grid3(const Grid3& parameters, std::uint64_t seed = 0);
/// The grid with each corner moved at random (hulls of eight points): generic, 8, 18, 12 a body.
[[nodiscard]] SceneInput3 perturbed_grid3(const Grid3& parameters, std::uint64_t seed);
/// The grid with each box turned at random about its centre.
[[nodiscard]] SceneInput3 turned_grid3(const Grid3& parameters, std::uint64_t seed);
/// The cubes with even coordinate sum of a lattice without gaps: neighbours share an edge (a slit, but sealed
/// from four sides at most by two bodies), and eight cells meet in each inner corner.
[[nodiscard]] SceneInput3 checkerboard3(const Grid3& parameters, std::uint64_t seed = 0);
/// All cubes of a lattice without gaps, as bodies of their own: everything inside is sealed.
[[nodiscard]] SceneInput3 packed_grid3(const Grid3& parameters, std::uint64_t seed = 0);

enum class Contact : std::uint8_t {
    face,            ///< two cubes share a face
    partial_face,    ///< a piece of a face
    box_on_table,    ///< a box stands within the top of another
    edge,            ///< an edge
    partial_edge,    ///< a piece of an edge
    edge_on_face,    ///< an edge of one lies within a face of the other
    vertex,          ///< a vertex
    vertex_on_face,  ///< a vertex of one lies within a face of the other
    vertex_on_edge,  ///< … within an edge
    edge_crossing,   ///< two edges cross within both
};
inline constexpr std::size_t contact_count = 10;
/// Two bodies that touch so.
[[nodiscard]] SceneInput3 touching(Contact contact);

struct Boxes {
    std::size_t boxes = 8;
};
/// Boxes on each other, shifted at random: each shares a piece of a face with the next.
[[nodiscard]] SceneInput3 stacked_boxes(const Boxes& parameters, std::uint64_t seed);
/// Boxes in a chain, each sharing a face, an edge, a vertex, or a piece of a face or of an edge with the next.
[[nodiscard]] SceneInput3 touching_chain3(const Boxes& parameters, std::uint64_t seed);
/// Up to eight unit cubes round one vertex: that many of the eight octants, by chance which.
[[nodiscard]] SceneInput3 cubes_round_vertex(const Boxes& parameters, std::uint64_t seed);

/// Two boxes and a triangle (as a thin plate) in general position: lines that graze an edge of each box and an edge
/// of the triangle form a swath that is easy to see. 22 vertices, 33 edges, 17 faces.
[[nodiscard]] SceneInput3 two_boxes_triangle();

// ---- rooms, buildings, land -----------------------------------------------------------------------------------

struct Room {
    std::size_t polygons =
        1500;  ///< faces in all, world or floor included; rounded down to a multiple of 6; ≥ 12
    bool turned =
        false;  ///< pieces of furniture are turned round the vertical; else by right angles only
    bool lifted = false;  ///< every box is a little smaller, so that nothing touches anything
    bool world = true;  ///< the room is the free world (the first mesh); else furniture on a floor
};
/// The benchmark of large scenes: a room with tables, chairs, cupboards, shelves with books, lamps and crates, all
/// made of boxes that touch in faces (legs and table top, books and board, legs and floor).
/// POLYGONS faces, 4/3 POLYGONS vertices, 2 POLYGONS edges: for 1500, 2000 vertices, 3000 edges, 1500 faces, 250
/// bodies, the world included. Fully degenerate unless turned; then degenerate within each piece.
[[nodiscard]] SceneInput3 room_with_furniture(const Room& parameters, std::uint64_t seed);

struct Building {
    std::size_t columns = 3;
    std::size_t rows = 2;
    bool world =
        true;  ///< outer walls, floor and ceiling are the world; else walls on a slab, open above
};
/// Rooms side by side; pillars at their corners, walls with a door (not convex: ten faces) or, one in four, without.
[[nodiscard]] SceneInput3 building(const Building& parameters, std::uint64_t seed);

struct City3 {
    std::size_t columns = 5;
    std::size_t rows = 5;
};
/// A ground slab with blocks of houses: single ones, two that touch, ones with a tower on top.
[[nodiscard]] SceneInput3 city3(const City3& parameters, std::uint64_t seed);

struct Terrain {
    std::size_t levels = 3;  ///< a height field over 2^levels × 2^levels squares, each cut in two
    bool solid = false;      ///< with walls and a bottom; else a sheet
};
/// Fractal land (diamond-square). 2 · 4^levels triangles and, for a solid, 2^(levels + 2) walls and a bottom.
[[nodiscard]] SceneInput3 terrain(const Terrain& parameters, std::uint64_t seed);

// ---- subdivided curved surfaces ---------------------------------------------------------------------------------

struct Icosphere {
    std::size_t levels = 2;  ///< 20 · 4^levels triangles near a sphere
};
[[nodiscard]] SceneInput3 icosphere(const Icosphere& parameters);

struct Torus {
    std::size_t around = 12;  ///< the axis
    std::size_t across = 8;   ///< sides of the tube
};
/// A torus of 2 · around · across triangles.
[[nodiscard]] SceneInput3 torus(const Torus& parameters);

struct Cylinder {
    std::size_t sides = 12;
    std::size_t stacks = 4;
};
/// A prism whose sides are cut into stacks: its features are those of the prism.
[[nodiscard]] SceneInput3 cylinder(const Cylinder& parameters);

// ---- special position -------------------------------------------------------------------------------------------
// Disjoint tetrahedra whose planes, edges or vertices are aligned. Each family also comes nearly aligned: `near`,
// every coordinate but zeros moved up or down by one ulp, or not, at random.

struct Aligned {
    std::size_t count = 8;
    bool near = false;
};
/// Each has a face in one slanted plane, on either side of it.
[[nodiscard]] SceneInput3 coplanar_faces(const Aligned& parameters, std::uint64_t seed);
/// Each has an edge on one slanted line.
[[nodiscard]] SceneInput3 collinear_edges(const Aligned& parameters, std::uint64_t seed);
/// Each has an edge whose line passes through the origin, which is free.
[[nodiscard]] SceneInput3 concurrent_edges(const Aligned& parameters, std::uint64_t seed);
/// Each has an edge on z = xy (a ruling x = 4 i): all lines y = const, |y| < 4, z = xy graze all of these edges and
/// are free, a regulus.
[[nodiscard]] SceneInput3 regulus_edges(const Aligned& parameters, std::uint64_t seed);
/// A table, the first, and bodies with one vertex in the plane of its top, all others above.
[[nodiscard]] SceneInput3 vertices_in_plane(const Aligned& parameters, std::uint64_t seed);

/// Four edges with one double transversal, the line y = z = 0, which is free: three rulings of z = xy and a tangent
/// of this surface. `ulps` lifts the tangent by so many ulps: when positive there are two transversals, when negative
/// none. −100 … 100.
[[nodiscard]] SceneInput3 double_root(int ulps = 0);

/// The grid with its faces cut into triangles and each coordinate moved by an ulp at random.
[[nodiscard]] SceneInput3 near_grid3(const Grid3& parameters, std::uint64_t seed);

struct FarPolytopes {
    std::size_t count = 5;
    double shift = 0;  ///< a whole number below 2^52, added to x, subtracted from y, added to z
    int exponent = 0;  ///< all coordinates are multiplied by 2^exponent; −1074 … 900
};
/// random_polytopes (n/k = 20), moved and scaled exactly.
[[nodiscard]] SceneInput3 far_polytopes(const FarPolytopes& parameters, std::uint64_t seed);

// ---- by name -----------------------------------------------------------------------------------------------

/// A named family, as `sightline generate` knows it.
struct FamilyInfo3 {
    std::string_view name;
    std::string_view description;  ///< one line
    std::span<const FamilyParameter> parameters;
    bool degenerate =
        false;  ///< coplanar, touching or aligned features by construction, or nearly so
    SceneInput3 (*generate)(std::span<const std::uint64_t> parameters,
                            std::uint64_t seed) = nullptr;
};

/// All families, sorted by name; no name is one of all2().
[[nodiscard]] std::span<const FamilyInfo3> all3();

/// The scene of the named family; parameters that are not given take their defaults. Errors as for generate2.
[[nodiscard]] Result<SceneInput3> generate3(std::string_view name,
                                            std::span<const std::string> parameters,
                                            std::uint64_t seed);

}  // namespace sightline::families
