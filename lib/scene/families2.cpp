// SPDX-License-Identifier: GPL-3.0-or-later
// The families by name.
#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <utility>
#include <vector>

#include "sightline/scene/families.hpp"

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

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

/// The three names nearest to an unknown one; names that contain it, or it them, come first.
std::string nearest_names(std::string_view name) {
    std::vector<std::pair<std::size_t, std::string_view>> ranked;
    for (const FamilyInfo& family : table) {
        const bool related = !name.empty() && (family.name.find(name) != std::string_view::npos ||
                                               name.find(family.name) != std::string_view::npos);
        const std::size_t distance = edit_distance(name, family.name);
        ranked.emplace_back(related ? distance / 4 : distance, family.name);
    }
    std::partial_sort(ranked.begin(), ranked.begin() + 3, ranked.end());
    return std::string(ranked[0].second) + ", " + std::string(ranked[1].second) + " or " +
           std::string(ranked[2].second);
}

Result<std::uint64_t> parse(const FamilyInfo& family, const FamilyParameter& parameter,
                            const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    const bool whole = error == std::errc{} && stopped == end;
    if (whole && value >= parameter.least && value <= parameter.greatest) return value;
    return fail(Errc::bad_parameter,
                "generate " + std::string(family.name) + ": " + std::string(parameter.name) +
                    " is '" + text + "'; give a whole number from " +
                    std::to_string(parameter.least) + " to " + std::to_string(parameter.greatest));
}

}  // namespace

std::span<const FamilyInfo> all2() { return table; }

Result<SceneInput2> generate2(std::string_view name, std::span<const std::string> parameters,
                              std::uint64_t seed) {
    const auto* const family = std::find_if(std::begin(table), std::end(table),
                                            [&](const FamilyInfo& f) { return f.name == name; });
    if (family == std::end(table)) {
        return fail(Errc::bad_parameter, "generate: there is no family '" + std::string(name) +
                                             "'; the nearest are " + nearest_names(name));
    }
    if (parameters.size() > family->parameters.size()) {
        return fail(Errc::bad_parameter, "generate " + std::string(name) + ": " +
                                             std::to_string(parameters.size()) +
                                             " parameters given; leave out all after the first " +
                                             std::to_string(family->parameters.size()));
    }
    std::vector<std::uint64_t> values;
    for (std::size_t i = 0; i < family->parameters.size(); ++i) {
        const FamilyParameter& parameter = family->parameters[i];
        if (i >= parameters.size()) {
            values.push_back(parameter.default_value);
            continue;
        }
        const Result<std::uint64_t> value = parse(*family, parameter, parameters[i]);
        if (!value) return tl::unexpected<Error>(value.error());
        values.push_back(*value);
    }
    SceneInput2 scene = family->generate(values, seed);
    scene.file = std::string(name);
    return scene;
}

}  // namespace sightline::families
