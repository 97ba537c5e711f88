// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>

#include "scene/exact3.hpp"
#include "sightline/scene/scene3.hpp"
#include "support/meshes.hpp"

namespace sightline {
namespace {

using test::box_mesh;
using test::fans_of;
using test::make_scene3;
using test::mesh_of;
using test::prism;
using test::scene3_of;
using test::tetrahedron;
using test::turned;
using test::unit_cube;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Rings = std::vector<std::vector<VertexId>>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<VertexId> ids(std::initializer_list<std::uint32_t> values) {
    std::vector<VertexId> result;
    for (const std::uint32_t v : values) result.push_back(VertexId{v});
    return result;
}

TEST(Scene3, CubeHasTwelveEdgesAndSixFaces) {
    const Scene3 scene = scene3_of({unit_cube()});
    EXPECT_EQ(scene.edges().size(), 12u);
    EXPECT_EQ(scene.faces().size(), 6u);
    EXPECT_EQ(scene.triangles().size(), 12u);
    EXPECT_EQ(scene.bodies().size(), 1u);
    EXPECT_FALSE(scene.has_touching_bodies());
    for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(scene.edges_at(VertexId{v}).size(), 3u);
    EXPECT_EQ(scene[FaceId{0}].rings, Rings{ids({0, 1, 3, 2})});
    EXPECT_EQ(scene[FaceId{0}].plane, (std::array{VertexId{2}, VertexId{0}, VertexId{1}}));
}

TEST(Scene3, AnEdgeHasItsLeftFaceFirst) {
    const Scene3 scene = scene3_of({unit_cube()});
    const Edge3& edge = scene[EdgeId{0}];
    EXPECT_EQ(edge.source, VertexId{0});
    EXPECT_EQ(edge.target, VertexId{1});
    // Face 0 is 0 1 3 2 and runs 0 → 1; face 2 is 0 4 5 1 and runs 1 → 0.
    EXPECT_EQ(edge.faces, (std::array{FaceId{0}, FaceId{2}}));
}

TEST(Scene3, WorldIsTurnedInsideOut) {
    const Scene3 scene = scene3_of({unit_cube()}, true);
    EXPECT_TRUE(scene.bodies()[0].is_world);
    EXPECT_EQ(scene[EdgeId{0}].faces, (std::array{FaceId{2}, FaceId{0}}));
    EXPECT_EQ(scene[FaceId{0}].rings, Rings{ids({0, 2, 3, 1})});
}

TEST(Scene3, TriangulatedCubeHasTheFeaturesOfTheCube) {
    const Scene3 quads = scene3_of({unit_cube()});
    const Scene3 fans = scene3_of({fans_of(unit_cube())});
    EXPECT_TRUE(std::ranges::equal(quads.edges(), fans.edges()));
    ASSERT_EQ(fans.faces().size(), 6u);
    for (std::uint32_t f = 0; f < 6; ++f) {
        EXPECT_EQ(fans[FaceId{f}].rings, quads[FaceId{f}].rings);
        EXPECT_THAT(fans[FaceId{f}].input_faces, ElementsAre(2 * f, 2 * f + 1));
    }
}

TEST(Scene3, AFaceMayHaveHoles) {
    // A frame: a square tube, its two caps cut into four trapezoids each.
    MeshInput3 mesh;
    for (const double z : {0.0, 1.0})
        for (const double r : {3.0, 1.0})
            for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
                mesh.vertices.push_back({r * x, r * y, z});
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t j = (i + 1) % 4;
        mesh.faces.push_back({j, i, 4 + i, 4 + j});
        mesh.faces.push_back({8 + i, 8 + j, 12 + j, 12 + i});
        mesh.faces.push_back({i, j, 8 + j, 8 + i});
        mesh.faces.push_back({4 + j, 4 + i, 12 + i, 12 + j});
    }
    const Scene3 scene = scene3_of({mesh});
    EXPECT_EQ(scene.faces().size(), 10u);
    EXPECT_EQ(scene.edges().size(), 24u);
    ASSERT_EQ(scene[FaceId{0}].rings.size(), 2u);
    EXPECT_EQ(scene[FaceId{0}].rings[0], ids({0, 3, 2, 1})) << "clockwise from above: a bottom";
    EXPECT_EQ(scene[FaceId{0}].rings[1], ids({4, 5, 6, 7}));
    EXPECT_EQ(std::ranges::count(scene.triangles(), FaceId{0}, &Triangle3::face), 8);
}

TEST(Scene3, ABridgeToAHoleIsNoEdge) {
    MeshInput3 mesh = prism({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 0, 1);
    mesh.kind = SurfaceKind::sheet;
    for (const auto& [x, y] : {std::pair{1, 1}, {1, 2}, {2, 2}, {2, 1}})
        mesh.vertices.push_back({double(x), double(y), 1.0});
    mesh.faces[1] = {4, 5, 6, 7, 4, 8, 9, 10, 11, 8};
    const Scene3 scene = scene3_of({mesh});
    EXPECT_EQ(scene.edges().size(), 16u);
    EXPECT_EQ(scene[FaceId{1}].rings, (Rings{ids({4, 5, 6, 7}), ids({8, 9, 10, 11})}));
    EXPECT_EQ(std::ranges::count(scene.triangles(), FaceId{1}, &Triangle3::face), 8);
}

TEST(Scene3, FacesOfAllShapesMergeAndBridgesMayBeMerged) {
    // A square with a hole over a bridge, and the hole's filling.
    MeshInput3 mesh = mesh_of(
        {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}},
        {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, {4, 7, 6, 5}}, SurfaceKind::sheet);
    const Scene3 scene = scene3_of({mesh});
    ASSERT_EQ(scene.faces().size(), 1u);
    EXPECT_EQ(scene.edges().size(), 4u);
    EXPECT_EQ(scene.triangles().size(), 2u);
}

TEST(Scene3, TrianglesCoverAFaceThatIsNotConvex) {
    const Scene3 scene = scene3_of({prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1)});
    double area = 0;
    for (const Triangle3& t : scene.triangles()) {
        if (t.face != FaceId{1}) continue;
        const Point3& a = scene[t.corners[0]];
        const Point3& b = scene[t.corners[1]];
        const Point3& c = scene[t.corners[2]];
        const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        EXPECT_GT(twice, 0);
        area += twice / 2;
    }
    EXPECT_EQ(area, 6);
}

