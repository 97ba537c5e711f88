// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

View3 view_of(const Scene3& scene, const Viewpoint3& from, const View3Options& options = {}) {
    const PointVisibility3 visibility(scene);
    auto view = look(visibility, from, options);
    EXPECT_TRUE(view.has_value()) << view.error().message;
    return *std::move(view);
}

TEST(View3, ACubeFromACornerShowsThreeFacesNineEdgesSevenVertices) {
    const View3 view = view_of(scene3("box 0 0 0, 2 2 2"), at(5, 6, 7));
    EXPECT_EQ(view.visible_faces().size(), 3U);
    EXPECT_EQ(view.map.arcs.size(), 9U);
    EXPECT_EQ(view.visible_vertices().size(), 7U);
    EXPECT_EQ(view.map.regions.size(), 4U) << "three faces, and infinity";
    EXPECT_TRUE(view.map.t_junctions.empty());
}

TEST(View3, ACubeAlongAnAxisShowsOneFace) {
    const View3 view = view_of(scene3("box 0 0 0, 2 2 2"), along(0, 0, -1));
    EXPECT_EQ(view.visible_faces().size(), 1U);
    EXPECT_EQ(view.map.nodes.size(), 4U) << "upper and lower corners are in one direction";
    EXPECT_EQ(view.visible_vertices().size(), 8U);
    for (const ViewArc& arc : view.map.arcs) EXPECT_EQ(arc.edges.size(), 2U);
}

TEST(View3, ABoxBeforeABoxMakesTwoTJunctions) {
    const Scene3 scene = scene3("box 0 0 0, 2 2 2; box -1 5 1, 1 6 4");
    const View3 view = view_of(scene, at(Rational(1) / 3, -8, Rational(1) / 5));
    ASSERT_FALSE(view.map.t_junctions.empty());
    for (const TJunction& t : view.map.t_junctions) {
        EXPECT_EQ(scene[t.front].body, BodyId{0});
        EXPECT_EQ(scene[t.back].body, BodyId{1});
        // Both edges meet the line of sight through the point.
        const RationalPoint3 x = exact_point(scene, view, t.node);
        const Rational s = exact_parameter(scene, view, t.node, t.front);
        EXPECT_GT(s, Rational(0));
        EXPECT_LT(s, Rational(1));
        const RationalPoint3 u = to_rational(scene[scene[t.front].source]);
        const RationalPoint3 w = to_rational(scene[scene[t.front].target]);
        EXPECT_TRUE(
            cross(u + s * (w - u) - view.from.coordinates, x - view.from.coordinates).is_zero());
    }
}

TEST(View3, AnEmptyDirectionIsRefused) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    EXPECT_EQ(PointVisibility3(cube).along({0, 0, 0}).error().code, Errc::bad_parameter);
}

TEST(View3, AConeShowsWhatIsInIt) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    const View3Options middle{.cone = {{Rational(1) / 2, Rational(1) / 2, 2},
                                       {1, Rational(1) / 2, 2},
                                       {1, 1, 2},
                                       {Rational(1) / 2, 1, 2}}};
    const View3 inside = view_of(cube, at(1, 1, 9), middle);
    ASSERT_EQ(inside.map.regions.size(), 2U) << "the face, and what is outside of the cone";
    EXPECT_EQ(inside.map.arcs.size(), 4U);
    const View3Options corner{.cone = {{1, 1, 2}, {3, 1, 2}, {3, 3, 2}, {1, 3, 2}}};
    for (const Viewpoint3& from : {at(1, 1, 9), along(0, 0, -1)}) {
        const View3 part = view_of(cube, from, corner);
        expect_planar_map(part.map);
        EXPECT_EQ(part.map.regions.size(), 3U) << "the face, infinity, outside";
        EXPECT_EQ(part.visible_vertices().size(), from.at_infinity ? 2U : 1U);
    }
    const View3Options clockwise{.cone = {{1, 1, 2}, {1, 3, 2}, {3, 3, 2}, {3, 1, 2}}};
    EXPECT_FALSE(PointVisibility3(cube).from(Point3{1, 1, 9}, clockwise).has_value());
}

TEST(View3, TheWholeViewIsFoundInAConeAroundEverything) {
    const Scene3 scene = scene3("box 0 0 0, 2 2 2; box -1 5 1, 1 6 4");
    const Viewpoint3 from = at(Rational(1) / 3, -8, Rational(1) / 5);
    const View3 whole = view_of(scene, from);
    const View3 part =
        view_of(scene, from, {.cone = {{-40, 0, -40}, {40, 0, -40}, {40, 0, 40}, {-40, 0, 40}}});
    EXPECT_EQ(part.map.t_junctions.size(), whole.map.t_junctions.size());
    EXPECT_EQ(part.map.nodes.size(), whole.map.nodes.size() + 4);
    EXPECT_EQ(part.map.regions.size(), whole.map.regions.size() + 1);
    EXPECT_EQ(part.visible_faces(), whole.visible_faces());
}

TEST(View3, EveryArithmeticGivesTheSameViewOfASceneInGeneralPosition) {
    const Scene3 scene =
        scene3("hull 0 0 0, 7 1 0, 2 6 1, 1 2 8; hull 9 4 1, 13 5 3, 10 9 2, 8 6 7");
    const PointVisibility3 visibility(scene);
    const Point3 p{-5.25, 3.1, 2.7};
    Tally filtered;
    Tally exact;
    const auto a = visibility.from(p, {.tally = &filtered});
    const auto b = visibility.from(p, {.arithmetic = Arithmetic::exact, .tally = &exact});
    const auto c = visibility.from(p, {.arithmetic = Arithmetic::double_});
    EXPECT_EQ(a->map, b->map);
    EXPECT_EQ(a->map, c->map);
    EXPECT_GT(filtered[Predicate::image_orientation3].filter, 0U);
    EXPECT_EQ(exact[Predicate::image_orientation3].filter, 0U);
    EXPECT_GT(exact[Predicate::image_orientation3].exact, 0U);
}

}  // namespace
}  // namespace sightline::testing
