// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sightline/scene/result.hpp"
#include "sightline/scene/scene2.hpp"

/// Scene generators. Each is a function of its parameters and a seed and of nothing else: the same bytes on
/// every platform (std::mt19937_64, own mapping to integers, no library function that may round otherwise).
/// Every scene passes Scene2::make. Coordinates are integers unless the comment says otherwise.
/// Parameters out of the range that `all2()` lists break the contract (SIGHTLINE_EXPECT);
/// `generate2` returns an error instead.
namespace sightline::families {

// ---- random convex bodies ------------------------------------------------------------------------------

enum class Density : std::uint8_t {
    sparse,  ///< bodies cover about 1 % of the square: sight is long
    dense,   ///< about 11 %: sight is short
    packed   ///< about 70 %: neighbours see each other and little else
};

struct ConvexBodies {
    std::size_t vertices = 1000;  ///< of all bodies together (triangles to octagons), ≥ 3
    Density density = Density::dense;
    bool world = true;  ///< a world around them: a nearly square ring of 4 more vertices
};
/// Random disjoint strictly convex polygons (Valtr, "Probability that n random points are in convex
/// position", 1995). Expected O(vertices) time: bodies are placed with a grid of boxes and an exact
/// separating-axis test.
[[nodiscard]] SceneInput2 random_convex(const ConvexBodies& parameters, std::uint64_t seed);

struct ScaledConvex {
    std::size_t vertices = 200;
    int exponent = 478;  ///< coordinates are integers below 2^26 times 2^exponent; −1074 … 990
};
/// `random_convex` (dense, with a world) times a power of two: 478 gives coordinates near 1e150, −518 ones
/// near 1e−150, −1074 denormal ones. Products of three (at more extreme exponents, of two) overflow or
/// underflow.
[[nodiscard]] SceneInput2 scaled_convex(const ScaledConvex& parameters, std::uint64_t seed);

struct Needles {
    std::size_t count = 100;
};
/// Disjoint triangles in random directions, thousands of times longer than wide.
[[nodiscard]] SceneInput2 needles(const Needles& parameters, std::uint64_t seed);

struct PolygonsWithHoles {
    std::size_t polygons = 4;
    std::size_t holes = 5;  ///< in each
};
/// Jagged polygons with convex holes; in every second hole, where there is room, lies another body.
[[nodiscard]] SceneInput2 polygons_with_holes(const PolygonsWithHoles& parameters,
                                              std::uint64_t seed);

// ---- random simple polygons ----------------------------------------------------------------------------

struct SimplePolygon {
    std::size_t vertices = 100;
    bool world = false;  ///< the polygon is the free world instead of a body
};
/// A polygon that is star-shaped about the origin, through random points. O(n log n).
[[nodiscard]] SceneInput2 star_shaped(const SimplePolygon& parameters, std::uint64_t seed);
/// A simple polygon, as a rule not star-shaped, through random points, by space partitioning (Auer, Held,
/// "Heuristics for the generation of random polygons", 1996). Expected O(n log n).
[[nodiscard]] SceneInput2 simple_polygon(const SimplePolygon& parameters, std::uint64_t seed);

struct SimplePolygons {
    std::size_t polygons = 16;
    std::size_t vertices = 12;  ///< of each
};
/// Disjoint simple polygons, one in each cell of a square grid.
[[nodiscard]] SceneInput2 simple_polygons(const SimplePolygons& parameters, std::uint64_t seed);

// ---- shapes --------------------------------------------------------------------------------------------

struct Comb {
    std::size_t teeth = 8;
    bool world = false;  ///< the comb is the free world: a hall with narrow bays
};
/// A comb with teeth of random lengths.
[[nodiscard]] SceneInput2 comb(const Comb& parameters, std::uint64_t seed);
/// Two combs whose teeth point at each other and interlock without touching.
[[nodiscard]] SceneInput2 facing_combs(const Comb& parameters, std::uint64_t seed);

struct Spiral {
    std::size_t corners = 16;
    bool world = false;  ///< the spiral is a corridor, the free world
};
/// A rectangular spiral of constant width. The seed chooses one of its 8 symmetric images.
[[nodiscard]] SceneInput2 spiral(const Spiral& parameters, std::uint64_t seed);

struct Star {
    std::size_t spikes = 8;
    bool world = false;
};
/// A star polygon with spikes of random lengths.
[[nodiscard]] SceneInput2 star(const Star& parameters, std::uint64_t seed);

struct Pinwheel {
    std::size_t blades = 8;
};
/// Thin triangles that leave a common circle along its tangents, all in one sense: each blade's line passes
/// the next blade's foot, so what the centre sees is cyclic.
[[nodiscard]] SceneInput2 pinwheel(const Pinwheel& parameters, std::uint64_t seed);

// ---- degenerate scenes -----------------------------------------------------------------------------------

struct Grid {
    std::size_t columns = 5;
    std::size_t rows = 5;
};
/// Equal boxes on a square lattice. Fully degenerate; the seed is not used.
[[nodiscard]] SceneInput2 grid(const Grid& parameters, std::uint64_t seed = 0);

struct RotatedGrid {
    std::size_t columns = 5;
    std::size_t rows = 5;
    std::int64_t a = 3;  ///< each point (x, y) goes to (a x − b y, b x + a y): with a Pythagorean
    std::int64_t b = 4;  ///< pair (3, 4), (5, 12), (8, 15)… a rotation times an integer, so exact
};
/// `grid` after an exact rotation: as degenerate as the grid, and no line is parallel to an axis.
[[nodiscard]] SceneInput2 rotated_grid(const RotatedGrid& parameters, std::uint64_t seed = 0);

/// `grid` with walls: along sides of boxes, from corner to corner across streets, crossing in an X in each
/// square between four boxes, ending on a side; and a point on every third crossing.
[[nodiscard]] SceneInput2 grid_with_walls(const Grid& parameters, std::uint64_t seed);

/// The black squares of a checkerboard: every inner corner is a pinhole that two bodies touch.
[[nodiscard]] SceneInput2 checkerboard(const Grid& parameters, std::uint64_t seed = 0);

/// Tiles of four boxes round a square hole, each box sealed to the next by a piece of an edge.
[[nodiscard]] SceneInput2 pinwheel_tiles(const Grid& parameters, std::uint64_t seed = 0);

enum class ChainKind : std::uint8_t {
    corners,  ///< each box shares a corner with the next
    edges,    ///< each box shares a piece of an edge with the next
    mixed,  ///< corners, pieces, whole edges, and corners that touch the inside of an edge; random
    ring    ///< boxes round a square, each sharing an edge with the next: they seal off the inside
};
struct Chain {
    std::size_t boxes = 16;
    ChainKind kind = ChainKind::mixed;
};
/// Boxes that touch one after the other. `ring` rounds their number up to a multiple of 4, at least 8.
[[nodiscard]] SceneInput2 touching_chain(const Chain& parameters, std::uint64_t seed);

struct Pinched {
    std::size_t lobes = 6;
    bool world = false;
};
/// One polygon whose ring touches itself: diamonds in a row, joined at a point each, with a hole in each
/// diamond that touches the ring in a point.
[[nodiscard]] SceneInput2 pinched(const Pinched& parameters, std::uint64_t seed);

struct Count {
    std::size_t count = 50;
};
/// Triangles whose tips lie within one ulp of the line y = x/3 + 1/7 (not integers), from both sides, and an
/// x-monotone wall whose inner points do the same for another line.
[[nodiscard]] SceneInput2 near_collinear(const Count& parameters, std::uint64_t seed);
/// Triangles one ulp high (not integers).
[[nodiscard]] SceneInput2 slivers(const Count& parameters, std::uint64_t seed);
/// Triangles with an edge each on one line of slope 24/7, on either side of it.
[[nodiscard]] SceneInput2 collinear_bodies(const Count& parameters, std::uint64_t seed);
/// Points on one line of slope 24/7, in random order.
[[nodiscard]] SceneInput2 collinear_points(const Count& parameters, std::uint64_t seed);
/// Walls along one line of slope 24/7, some sharing an end, some apart.
[[nodiscard]] SceneInput2 collinear_walls(const Count& parameters, std::uint64_t seed);
/// Triangles of sizes 2^k for k around 0, in a row (not integers): up to 1e±300 in one scene.
[[nodiscard]] SceneInput2 magnitudes(const Count& parameters, std::uint64_t seed);

// ---- plans and walls ---------------------------------------------------------------------------------------

struct City {
    std::size_t columns = 5;
    std::size_t rows = 5;
};
/// Blocks with streets of a few widths: single houses, touching rows, L-shapes, courtyards, squares.
[[nodiscard]] SceneInput2 city(const City& parameters, std::uint64_t seed);

struct FloorPlan {
    std::size_t columns = 12;  ///< of unit cells, of which rooms are made
    std::size_t rows = 12;
    bool thick =
        true;  ///< walls have a thickness and the world one ring and holes; else walls are polylines
};
/// Rooms by recursive division, a door or two in every wall between. The same seed gives the same plan with
/// thick and with thin walls.
[[nodiscard]] SceneInput2 floor_plan(const FloorPlan& parameters, std::uint64_t seed);

struct Cave {
    std::size_t columns = 32;
    std::size_t rows = 32;
};
/// A world with holes traced on the unit lattice, like the maps of computer games (cellular automaton):
/// many collinear vertices, and rings that touch in points.
[[nodiscard]] SceneInput2 cave(const Cave& parameters, std::uint64_t seed);

struct Walls {
    std::size_t count = 100;
    bool crossing = false;  ///< walls may cross; otherwise they are disjoint
};
/// Random walls, each a single segment.
[[nodiscard]] SceneInput2 random_walls(const Walls& parameters, std::uint64_t seed);

// ---- by name -----------------------------------------------------------------------------------------------

/// A whole-number parameter of a named family.
struct FamilyParameter {
    std::string_view name;
    std::uint64_t default_value = 0;
    std::uint64_t least = 0;
    std::uint64_t greatest = 0;
};

/// A named family, as `sightline generate` knows it.
struct FamilyInfo {
    std::string_view name;
    std::string_view description;  ///< one line
    std::span<const FamilyParameter> parameters;
    bool degenerate =
        false;  ///< collinear, touching or coincident features by construction, or nearly so
    SceneInput2 (*generate)(std::span<const std::uint64_t> parameters,
                            std::uint64_t seed) = nullptr;
};

/// All families, sorted by name.
[[nodiscard]] std::span<const FamilyInfo> all2();

/// The scene of the named family; parameters that are not given take their defaults.
/// Fails with bad_parameter: an unknown name (the message lists the nearest ones), too many parameters, or
/// one that is no whole number in its range.
[[nodiscard]] Result<SceneInput2> generate2(std::string_view name,
                                            std::span<const std::string> parameters,
                                            std::uint64_t seed);

}  // namespace sightline::families