TEST(Scene3, StraightVerticesAreNoFeatures) {
    // A prism over a square with a vertex in the middle of a side.
    const Scene3 scene = scene3_of({prism({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, 1)});
    EXPECT_EQ(scene.edges().size(), 12u);
    EXPECT_EQ(scene.faces().size(), 6u);
    EXPECT_FALSE(scene.is_feature(VertexId{1}));
    EXPECT_FALSE(scene.is_feature(VertexId{6}));
    EXPECT_TRUE(scene.is_feature(VertexId{0}));
    EXPECT_EQ(scene[FaceId{2}].input_faces, (std::vector{2u, 3u}));
    EXPECT_EQ(scene[FaceId{2}].rings, (Rings{ids({0, 2, 7, 5})}));
}

TEST(Scene3, BordersOfASheetAreEdgesWithOneFace) {
    const Scene3 scene = scene3_of({mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                            {{0, 1, 2}, {0, 2, 3}}, SurfaceKind::sheet)});
    ASSERT_EQ(scene.edges().size(), 4u);
    EXPECT_EQ(scene[EdgeId{0}].faces, (std::array{FaceId{0}, FaceId::none()})) << "0 → 1";
    EXPECT_EQ(scene[EdgeId{1}].faces, (std::array{FaceId::none(), FaceId{0}})) << "0 → 3";
}

TEST(Scene3, CoplanarFacesOfASheetMergeWhicheverWayTheyFace) {
    const Scene3 scene = scene3_of({mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                            {{0, 1, 2}, {0, 3, 2}}, SurfaceKind::sheet)});
    ASSERT_EQ(scene.faces().size(), 1u);
    EXPECT_EQ(scene[FaceId{0}].rings, (Rings{ids({0, 1, 2, 3})}));
}

