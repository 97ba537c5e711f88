// SPDX-License-Identifier: GPL-3.0-or-later
// Which scenes of space are valid where bodies and sheets meet: cases by name.
#include <gmock/gmock.h>

#include "sightline/geom/predicates3.hpp"
#include "sightline/scene/scene3.hpp"
#include "support/meshes.hpp"

namespace sightline {
namespace {

using test::box_mesh;
using test::make_scene3;
using test::mesh_of;
using test::prism;
using test::scene3_of;
using test::turned;
using test::unit_cube;
using ::testing::HasSubstr;

MeshInput3 square(Point3 a, Point3 b, Point3 c, Point3 d) {
    return mesh_of({a, b, c, d}, {{0, 1, 2, 3}}, SurfaceKind::sheet);
}
/// Whichever way its corners come, it looks outwards.
MeshInput3 tetrahedron(Point3 a, Point3 b, Point3 c, Point3 d) {
    const bool outwards = orientation(a, b, c, d) == Sign::negative;
    return outwards ? test::tetrahedron(a, b, c, d) : test::tetrahedron(a, c, b, d);
}
/// Both in one file.
MeshInput3 joined(MeshInput3 a, const MeshInput3& b) {
    const auto base = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (auto face : b.faces) {
        for (std::uint32_t& v : face) v += base;
        a.faces.push_back(face);
    }
    return a;
}

struct Case {
    const char* name;
    std::vector<MeshInput3> meshes;
    bool touching = true;
};
class Scene3Accepts : public ::testing::TestWithParam<Case> {};
TEST_P(Scene3Accepts, BodiesThatTouch) {
    const Result<Scene3> scene = make_scene3(GetParam().meshes);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->has_touching_bodies(), GetParam().touching);
}
const MeshInput3 table = box_mesh({-4, -4, -1}, {4, 4, 0});
INSTANTIATE_TEST_SUITE_P(
    Contacts, Scene3Accepts,
    ::testing::Values(
        Case{"Apart", {unit_cube(), box_mesh({3, 0, 0}, {4, 1, 1})}, false},
        Case{"BoxesMeetOnlyInBoundingPlanes", {unit_cube(), box_mesh({1, 3, 0}, {2, 4, 1})}, false},
        Case{"WholeFace", {unit_cube(), box_mesh({1, 0, 0}, {2, 1, 1})}},
        Case{"PieceOfAFace", {table, box_mesh({0, 0, 0}, {1, 1, 1})}},
        Case{"CrossedBeams", {box_mesh({-3, 0, 0}, {3, 1, 1}), box_mesh({0, -3, 1}, {1, 3, 2})}},
        Case{"FacesThatOverlapInPart", {unit_cube(), box_mesh({1, 0.5, 0.5}, {2, 1.5, 1.5})}},
        Case{"PieceOfAnEdge", {unit_cube(), box_mesh({1, 1, 0.5}, {2, 2, 1.5})}},
        Case{"WholeEdge", {unit_cube(), box_mesh({1, 1, 0}, {2, 2, 1})}},
        Case{"Corner", {unit_cube(), box_mesh({1, 1, 1}, {2, 2, 2})}},
        Case{"TipOnAFace", {table, tetrahedron({0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2})}},
        Case{"TipsFromBothSidesOfOnePoint",
             {tetrahedron({0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}),
              tetrahedron({0, 0, 0}, {1, 0, -2}, {-1, 1, -2}, {-1, -1, -2})}},
        Case{"TwoTipsThatPointTheSameWay",
             {tetrahedron({0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}),
              tetrahedron({0, 0, 0}, {9, 0, 2}, {8, 1, 2}, {8, -1, 2})}},
        Case{"EdgeAcrossAnEdge",
             {tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, -1, -2}, {0, 1, -2}),
              tetrahedron({0, -1, 0}, {0, 1, 0}, {1, 0, 2}, {-1, 0, 2})}},
        Case{"EdgeOnAFace", {table, tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 1, 2})}},
        Case{"EightCubesRoundAPoint",
             {box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({-1, 0, 0}, {0, 1, 1}),
              box_mesh({0, -1, 0}, {1, 0, 1}), box_mesh({-1, -1, 0}, {0, 0, 1}),
              box_mesh({0, 0, -1}, {1, 1, 0}), box_mesh({-1, 0, -1}, {0, 1, 0}),
              box_mesh({0, -1, -1}, {1, 0, 0}), box_mesh({-1, -1, -1}, {0, 0, 0})}},
        Case{"BoxInANotch",
             {prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1),
              box_mesh({1, 1, 0}, {2, 2, 1})}},
        Case{"Cavity",
             {joined(box_mesh({0, 0, 0}, {9, 9, 9}), turned(box_mesh({3, 3, 3}, {6, 6, 6})))},
             false},
        Case{"BodyInACavity",
             {joined(box_mesh({0, 0, 0}, {9, 9, 9}), turned(box_mesh({3, 3, 3}, {6, 6, 6}))),
              box_mesh({4, 4, 4}, {5, 5, 5})},
             false},
        Case{"BodyThatFillsACavity",
             {joined(box_mesh({0, 0, 0}, {9, 9, 9}), turned(box_mesh({3, 3, 3}, {6, 6, 6}))),
              box_mesh({3, 3, 3}, {6, 6, 6})}},
        Case{"CavityWhoseTipTouchesTheSurface",
             {joined(box_mesh({-4, -4, 0}, {4, 4, 4}),
                     turned(tetrahedron({0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2})))}},
        Case{"SheetOnAFace", {table, square({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})}},
        Case{"SheetThatStandsOnAFace", {table, square({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})}},
        Case{"SheetBetweenSolids",
             {table, box_mesh({-1, -1, 0}, {1, 1, 1}),
              square({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0})}},
        Case{"SheetsThatShareABorder",
             {square({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}),
              square({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})}},
        Case{"SheetThatEndsOnASheet",
             {square({-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}),
              square({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1})}},
        Case{"SheetsSplitWhereTheyCross",
             {square({-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}),
              square({-1, 0, 0}, {1, 0, 0}, {1, -1, 0}, {-1, -1, 0}),
              square({-1, 0, 0}, {1, 0, 0}, {1, 0, 1}, {-1, 0, 1}),
              square({-1, 0, 0}, {1, 0, 0}, {1, 0, -1}, {-1, 0, -1})}},
        Case{"SheetsThatOverlapInAPlane",
             {square({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}),
              square({1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0})}}),
    [](const auto& test) { return test.param.name; });

