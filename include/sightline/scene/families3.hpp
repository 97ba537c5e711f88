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