TEST(Scene3, ThreeFacesOfASheetMakeThreeEdgesRoundTheirCommonSide) {
    const Scene3 scene =
        scene3_of({mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                           {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, SurfaceKind::sheet)});
    ASSERT_EQ(scene.faces().size(), 3u) << "two are coplanar, but a third one ends between them";
    std::vector<std::array<FaceId, 2>> around;
    for (const Edge3& edge : scene.edges())
        if (edge.source == VertexId{0} && edge.target == VertexId{1}) around.push_back(edge.faces);
    // Counter-clockwise seen from above: 0, 1, 2. The second of a pair comes first.
    EXPECT_THAT(around,
                ElementsAre(std::array{FaceId{0}, FaceId{2}}, std::array{FaceId{1}, FaceId{0}},
                            std::array{FaceId{2}, FaceId{1}}));
}

TEST(Scene3, ComponentsAreBodies) {
    const Scene3 scene = scene3_of({unit_cube(), box_mesh({5, 0, 0}, {6, 1, 1})});
    ASSERT_EQ(scene.bodies().size(), 2u);
    EXPECT_EQ(scene.bodies()[1].mesh, 1u);
    EXPECT_EQ(scene[EdgeId{12}].body, BodyId{1});
}

TEST(Scene3Degenerate, CubesThatShareAnEdgeInOneFileAreTwoBodies) {
    // Vertices 6 and 7 of the first cube are 0 and 1 of the second.
    MeshInput3 mesh = unit_cube();
    const MeshInput3 other = box_mesh({1, 1, 0}, {2, 2, 1});
    const std::array<std::uint32_t, 8> number{6, 7, 8, 9, 10, 11, 12, 13};
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin() + 2, other.vertices.end());
    for (auto face : other.faces) {
        for (std::uint32_t& v : face) v = number[v];
        mesh.faces.push_back(face);
    }
    const Scene3 scene = scene3_of({mesh});
    EXPECT_EQ(scene.bodies().size(), 2u);
    EXPECT_EQ(scene.edges().size(), 24u) << "the common edge once for each";
    EXPECT_TRUE(scene.has_touching_bodies());
}

struct Refused {
    const char* name;
    MeshInput3 mesh;
    Errc code;
    const char* message;
};

class Scene3Refuses : public ::testing::TestWithParam<Refused> {};

TEST_P(Scene3Refuses, BadElements) {
    const Result<Scene3> scene = make_scene3({GetParam().mesh});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, GetParam().code) << scene.error().message;
    EXPECT_THAT(scene.error().message, HasSubstr(GetParam().message));
}

MeshInput3 with_vertex(MeshInput3 mesh, std::size_t v, Point3 p) {
    mesh.vertices[v] = p;
    return mesh;
}
MeshInput3 with_face(MeshInput3 mesh, std::size_t f, std::vector<std::uint32_t> face) {
    mesh.faces[f] = std::move(face);
    return mesh;
}
MeshInput3 without_last_face(MeshInput3 mesh) {
    mesh.faces.pop_back();
    return mesh;
}
MeshInput3 and_face(MeshInput3 mesh, std::vector<std::uint32_t> face) {
    mesh.faces.push_back(std::move(face));
    return mesh;
}

