// SPDX-License-Identifier: GPL-3.0-or-later
// The families of 3D scenes by name.
#include "sightline/scene/families3.hpp"

#include "scene/families_registry.hpp"

namespace sightline::families {

namespace {

using Parameters = std::span<const std::uint64_t>;
using Seed = std::uint64_t;

// The parameter lists that families share: name, default, least, greatest.
constexpr FamilyParameter bodies_parameters[] = {{"COUNT", 10, 1, 100'000}, {"PERCENT", 10, 1, 30}};
constexpr FamilyParameter polytope_parameters[] = {
    {"COUNT", 10, 1, 100'000}, {"EDGES", 20, 6, 1000}, {"PERCENT", 10, 1, 30}};
constexpr FamilyParameter grid_parameters[] = {
    {"COLUMNS", 3, 1, 100}, {"ROWS", 3, 1, 100}, {"LAYERS", 3, 1, 100}};
constexpr FamilyParameter sides_parameters[] = {{"SIDES", 6, 3, 1000}};
constexpr FamilyParameter teeth_parameters[] = {{"TEETH", 4, 1, 100'000}};
constexpr FamilyParameter boxes_parameters[] = {{"BOXES", 8, 1, 100'000}};
constexpr FamilyParameter octant_parameters[] = {{"BOXES", 8, 1, 8}};

constexpr FamilyParameter room_parameters[] = {
    {"POLYGONS", 1500, 12, 100'000}, {"TURNED", 0, 0, 1}, {"LIFTED", 0, 0, 1}};
constexpr FamilyParameter building_parameters[] = {{"COLUMNS", 3, 1, 100}, {"ROWS", 2, 1, 100}};
constexpr FamilyParameter city_parameters[] = {{"COLUMNS", 5, 1, 200}, {"ROWS", 5, 1, 200}};
constexpr FamilyParameter terrain_parameters[] = {{"LEVELS", 3, 0, 10}};
constexpr FamilyParameter sphere_parameters[] = {{"LEVELS", 2, 0, 7}};
constexpr FamilyParameter torus_parameters[] = {{"AROUND", 12, 3, 1000}, {"ACROSS", 8, 3, 1000}};
constexpr FamilyParameter cylinder_parameters[] = {{"SIDES", 12, 3, 1000}, {"STACKS", 4, 1, 1000}};
constexpr FamilyParameter aligned_parameters[] = {{"COUNT", 8, 1, 10'000}};
constexpr FamilyParameter few_parameters[] = {{"COUNT", 5, 1, 10'000}};

template <SolidShape shape>
SceneInput3 shaped(Parameters /*p*/, Seed /*seed*/) {
    return solid(shape);
}
template <Contact contact>
SceneInput3 contacting(Parameters /*p*/, Seed /*seed*/) {
    return touching(contact);
}
/// Families of one configuration.
template <auto generate>
SceneInput3 single(Parameters /*p*/, Seed /*seed*/) {
    return generate();
}
/// Families with one size.
template <auto generate>
SceneInput3 counted(Parameters p, Seed seed) {
    return generate({p[0]}, seed);
}
template <auto generate>
SceneInput3 counted_seedless(Parameters p, Seed /*seed*/) {
    return generate({p[0]});
}
template <auto generate>
SceneInput3 paired(Parameters p, Seed seed) {
    return generate({p[0], p[1]}, seed);
}
template <auto generate>
SceneInput3 tripled(Parameters p, Seed seed) {
    return generate({p[0], p[1], p[2]}, seed);
}
template <auto generate>
SceneInput3 paired_seedless(Parameters p, Seed /*seed*/) {
    return generate({p[0], p[1]});
}
template <bool world>
SceneInput3 room(Parameters p, Seed seed) {
    return room_with_furniture(
        {.polygons = p[0], .turned = p[1] == 1, .lifted = p[2] == 1, .world = world}, seed);
}
template <bool world>
SceneInput3 building_of(Parameters p, Seed seed) {
    return building({.columns = p[0], .rows = p[1], .world = world}, seed);
}
template <bool solid>
SceneInput3 land(Parameters p, Seed seed) {
    return terrain({.levels = p[0], .solid = solid}, seed);
}
/// Families in special position, exactly or nearly.
template <auto generate, bool near>
SceneInput3 aligned(Parameters p, Seed seed) {
    return generate({.count = p[0], .near = near}, seed);
}
template <int ulps>
SceneInput3 rooted(Parameters /*p*/, Seed /*seed*/) {
    return double_root(ulps);
}
template <int exponent>
SceneInput3 scaled(Parameters p, Seed seed) {
    return far_polytopes({.count = p[0], .exponent = exponent}, seed);
}
SceneInput3 far_of(Parameters p, Seed seed) {
    return far_polytopes({.count = p[0], .shift = 1e8}, seed);
}
SceneInput3 comb_of(Parameters p, Seed seed) { return comb3({.teeth = p[0]}, seed); }

constexpr bool degenerate = true;
constexpr bool generic = false;

// Sorted by name.
constexpr FamilyInfo3 table[] = {
    {"boxes", "random disjoint axis-parallel boxes", bodies_parameters, degenerate,
     paired<random_boxes>},
    {"boxes-turned", "random disjoint boxes, each turned at random", bodies_parameters, generic,
     paired<turned_boxes>},
    {"building", "rooms with doors, in a world", building_parameters, degenerate,
     building_of<true>},
    {"building-walls", "walls with doors on a slab", building_parameters, degenerate,
     building_of<false>},
    {"chain3", "cubes that share faces, edges, vertices and pieces of these", boxes_parameters,
     degenerate, counted<touching_chain3>},
    {"checkerboard3", "cubes with even coordinate sum: neighbours share edges", grid_parameters,
     degenerate, tripled<checkerboard3>},
    {"city3", "houses of different heights on the ground", city_parameters, degenerate,
     paired<city3>},
    {"collinear3", "tetrahedra with an edge each on one slanted line", aligned_parameters,
     degenerate, aligned<collinear_edges, false>},
    {"comb3", "a solid comb with teeth of random lengths", teeth_parameters, degenerate, comb_of},
    {"concurrent", "tetrahedra with an edge each through one point", aligned_parameters, degenerate,
     aligned<concurrent_edges, false>},
    {"coplanar", "tetrahedra with a face each in one slanted plane", aligned_parameters, degenerate,
     aligned<coplanar_faces, false>},
    {"cube", "a cube", {}, degenerate, shaped<SolidShape::cube>},
    {"cubes-round-vertex", "cubes in some of the octants round a vertex", octant_parameters,
     degenerate, counted<cubes_round_vertex>},
    {"cylinder", "a prism whose sides are cut into stacks", cylinder_parameters, degenerate,
     paired_seedless<cylinder>},
    {"denormal3", "polytopes with denormal coordinates", few_parameters, generic, scaled<-1074>},
    {"dodecahedron",
     "a pyritohedron: twelve pentagons",
     {},
     degenerate,
     shaped<SolidShape::dodecahedron>},
    {"double-root", "four edges with one double transversal", {}, degenerate, rooted<0>},
    {"double-root-missed", "the same an ulp too low: no transversal", {}, degenerate, rooted<-1>},
    {"double-root-split", "the same an ulp too high: two transversals", {}, degenerate, rooted<1>},
    {"far3", "polytopes some 1e8 from the origin", few_parameters, generic, far_of},
    {"furniture", "the furniture of a room on a floor, without a world", room_parameters,
     degenerate, room<false>},
    {"grid3", "equal boxes on a cubic lattice", grid_parameters, degenerate, tripled<grid3>},
    {"grid3-near", "the lattice in triangles, each coordinate moved by an ulp or not",
     grid_parameters, degenerate, tripled<near_grid3>},
    {"grid3-packed", "a lattice of cubes without gaps", grid_parameters, degenerate,
     tripled<packed_grid3>},
    {"grid3-perturbed", "the lattice with each corner moved at random", grid_parameters, generic,
     tripled<perturbed_grid3>},
    {"grid3-rotated", "the lattice after one rational rotation", grid_parameters, degenerate,
     tripled<rotated_grid3>},
    {"grid3-turned", "the lattice with each box turned at random", grid_parameters, generic,
     tripled<turned_grid3>},
    {"huge3", "polytopes with coordinates near 1e150", few_parameters, generic, scaled<478>},
    {"icosahedron",
     "twenty triangles, nearly regular",
     {},
     degenerate,
     shaped<SolidShape::icosahedron>},
    {"icosphere", "a subdivided icosahedron near a sphere", sphere_parameters, generic,
     counted_seedless<icosphere>},
    {"l-shape", "a cube less a quarter", {}, degenerate, shaped<SolidShape::l_shape>},
    {"l-shapes", "random disjoint L-shaped prisms, each turned at random", bodies_parameters,
     generic, paired<random_l_shapes>},
    {"near-collinear3", "collinear3 with each coordinate moved by an ulp or not",
     aligned_parameters, degenerate, aligned<collinear_edges, true>},
    {"near-concurrent", "concurrent with each coordinate moved by an ulp or not",
     aligned_parameters, degenerate, aligned<concurrent_edges, true>},
    {"near-coplanar", "coplanar with each coordinate moved by an ulp or not", aligned_parameters,
     degenerate, aligned<coplanar_faces, true>},
    {"near-regulus", "regulus with each coordinate moved by an ulp or not", aligned_parameters,
     degenerate, aligned<regulus_edges, true>},
    {"near-vertices-in-plane", "vertices-in-plane with each coordinate moved by an ulp or not",
     aligned_parameters, degenerate, aligned<vertices_in_plane, true>},
    {"needles3", "random disjoint tetrahedra 30 times longer than wide", bodies_parameters, generic,
     paired<thin_tetrahedra>},
    {"notched-cube", "a cube less a corner", {}, degenerate, shaped<SolidShape::notched_cube>},
    {"octahedron", "a regular octahedron", {}, degenerate, shaped<SolidShape::octahedron>},
    {"polytopes", "random disjoint hulls of points of spheres, EDGES each on average",
     polytope_parameters, generic, tripled<random_polytopes>},
    {"prism", "a prism on a convex polygon", sides_parameters, degenerate, counted_seedless<prism>},
    {"pyramid", "a pyramid on a convex polygon", sides_parameters, degenerate,
     counted_seedless<pyramid>},
    {"regulus", "tetrahedra with an edge each in one regulus", aligned_parameters, degenerate,
     aligned<regulus_edges, false>},
    {"ring", "a square torus: two faces with a hole", {}, degenerate, shaped<SolidShape::ring>},
    {"room", "a room with furniture, POLYGONS faces, as a world", room_parameters, degenerate,
     room<true>},
    {"stack", "boxes on each other, shifted at random", boxes_parameters, degenerate,
     counted<stacked_boxes>},
    {"terrain", "fractal land, as a sheet", terrain_parameters, generic, land<false>},
    {"terrain-solid", "fractal land with walls and a bottom", terrain_parameters, degenerate,
     land<true>},
    {"tetrahedra", "random disjoint tetrahedra", bodies_parameters, generic,
     paired<random_tetrahedra>},
    {"tetrahedron", "a regular tetrahedron", {}, generic, shaped<SolidShape::tetrahedron>},
    {"tiny3", "polytopes with coordinates near 1e-150", few_parameters, generic, scaled<-518>},
    {"torus", "a torus of triangles", torus_parameters, degenerate, paired_seedless<torus>},
    {"touching-box-on-table",
     "a box within the top of another",
     {},
     degenerate,
     contacting<Contact::box_on_table>},
    {"touching-edge", "two cubes share an edge", {}, degenerate, contacting<Contact::edge>},
    {"touching-edge-crossing",
     "edges of two bodies cross in a point",
     {},
     degenerate,
     contacting<Contact::edge_crossing>},
    {"touching-edge-on-face",
     "an edge within a face of another body",
     {},
     degenerate,
     contacting<Contact::edge_on_face>},
    {"touching-face", "two cubes share a face", {}, degenerate, contacting<Contact::face>},
    {"touching-partial-edge",
     "two boxes share a piece of an edge",
     {},
     degenerate,
     contacting<Contact::partial_edge>},
    {"touching-partial-face",
     "two boxes share a piece of a face",
     {},
     degenerate,
     contacting<Contact::partial_face>},
    {"touching-vertex", "two cubes share a vertex", {}, degenerate, contacting<Contact::vertex>},
    {"touching-vertex-on-edge",
     "a vertex within an edge of another body",
     {},
     degenerate,
     contacting<Contact::vertex_on_edge>},
    {"touching-vertex-on-face",
     "a vertex within a face of another body",
     {},
     degenerate,
     contacting<Contact::vertex_on_face>},
    {"triangles", "random disjoint thin triangles, as sheets", bodies_parameters, generic,
     paired<thin_triangles>},
    {"two-boxes-triangle",
     "two turned boxes and a plate between them",
     {},
     generic,
     single<two_boxes_triangle>},
    {"u-shape", "a bar with two arms", {}, degenerate, shaped<SolidShape::u_shape>},
    {"vertices-in-plane", "tetrahedra with a vertex each in the plane of a table",
     aligned_parameters, degenerate, aligned<vertices_in_plane, false>},
};

}  // namespace

std::span<const FamilyInfo3> all3() { return table; }

Result<SceneInput3> generate3(std::string_view name, std::span<const std::string> parameters,
                              std::uint64_t seed) {
    Result<SceneInput3> scene = detail::generate_by_name(table, name, parameters, seed);
    if (!scene) return scene;
    for (MeshInput3& mesh : scene->meshes) mesh.file = std::string(name);
    return scene;
}

}  // namespace sightline::families
