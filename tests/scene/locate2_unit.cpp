// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/locate2.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <random>

#include "scene/scene_helpers.hpp"

namespace sightline {
namespace {

using test::scene_of;

constexpr VertexId no_vertex = VertexId::none();
constexpr EdgeId no_edge = EdgeId::none();

RationalPoint2 at(const char* x, const char* y) {
    return {*Rational::parse(x), *Rational::parse(y)};
}

TEST(Locate, TellsInsideOutsideAndBoundary) {
    const Scene2 scene = scene_of(
        "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 4 1, 1 4)) LINESTRING (5 5, 7 7) POINT (8 1)", true);
    EXPECT_EQ(locate(scene, Point2{5, 1}),
              (Location2{PlaceKind2::free, BodyId::none(), no_vertex, no_edge}));
    EXPECT_EQ(locate(scene, Point2{2, 2}),
              (Location2{PlaceKind2::inside_body, BodyId{0}, no_vertex, no_edge}));
    EXPECT_EQ(locate(scene, Point2{9.5, 1}).kind, PlaceKind2::outside_world);
    EXPECT_EQ(locate(scene, Point2{-1, 20}).kind, PlaceKind2::outside_world);
    EXPECT_EQ(locate(scene, Point2{2, 1}).kind, PlaceKind2::boundary);
    EXPECT_EQ(locate(scene, Point2{1, 1}),
              (Location2{PlaceKind2::boundary, BodyId::none(), VertexId{4}, EdgeId{4}}));
    EXPECT_EQ(locate(scene, Point2{0, 5}).kind, PlaceKind2::boundary) << "the world's edge";
    EXPECT_EQ(locate(scene, Point2{6, 6}),
              (Location2{PlaceKind2::free, BodyId::none(), no_vertex, EdgeId{7}}))
        << "on a wall";
    EXPECT_EQ(locate(scene, Point2{8, 1}),
              (Location2{PlaceKind2::free, BodyId::none(), VertexId{9}, no_edge}));
}

TEST(Locate, RationalPointsAreNotRounded) {
    const Scene2 scene = scene_of("POLYGON ((0 0, 3 0, 0 3))");
    EXPECT_EQ(locate(scene, at("4/3", "5/3")).kind, PlaceKind2::boundary);
    EXPECT_EQ(locate(scene, at("4/3", "500000000000000000000001/300000000000000000000000")).kind,
              PlaceKind2::free);
    EXPECT_EQ(locate(scene, at("4/3", "499999999999999999999999/300000000000000000000000")).kind,
              PlaceKind2::inside_body);
    EXPECT_EQ(locate(scene, at("-1/300000000000000000000000", "1")).kind, PlaceKind2::free);
    EXPECT_EQ(locate(scene, at("1/300000000000000000000000", "1")).kind, PlaceKind2::inside_body);
    EXPECT_EQ(locate(scene, at("0", "1")).kind, PlaceKind2::boundary);
}

TEST(Locate, SealedContactsAreInsideAndPinholesAreNot) {
    const Scene2 boxes = scene_of(
        "POLYGON ((0 0, 4 0, 4 4, 0 4)) POLYGON ((4 0, 8 0, 8 4, 4 4)) POLYGON ((0 4, 4 4, 4 8, 0 "
        "8)) "
        "POLYGON ((4 4, 8 4, 8 8, 4 8)) POLYGON ((8 8, 9 8, 9 9, 8 9))");
    EXPECT_EQ(locate(boxes, Point2{4, 4}).kind, PlaceKind2::inside_body);
    EXPECT_EQ(locate(boxes, Point2{4, 4}).body, BodyId{0});
    EXPECT_EQ(locate(boxes, Point2{4, 6}).body, BodyId{2});
    EXPECT_EQ(locate(boxes, Point2{4, 0}).kind, PlaceKind2::boundary) << "where the contact ends";
    EXPECT_EQ(locate(boxes, Point2{8, 8}).kind, PlaceKind2::boundary) << "a pinhole";
}

TEST(Locate, AgreesWithTheSweepOnRandomPoints) {
    const Scene2 scene = scene_of(
        "POLYGON ((0 0, 12 0, 12 12, 0 12), (1 1, 5 1, 5 5, 1 5), (5 2, 8 2, 8 4, 5 4), (0 8, 3 8, "
        "3 12, 0 12), (9 9, 12 12, 10 8)) "
        "POLYGON ((6 6, 9 6, 9 9, 6 9), (6 6, 8 7, 7 8))",
        true);
    std::mt19937_64 random(3);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        // Quarters hit vertices, edges and contacts often.
        const Point2 p{static_cast<double>(random() % 57) / 4 - 1,
                       static_cast<double>(random() % 57) / 4 - 1};
        const Location2 found = locate(scene, p);
        const auto added = scene.with_points({&p, 1});
        const Errc expected = found.kind == PlaceKind2::inside_body     ? Errc::inside_body
                              : found.kind == PlaceKind2::outside_world ? Errc::outside_of_world
                                                                        : Errc{};
        ASSERT_EQ(added ? Errc{} : added.error().code, expected) << p.x << " " << p.y;
        inside += added ? 0 : 1;
    }
    EXPECT_GT(inside, 300);
}

}  // namespace
}  // namespace sightline