TEST(Scene3, ACavityBelongsToItsBody) {
    const Scene3 scene = scene3_of(
        {joined(joined(box_mesh({0, 0, 0}, {9, 9, 9}), turned(box_mesh({3, 3, 3}, {6, 6, 6}))),
                box_mesh({4, 4, 4}, {5, 5, 5}))});
    ASSERT_EQ(scene.bodies().size(), 2u);
    EXPECT_EQ(scene[FaceId{0}].body, BodyId{0});
    EXPECT_EQ(scene[FaceId{6}].body, BodyId{0});
    EXPECT_EQ(scene[FaceId{12}].body, BodyId{1});
}

TEST(Scene3, BodiesStandInAWorld) {
    const auto room = box_mesh({0, 0, 0}, {9, 9, 9});
    const Result<Scene3> scene = make_scene3(
        {room, box_mesh({4, 4, 0}, {5, 5, 1}), square({1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1})},
        true);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->bodies().size(), 3u);
    EXPECT_TRUE(scene->has_touching_bodies()) << "a box on the floor";
    // A pillar that the world's own file has: an inner component, inwards like any hole of it.
    const Result<Scene3> pillar =
        make_scene3({joined(room, turned(box_mesh({4, 4, 1}, {5, 5, 2})))}, true);
    ASSERT_TRUE(pillar) << pillar.error().message;
    EXPECT_EQ(pillar->bodies().size(), 1u);
}

