// SPDX-License-Identifier: GPL-3.0-or-later
// The families by name.
#include "sightline/scene/families.hpp"

#include "scene/families_registry.hpp"

namespace sightline::families {

namespace {

using Parameters = std::span<const std::uint64_t>;
using Seed = std::uint64_t;

// The parameter lists that families share: name, default, least, greatest.
constexpr FamilyParameter convex_parameters[] = {{"N", 1000, 3, 10'000'000}};
constexpr FamilyParameter scaled_parameters[] = {{"N", 200, 3, 1'000'000}};
constexpr FamilyParameter simple_parameters[] = {{"N", 100, 3, 1'000'000}};
constexpr FamilyParameter polygons_parameters[] = {{"POLYGONS", 16, 1, 100'000},
                                                   {"N", 12, 3, 10'000}};
constexpr FamilyParameter holes_parameters[] = {{"POLYGONS", 4, 1, 10'000},
                                                {"HOLES", 5, 1, 10'000}};
constexpr FamilyParameter teeth_parameters[] = {{"TEETH", 8, 1, 1'000'000}};
constexpr FamilyParameter corners_parameters[] = {{"CORNERS", 16, 1, 1'000'000}};
constexpr FamilyParameter spikes_parameters[] = {{"SPIKES", 8, 3, 100'000}};
constexpr FamilyParameter blades_parameters[] = {{"BLADES", 8, 3, 2000}};
constexpr FamilyParameter grid_parameters[] = {{"COLUMNS", 5, 1, 1000}, {"ROWS", 5, 1, 1000}};
constexpr FamilyParameter rotated_parameters[] = {
    {"COLUMNS", 5, 1, 1000}, {"ROWS", 5, 1, 1000}, {"A", 3, 1, 10'000}, {"B", 4, 0, 10'000}};
constexpr FamilyParameter boxes_parameters[] = {{"BOXES", 16, 1, 1'000'000}};
constexpr FamilyParameter lobes_parameters[] = {{"LOBES", 6, 1, 1'000'000}};
constexpr FamilyParameter count_parameters[] = {{"COUNT", 50, 1, 1'000'000}};
constexpr FamilyParameter magnitude_parameters[] = {{"COUNT", 50, 1, 1000}};
constexpr FamilyParameter city_parameters[] = {{"COLUMNS", 5, 1, 500}, {"ROWS", 5, 1, 500}};
constexpr FamilyParameter plan_parameters[] = {{"COLUMNS", 12, 1, 2000}, {"ROWS", 12, 1, 2000}};
constexpr FamilyParameter cave_parameters[] = {{"COLUMNS", 32, 8, 4000}, {"ROWS", 32, 8, 4000}};
constexpr FamilyParameter walls_parameters[] = {{"COUNT", 100, 1, 1'000'000}};

template <Density density, bool world>
SceneInput2 convex(Parameters p, Seed seed) {
    return random_convex({.vertices = p[0], .density = density, .world = world}, seed);
}
template <int exponent>
SceneInput2 scaled(Parameters p, Seed seed) {
    return scaled_convex({.vertices = p[0], .exponent = exponent}, seed);
}
/// Families with one size and a flag.
template <auto generate, bool world>
SceneInput2 sized(Parameters p, Seed seed) {
    return generate({p[0], world}, seed);
}
/// Families with one size.
template <auto generate>
SceneInput2 counted(Parameters p, Seed seed) {
    return generate({p[0]}, seed);
}
/// Families with columns and rows, or the like.
template <auto generate>
SceneInput2 paired(Parameters p, Seed seed) {
    return generate({p[0], p[1]}, seed);
}
template <ChainKind kind>
SceneInput2 chain(Parameters p, Seed seed) {
    return touching_chain({.boxes = p[0], .kind = kind}, seed);
}
template <bool thick>
SceneInput2 plan(Parameters p, Seed seed) {
    return floor_plan({.columns = p[0], .rows = p[1], .thick = thick}, seed);
}
SceneInput2 rotated(Parameters p, Seed seed) {
    return rotated_grid({.columns = p[0],
                         .rows = p[1],
                         .a = static_cast<std::int64_t>(p[2]),
                         .b = static_cast<std::int64_t>(p[3])},
                        seed);
}

constexpr bool degenerate = true;
constexpr bool generic = false;

// Sorted by name.
constexpr FamilyInfo table[] = {
    {"cave", "a world traced on the unit lattice, like the maps of games", cave_parameters,
     degenerate, paired<cave>},
    {"chain", "boxes and diamonds that touch in corners, edges and pieces of edges",
     boxes_parameters, degenerate, chain<ChainKind::mixed>},
    {"chain-corners", "boxes that share corners", boxes_parameters, degenerate,
     chain<ChainKind::corners>},
    {"chain-edges", "boxes that share pieces of edges", boxes_parameters, degenerate,
     chain<ChainKind::edges>},
    {"chain-ring", "boxes that share edges round a sealed square", boxes_parameters, degenerate,
     chain<ChainKind::ring>},
    {"checkerboard", "the black squares of a checkerboard, touching in corners", grid_parameters,
     degenerate, paired<checkerboard>},
    {"city", "blocks and streets: houses, rows, courtyards", city_parameters, degenerate,
     paired<city>},
    {"collinear", "triangles with an edge each on one slanted line", count_parameters, degenerate,
     counted<collinear_bodies>},
    {"collinear-points", "points on one slanted line", count_parameters, degenerate,
     counted<collinear_points>},
    {"collinear-walls", "walls along one slanted line, some sharing ends", count_parameters,
     degenerate, counted<collinear_walls>},
    {"comb", "a comb with teeth of random lengths", teeth_parameters, degenerate,
     sized<comb, false>},
    {"comb-room", "a hall with narrow bays, as world", teeth_parameters, degenerate,
     sized<comb, true>},
    {"combs", "two combs that interlock without touching", teeth_parameters, degenerate,
     sized<facing_combs, false>},
    {"denormal", "dense, with denormal coordinates", scaled_parameters, generic, scaled<-1074>},
    {"dense", "random disjoint convex polygons in a world, N + 4 vertices, short sight",
     convex_parameters, generic, convex<Density::dense, true>},
    {"dense-open", "the same without a world, N vertices", convex_parameters, generic,
     convex<Density::dense, false>},
    {"floor-plan", "rooms and doors, walls with a thickness", plan_parameters, degenerate,
     plan<true>},
    {"floor-plan-thin", "rooms and doors, walls of no thickness", plan_parameters, degenerate,
     plan<false>},
    {"grid", "equal boxes on a square lattice", grid_parameters, degenerate, paired<grid>},
    {"grid-rotated",
     "the grid after x + iy → (A + iB)(x + iy), an exact rotation for 3 4, 5 12, 8 15",
     rotated_parameters, degenerate, rotated},
    {"grid-walls", "the grid with walls along, between and across, and points on crossings",
     grid_parameters, degenerate, paired<grid_with_walls>},
    {"holes", "jagged polygons with convex holes and bodies in these", holes_parameters, generic,
     paired<polygons_with_holes>},
    {"huge", "dense, with coordinates near 1e150", scaled_parameters, generic, scaled<478>},
    {"magnitudes", "triangles of sizes 2^k in a row, k around 0", magnitude_parameters, generic,
     counted<magnitudes>},
    {"near-collinear", "tips and wall points within one ulp of a line", count_parameters,
     degenerate, counted<near_collinear>},
    {"needles", "disjoint triangles thousands of times longer than wide", count_parameters, generic,
     counted<needles>},
    {"packed", "random convex polygons packed tightly in a world, N + 4 vertices",
     convex_parameters, generic, convex<Density::packed, true>},
    {"packed-open", "the same without a world, N vertices", convex_parameters, generic,
     convex<Density::packed, false>},
    {"pinched", "a polygon whose ring and holes touch in points", lobes_parameters, degenerate,
     sized<pinched, false>},
    {"pinched-room", "the same as a world", lobes_parameters, degenerate, sized<pinched, true>},
    {"pinwheel", "thin triangles along the tangents of a circle", blades_parameters, generic,
     counted<pinwheel>},
    {"pinwheel-tiles", "tiles of four boxes sealed round a square hole", grid_parameters,
     degenerate, paired<pinwheel_tiles>},
    {"polygons", "random simple polygons side by side", polygons_parameters, generic,
     paired<simple_polygons>},
    {"simple", "a random simple polygon (space partitioning)", simple_parameters, generic,
     sized<simple_polygon, false>},
    {"simple-room", "the same as a world", simple_parameters, generic, sized<simple_polygon, true>},
    {"slivers", "triangles one ulp high", count_parameters, degenerate, counted<slivers>},
    {"sparse", "random disjoint convex polygons in a world, N + 4 vertices, long sight",
     convex_parameters, generic, convex<Density::sparse, true>},
    {"sparse-open", "the same without a world, N vertices", convex_parameters, generic,
     convex<Density::sparse, false>},
    {"spiral", "a rectangular spiral", corners_parameters, degenerate, sized<spiral, false>},
    {"spiral-room", "a rectangular spiral corridor, as world", corners_parameters, degenerate,
     sized<spiral, true>},
    {"star", "a star with spikes of random lengths", spikes_parameters, generic,
     sized<star, false>},
    {"star-room", "the same as a world", spikes_parameters, generic, sized<star, true>},
    {"star-shaped", "a random star-shaped polygon", simple_parameters, generic,
     sized<star_shaped, false>},
    {"star-shaped-room", "the same as a world", simple_parameters, generic,
     sized<star_shaped, true>},
    {"tiny", "dense, with coordinates near 1e-150", scaled_parameters, generic, scaled<-518>},
    {"walls", "random disjoint walls", walls_parameters, generic, sized<random_walls, false>},
    {"walls-crossing", "random walls that may cross", walls_parameters, generic,
     sized<random_walls, true>},
};

}  // namespace

std::span<const FamilyInfo> all2() { return table; }

Result<SceneInput2> generate2(std::string_view name, std::span<const std::string> parameters,
                              std::uint64_t seed) {
    Result<SceneInput2> scene = detail::generate_by_name(table, name, parameters, seed);
    if (scene) scene->file = std::string(name);
    return scene;
}

}  // namespace sightline::families
