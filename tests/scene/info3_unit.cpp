// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/info3.hpp"

#include <gmock/gmock.h>

#include "support/meshes.hpp"

namespace sightline {
namespace {

using test::box_mesh;
using test::fans_of;
using test::mesh_of;
using test::scene3_of;
using test::unit_cube;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Info3, CountsACube) {
    MeshInput3 cube = fans_of(unit_cube());
    cube.vertices.push_back({9, 9, 9});
    const SceneInfo3 info = describe(scene3_of({cube}));
    EXPECT_EQ(info.vertices, 9u);
    EXPECT_EQ(info.feature_vertices, 8u);
    EXPECT_EQ(info.edges, 12u);
    EXPECT_EQ(info.faces, 6u);
    EXPECT_EQ(info.input_faces, 12u);
    EXPECT_EQ(info.triangles, 12u);
    EXPECT_EQ(info.solids, 1u);
    EXPECT_EQ(info.sheets, 0u);
    EXPECT_EQ(info.parallel_edges, 12u);
    EXPECT_EQ(info.parallel_directions, 3u);
    EXPECT_EQ(info.approx_shortest_edge, 1);
    EXPECT_EQ(info.approx_extent, 9);
    EXPECT_THAT(info.isolated, ElementsAre(VertexId{8}));
    EXPECT_TRUE(info.coplanar.empty());
    EXPECT_TRUE(info.contacts.empty());
}

TEST(Info3, ListsContacts) {
    const auto contacts = [](const MeshInput3& a, const MeshInput3& b) {
        return describe(scene3_of({a, b})).contacts;
    };
    const BodyId a{0}, b{1};
    EXPECT_THAT(contacts(unit_cube(), box_mesh({1, 0, 0}, {2, 1, 1})),
                ElementsAre(BodyContact3{a, b, 4, 4, 1}));
    EXPECT_THAT(contacts(unit_cube(), box_mesh({1, 1, 0}, {2, 2, 1})),
                ElementsAre(BodyContact3{a, b, 2, 1, 0}));
    EXPECT_THAT(contacts(unit_cube(), box_mesh({1, 1, 1}, {2, 2, 2})),
                ElementsAre(BodyContact3{a, b, 1, 0, 0}));
    EXPECT_THAT(contacts(box_mesh({-4, -4, -1}, {4, 4, 0}), unit_cube()),
                ElementsAre(BodyContact3{a, b, 4, 0, 1}));
    // Two beams, of which one lies across the other.
    EXPECT_THAT(contacts(box_mesh({-3, 0, 0}, {3, 1, 1}), box_mesh({0, -3, 1}, {1, 3, 2})),
                ElementsAre(BodyContact3{a, b, 4, 0, 1}));
    EXPECT_TRUE(contacts(unit_cube(), box_mesh({3, 0, 0}, {4, 1, 1})).empty());
}

TEST(Info3, ListsWhatLiesInOnePlaneOrLine) {
    const SceneInfo3 info = describe(scene3_of({unit_cube(), box_mesh({3, 0, 2}, {4, 1, 5})}));
    EXPECT_THAT(info.coplanar,
                ElementsAre(ElementsAre(FaceId{2}, FaceId{8}), ElementsAre(FaceId{3}, FaceId{9})));
    EXPECT_TRUE(info.collinear.empty());
    const SceneInfo3 row = describe(scene3_of({unit_cube(), box_mesh({3, 0, 0}, {4, 1, 1})}));
    EXPECT_EQ(row.coplanar.size(), 4u);
    EXPECT_EQ(row.collinear.size(), 4u);
    EXPECT_THAT(row.collinear[0], ::testing::SizeIs(2));
    EXPECT_EQ(row.parallel_edges, 24u);
    EXPECT_TRUE(row.is_degenerate());
}

TEST(Info3, ListsVerticesThatAreNoFeaturesAndNearlyFlatEdges) {
    const double low = std::nextafter(1.0, 0.0);
    // A roof that is bent by an ulp at its ridge.
    const MeshInput3 roof =
        mesh_of({{0, 0, 1}, {1, 0, low}, {2, 0, 1}, {2, 1, 1}, {1, 1, low}, {0, 1, 1}, {0, 0.5, 1}},
                {{0, 1, 4, 5, 6}, {1, 2, 3, 4}}, SurfaceKind::sheet);
    const SceneInfo3 info = describe(scene3_of({roof}));
    EXPECT_THAT(info.flat, ElementsAre(VertexId{6}));
    ASSERT_EQ(info.nearly_flat.size(), 1u);
    EXPECT_EQ(info.border_edges, 6u);
    EXPECT_EQ(info.sheets, 1u);
    EXPECT_TRUE(describe(scene3_of({unit_cube()})).nearly_flat.empty());
}

TEST(Info3, TextNamesTheFacts) {
    const std::string text =
        to_text(describe(scene3_of({unit_cube(), box_mesh({1, 1, 0}, {2, 2, 1})})));
    EXPECT_THAT(text, HasSubstr("touching bodies: 1 (b0-b1 2 places 1 edges 0 faces)\n"));
    EXPECT_THAT(text, HasSubstr("places with several vertices: 2 (2 with v6, 2 with v7)\n"));
    EXPECT_THAT(text, HasSubstr("solids: 2\n"));
}

}  // namespace
}  // namespace sightline