struct Wrong {
    const char* name;
    std::vector<MeshInput3> meshes;
    Errc code;
    const char* message;
    bool world = false;
};
class Scene3RefusesOverlap : public ::testing::TestWithParam<Wrong> {};
TEST_P(Scene3RefusesOverlap, BodiesThatOverlap) {
    for (const bool swapped : {false, true}) {
        std::vector<MeshInput3> meshes = GetParam().meshes;
        if (swapped && GetParam().world) continue;
        if (swapped) std::reverse(meshes.begin(), meshes.end());
        const Result<Scene3> scene = make_scene3(meshes, GetParam().world);
        ASSERT_FALSE(scene) << swapped;
        EXPECT_EQ(scene.error().code, GetParam().code) << scene.error().message;
        EXPECT_THAT(scene.error().message, HasSubstr(GetParam().message)) << swapped;
        EXPECT_EQ(scene.error().message.find('\n'), std::string::npos);
    }
}
INSTANTIATE_TEST_SUITE_P(
    Overlaps, Scene3RefusesOverlap,
    ::testing::Values(
        Wrong{"Inwards", {turned(unit_cube())}, Errc::wrong_orientation, "looks inwards"},
        Wrong{"InwardsInside",
              {box_mesh({-3, -3, -3}, {3, 3, 3}), turned(unit_cube())},
              Errc::wrong_orientation,
              "turn its faces"},
        Wrong{"CavityOutside",
              {joined(unit_cube(), turned(box_mesh({3, 3, 3}, {4, 4, 4})))},
              Errc::wrong_orientation,
              "face 6"},
        Wrong{"Twice", {unit_cube(), unit_cube()}, Errc::body_overlap, "overlap"},
        Wrong{"TwiceOnceInwards",
              {joined(unit_cube(), turned(unit_cube()))},
              Errc::body_overlap,
              "cover each other"},
        Wrong{"ShiftedAlongAFace",
              {unit_cube(), box_mesh({0.5, 0, 0}, {1.5, 1, 1})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"CornersInside",
              {unit_cube(), box_mesh({0.5, 0.5, 0.5}, {2, 2, 2})},
              Errc::body_overlap,
              "near"},
        Wrong{"Crosswise",
              {box_mesh({-3, 0, 0}, {3, 1, 1}), box_mesh({0, -3, 0}, {1, 3, 1})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"CrosswiseWithoutCommonPlanes",
              {box_mesh({-3, 0, 0}, {3, 1, 1}), box_mesh({0, -3, -3}, {1, 3, 3})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"SmallerInTheSameCorner",
              {unit_cube(), box_mesh({0, 0, 0}, {0.5, 0.5, 0.5})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"Within",
              {box_mesh({-3, -3, -3}, {3, 3, 3}), unit_cube()},
              Errc::body_overlap,
              "lies inside the solid"},
        Wrong{"WithinAndTouchingInAPoint",
              {box_mesh({-4, -4, 0}, {4, 4, 4}),
               tetrahedron({0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"EdgesThroughEdges",
              {tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, -1, -2}, {0, 1, -2}),
               tetrahedron({0, 1, 0}, {0, -1, 0}, {1, 0, -2}, {-1, 0, -2})},
              Errc::body_overlap,
              "overlap"},
        Wrong{"CavityWithoutAWall",
              {joined(unit_cube(), turned(box_mesh({0.25, 0.25, 0}, {0.75, 0.75, 0.5})))},
              Errc::body_overlap,
              "overlap"},
        Wrong{"SheetThroughASolid",
              {unit_cube(), square({-1, -1, 0.5}, {2, -1, 0.5}, {2, 2, 0.5}, {-1, 2, 0.5})},
              Errc::sheet_crosses,
              "cut the sheet off"},
        Wrong{"SheetInside",
              {unit_cube(),
               square({0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.25, 0.75, 0.5})},
              Errc::sheet_crosses,
              "lies inside the solid"},
        Wrong{"SheetAcrossFromEdgeToEdge",
              {unit_cube(), square({0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1})},
              Errc::sheet_crosses,
              "inside the solid there"},
        Wrong{"SheetsCross",
              {square({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}),
               square({-2, 0, -1}, {2, 0, -1}, {2, 0, 1}, {-2, 0, 1})},
              Errc::sheet_crosses,
              "split sheets"},
        Wrong{"SheetsCrossBetweenCommonVertices",
              {square({0, 0, 0}, {1, 1, 1}, {2, 0, 0}, {1, -1, -1}),
               square({0, 0, 0}, {1, 1, -1}, {2, 0, 0}, {1, -1, 1})},
              Errc::sheet_crosses,
              "split sheets"},
        Wrong{"OutOfTheWorld",
              {box_mesh({0, 0, 0}, {9, 9, 9}), box_mesh({8, 8, 8}, {10, 10, 10})},
              Errc::outside_world,
              "reaches out of the world",
              true},
        Wrong{"OutsideOfTheWorld",
              {box_mesh({0, 0, 0}, {9, 9, 9}), box_mesh({18, 8, 8}, {20, 10, 10})},
              Errc::outside_world,
              "lies outside of the world",
              true},
        Wrong{"WorldInwards",
              {turned(box_mesh({0, 0, 0}, {9, 9, 9}))},
              Errc::wrong_orientation,
              "looks inwards",
              true},
        Wrong{"SelfCrossingPrism",
              {prism({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, -1}, {2, -1}, {2, 4}, {0, 4}}, 0, 1)},
              Errc::self_intersection,
              "crosses itself"},
        Wrong{"TipPushedThroughTheOtherSide",
              {mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 1}, {1, 1, 3}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}})},
              Errc::self_intersection,
              "intersects itself"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sightline
