// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate scenes and viewpoints: what rules decide, stated, and all against the reference.
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

class EverySmallDegenerateScene3 : public ::testing::TestWithParam<std::string> {};

TEST_P(EverySmallDegenerateScene3, IsSeenAsTheReferenceSeesIt) {
    compare_degenerate(degenerate_scene3(GetParam()));
}

std::vector<std::string> small() {
    std::vector<std::string> names;
    for (const auto& [name, text] : degenerate_scenes3()) {
        if (scene3(text).edges().size() <= 24) names.push_back(name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Corpus, EverySmallDegenerateScene3, ::testing::ValuesIn(small()),
                         [](const auto& named) { return named.param; });

ViewMap3 map_of(const Scene3& scene, const Viewpoint3& from) {
    const PointVisibility3 visibility(scene);
    const auto view = look(visibility, from);
    EXPECT_TRUE(view.has_value());
    return view->map;
}

TEST(View3Degenerate, AFaceSeenEdgeOnHasNoRegion) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    // In the plane of the top: front only; the top's far edge is seen over its near one.
    const ViewMap3 map = map_of(cube, at(1, -3, 2));
    EXPECT_EQ(map.regions.size(), 2U);
    EXPECT_EQ(map.arcs.size(), 6U)
        << "three on the top's great circle: near edge with a side, with the far edge, "
           "with the other side";
}

TEST(View3Degenerate, FromAFaceOneSeesTheHalfSpaceBeforeIt) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    const ViewMap3 map = map_of(cube, at(1, 1, 2));
    ASSERT_EQ(map.regions.size(), 2U);
    EXPECT_EQ(map.regions[0].kind, ViewRegion::Kind::infinity);
    EXPECT_EQ(map.regions[1].kind, ViewRegion::Kind::blocked);
    EXPECT_EQ(map.nodes.size(), 4U) << "the corners of the face";
}

TEST(View3Degenerate, AnEdgeIsSeenInOnePointBetweenTwoBodiesThatGrazeTheLineOfSight) {
    const Scene3 scene = scene3("box 0 2 0, 2 3 4; box 2 4 0, 4 5 4; box -5 8 1, 9 9 2");
    // Seen from below along y, the two near boxes' sides are on one line of sight: a slit.
    const ViewMap3 map = map_of(scene, along(0, 1, 0));
    const auto is_point = [](const ViewPiece& p) { return p.from == p.to; };
    EXPECT_EQ(std::count_if(map.pieces.begin(), map.pieces.end(), is_point), 4)
        << "both ends of the slit's height on each of the far box's two edges before and behind";
}

TEST(View3Degenerate, InsideABodyThereIsNoViewAndTheBodyIsNamed) {
    const Scene3 scene = scene3("box 5 5 5, 6 6 6; box 0 0 0, 2 2 2");
    const auto view = PointVisibility3(scene).from(Point3{1, 1, 1});
    ASSERT_FALSE(view.has_value());
    EXPECT_EQ(view.error().code, Errc::inside_body);
    EXPECT_THAT(view.error().message, ::testing::HasSubstr("body 1"));
}

TEST(View3Degenerate, BetweenTwoBodiesInContactThereIsNoView) {
    const Scene3 scene = scene3("box 0 0 0, 2 2 2; box 2 0 0, 4 2 2");
    EXPECT_FALSE(PointVisibility3(scene).from(Point3{2, 1, 1}).has_value());
    EXPECT_TRUE(PointVisibility3(scene).from(Point3{2, 1, 2}).has_value());
}

TEST(View3Degenerate, OutsideOfTheWorldThereIsNoView) {
    const Scene3 room = scene3("world; box 0 0 0, 8 8 8");
    const auto view = PointVisibility3(room).from(Point3{9, 1, 1});
    ASSERT_FALSE(view.has_value());
    EXPECT_EQ(view.error().code, Errc::outside_of_world);
    EXPECT_FALSE(PointVisibility3(room).along({1, 0, 0}).has_value());
}

TEST(View3Degenerate, ASheetShowsTheSideOnWhichOneIs) {
    const Scene3 sheet = scene3("sheet 0 0 0, 2 0 0, 0 2 0");
    const auto faces = [&](const Viewpoint3& from) {
        return look(PointVisibility3(sheet), from)->visible_faces();
    };
    EXPECT_EQ(faces(at(1, 1, 3)), (std::vector{FaceSide{FaceId{0}, false}}));
    EXPECT_EQ(faces(at(1, 1, -3)), (std::vector{FaceSide{FaceId{0}, true}}));
    EXPECT_TRUE(faces(at(5, 5, 0)).empty());
}

}  // namespace
}  // namespace sightline::testing
