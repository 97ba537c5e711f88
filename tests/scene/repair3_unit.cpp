// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/repair3.hpp"

#include <gmock/gmock.h>

#include "support/meshes.hpp"

namespace sightline {
namespace {

using test::box_mesh;
using test::fans_of;
using test::mesh_of;
using test::turned;
using test::unit_cube;
using ::testing::ElementsAre;

Result<RepairedScene3> repaired(std::vector<MeshInput3> meshes, bool world = false) {
    SceneInput3 input;
    input.meshes = std::move(meshes);
    input.world = world;
    return repair(input);
}
void expect_cube(const Result<RepairedScene3>& result, const std::vector<std::string>& changes) {
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->changes, changes);
    const Scene3 cube = test::scene3_of({unit_cube()});
    EXPECT_EQ(result->scene.edges().size(), 12u);
    EXPECT_EQ(result->scene.faces().size(), 6u);
    EXPECT_EQ(Scene3::make(result->input).value(), result->scene);
}

TEST(Repair3, LeavesValidInputAlone) {
    const Result<RepairedScene3> result = repaired({unit_cube()});
    expect_cube(result, {});
    EXPECT_EQ(result->scene, test::scene3_of({unit_cube()}));
}

TEST(Repair3, MergesTheCornersOfASoup) {
    MeshInput3 soup;
    for (const auto& face : fans_of(unit_cube()).faces) {
        auto& corners = soup.faces.emplace_back();
        for (const std::uint32_t v : face) {
            corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
            soup.vertices.push_back(unit_cube().vertices[v]);
        }
    }
    soup.file = "soup.off";
    expect_cube(repaired({soup}), {"soup.off: vertices merged with others at their place: 28",
                                   "soup.off: vertices without faces removed: 28"});
}

TEST(Repair3, RemovesRepeatsSpikesAndDoubles) {
    MeshInput3 mesh = unit_cube();
    mesh.faces[0] = {0, 1, 1, 3, 7, 3, 2};
    mesh.faces.push_back({3, 7, 6, 2});
    expect_cube(repaired({mesh}), {"mesh 0: repeated corners and spikes of faces removed: 3",
                                   "mesh 0: faces that came twice removed: 1"});
}

TEST(Repair3, RemovesATriangleWithoutAreaAndGivesItsMiddleToTheNeighbour) {
    // The upper side of face 0 → 1 → 3 → 2 is cut at its middle for its own triangles only.
    MeshInput3 mesh = unit_cube();
    mesh.vertices.push_back({0, 0, 0.5});
    mesh.faces[0] = {0, 8, 1, 3, 2};
    mesh.faces.push_back({0, 1, 8});
    const Result<RepairedScene3> result = repaired({mesh});
    expect_cube(result, {"mesh 0: faces without area removed: 1"});
    EXPECT_FALSE(result->scene.is_feature(VertexId{8}));
}

TEST(Repair3, CutsBentFaces) {
    MeshInput3 mesh = unit_cube();
    mesh.vertices[7] = {1, 1, 1.5};
    const Result<RepairedScene3> result = repaired({mesh});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(result->changes,
                ElementsAre("mesh 0: faces that were not planar cut into triangles: 1"));
    EXPECT_EQ(result->scene.faces().size(), 7u) << "two sides contain the corner's way up";
}

TEST(Repair3, LeavesBentFacesThatFoldOverThemselves) {
    // Seen along z, vertices 2 and 3 are at one place.
    const MeshInput3 sheet = mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 1, 5}, {1, 1, 0}, {0, 2, 0}},
                                     {{0, 1, 2, 3, 4}}, SurfaceKind::sheet);
    EXPECT_EQ(repaired({sheet}).error().code, Errc::non_planar);
}

TEST(Repair3, TurnsFacesAndSolids) {
    MeshInput3 one_face = unit_cube();
    std::ranges::reverse(one_face.faces[4]);
    expect_cube(repaired({one_face}),
                {"mesh 0: faces turned that did not agree with their neighbours: 1"});
    expect_cube(repaired({turned(unit_cube())}),
                {"mesh 0: solids and cavities turned because they looked the wrong way: 1"});
    // The world is read like any solid.
    expect_cube(repaired({turned(unit_cube())}, true),
                {"mesh 0: solids and cavities turned because they looked the wrong way: 1"});
}

TEST(Repair3, TurnsACavityWithItsSolid) {
    MeshInput3 mesh = turned(box_mesh({0, 0, 0}, {9, 9, 9}));
    const MeshInput3 hollow = box_mesh({3, 3, 3}, {6, 6, 6});
    mesh.vertices.insert(mesh.vertices.end(), hollow.vertices.begin(), hollow.vertices.end());
    for (auto face : hollow.faces) {
        for (std::uint32_t& v : face) v += 8;
        mesh.faces.push_back(face);
    }
    const Result<RepairedScene3> result = repaired({mesh});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(
        result->changes,
        ElementsAre("mesh 0: solids and cavities turned because they looked the wrong way: 2"));
    EXPECT_EQ(result->scene.bodies().size(), 1u);
}

TEST(Repair3, DoesNotGuess) {
    MeshInput3 open = unit_cube();
    open.faces.pop_back();
    EXPECT_EQ(repaired({open}).error().code, Errc::open_surface);
    EXPECT_EQ(repaired({unit_cube(), unit_cube()}).error().code, Errc::body_overlap);
    MeshInput3 infinite = unit_cube();
    infinite.vertices[0].x = 1 / 0.0;
    EXPECT_EQ(repaired({infinite}).error().code, Errc::not_finite);
}

}  // namespace
}  // namespace sightline