INSTANTIATE_TEST_SUITE_P(
    Elements, Scene3Refuses,
    ::testing::Values(
        Refused{"NotFinite", with_vertex(unit_cube(), 2, {0, nan, 1}), Errc::not_finite,
                "vertex 2 ("},
        Refused{"TooLarge", with_vertex(unit_cube(), 2, {0, 0x1p501, 1}),
                Errc::coordinate_too_large, "scale the scene down"},
        Refused{"TwoCorners", with_face(unit_cube(), 3, {2, 3}), Errc::too_few_vertices,
                "face 3: has 2 vertices"},
        Refused{"UnknownVertex", with_face(unit_cube(), 3, {2, 3, 8}), Errc::unknown_vertex,
                "face 3: names vertex 8, but there are 8"},
        Refused{"RepeatedVertex", with_face(unit_cube(), 3, {2, 3, 7, 6, 6}), Errc::repeated_vertex,
                "face 3: repeats vertex 6 (1, 1, 0)"},
        Refused{"NotPlanar", with_vertex(unit_cube(), 0, {0, 0, -0x1p-60}), Errc::non_planar,
                "triangulate the face"},
        Refused{"Open", without_last_face(unit_cube()), Errc::open_surface, "face 0, edge [1, 3]"},
        Refused{"OneFaceTurned", with_face(unit_cube(), 3, {6, 7, 3, 2}), Errc::wrong_orientation,
                "same direction"},
        Refused{"ThreeFacesAtAnEdge", and_face(unit_cube(), {0, 1, 6}), Errc::non_manifold,
                "3 faces meet"},
        Refused{"Collinear",
                mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}, SurfaceKind::sheet),
                Errc::degenerate_face, "face 0: has no area"},
        Refused{"SamePlaceTwice",
                mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}},
                        {{0, 1, 2}, {1, 2, 3}}, SurfaceKind::sheet),
                Errc::duplicate_vertex, "vertex 3 (0, 0, 0): lies where vertex 0"},
        Refused{"Bowtie",
                mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}},
                        SurfaceKind::sheet),
                Errc::self_intersection, "crosses itself"},
        Refused{"BowtieAmongCoplanarFaces",
                mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, -1, 0}, {0.5, 2, 0}},
                        {{0, 1, 2, 3}, {0, 4, 1}, {2, 5, 3}}, SurfaceKind::sheet),
                Errc::self_intersection, "face 0: its boundary crosses itself"},
        Refused{"NoFaces", mesh_of({{0, 0, 0}}, {}), Errc::empty_scene, "no faces"}),
    [](const auto& test) { return test.param.name; });

TEST(Scene3, MessagesNameFileAndLine) {
    MeshInput3 mesh = with_face(unit_cube(), 3, {2, 3});
    mesh.file = "cube.off";
    for (std::uint32_t i = 0; i < 8; ++i) mesh.vertex_lines.push_back(3 + i);
    for (std::uint32_t i = 0; i < 6; ++i) mesh.face_lines.push_back(11 + i);
    const Result<Scene3> scene = make_scene3({box_mesh({5, 5, 5}, {6, 6, 6}), mesh});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().message.substr(0, 20), "cube.off:14: face 3:");
}

TEST(Scene3Exhaustive, TetrahedraOfTheSmallGridAreAcceptedWhenOriented) {
    std::vector<Point3> grid;
    for (int i = 0; i < 27; ++i) grid.push_back({double(i / 9), double(i / 3 % 3), double(i % 3)});
    std::size_t accepted = 0;
    for (std::size_t a = 0; a < 27; ++a)
        for (std::size_t b = a + 1; b < 27; ++b)
            for (std::size_t c = b + 1; c < 27; ++c)
                for (std::size_t d = c + 1; d < 27; ++d) {
                    const Sign sign = detail::orientation3(grid[a], grid[b], grid[c], grid[d]);
                    const bool out = sign == Sign::negative;
                    const auto scene =
                        make_scene3({out ? tetrahedron(grid[a], grid[b], grid[c], grid[d])
                                         : tetrahedron(grid[a], grid[c], grid[b], grid[d])});
                    ASSERT_EQ(scene.has_value(), sign != Sign::zero)
                        << a << ' ' << b << ' ' << c << ' ' << d;
                    if (!scene) continue;
                    ++accepted;
                    ASSERT_EQ(scene->edges().size(), 6u);
                    ASSERT_EQ(scene->triangles().size(), 4u);
                    for (const Face3& face : scene->faces())
                        for (std::uint32_t v = 0; v < 4; ++v)
                            ASSERT_NE(detail::orientation3(
                                          (*scene)[face.plane[0]], (*scene)[face.plane[1]],
                                          (*scene)[face.plane[2]], (*scene)[VertexId{v}]),
                                      Sign::positive)
                                << "no vertex lies in front of a face of a convex body";
                }
    EXPECT_EQ(accepted, 14632u);
}

}  // namespace
}  // namespace sightline
