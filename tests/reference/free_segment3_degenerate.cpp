// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <sstream>
#include <string>

#include "sightline/reference/free_segment3.hpp"
#include "sightline/spatial/box3.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

using reference::first_hit;
using reference::maximal_segments;
using ::testing::ElementsAre;
using testing::scene3;

RationalPoint3 at(const Rational& x, const Rational& y, const Rational& z) { return {x, y, z}; }

bool is_free(const Scene3& scene, const RationalPoint3& p, const RationalPoint3& q) {
    const bool there = reference::is_free(scene, p, q);
    EXPECT_EQ(reference::is_free(scene, q, p), there) << "seeing is mutual";
    return there;
}

std::string hit(const Scene3& scene, const RationalPoint3& p, const Vector3& d) {
    std::ostringstream out;
    out << first_hit(scene, p, d);
    return out.str();
}

std::vector<std::string> labels(const Scene3& scene, const RationalPoint3& p,
                                const RationalPoint3& q) {
    std::vector<std::string> result;
    for (const SegmentLabel& label : maximal_segments(scene, line_through(p, q))) {
        std::ostringstream out;
        out << label;
        result.push_back(out.str());
    }
    return result;
}

// Faces of a box: f0 below, f1 above, f2 front (low y), f3 right, f4 back, f5 left (low x).
const char* const box = "box 0 0 0, 4 4 4";

TEST(FreeSegment3, ThroughABoxIsBlockedAndPastItIsFree) {
    const Scene3 scene = scene3(box);
    EXPECT_FALSE(is_free(scene, at(-1, 1, 1), at(5, 2, 3)));
    EXPECT_TRUE(is_free(scene, at(-1, 5, 1), at(5, 5, 3)));
    EXPECT_TRUE(is_free(scene, at(-1, 1, 1), at(0, 2, 1))) << "up to the face";
    EXPECT_FALSE(is_free(scene, at(0, 1, 1), at(1, 1, 1))) << "from the face into the box";
    EXPECT_FALSE(is_free(scene, at(1, 1, 1), at(1, 1, 1)));
    EXPECT_TRUE(is_free(scene, at(0, 1, 1), at(0, 1, 1)));
}

TEST(FreeSegment3, GrazingAFaceAnEdgeOrAVertexIsFree) {
    const Scene3 scene = scene3(box);
    EXPECT_TRUE(is_free(scene, at(-1, 1, 4), at(5, 2, 4))) << "in the plane of a face";
    EXPECT_TRUE(is_free(scene, at(-1, 0, 4), at(5, 0, 4))) << "along an edge";
    EXPECT_FALSE(is_free(scene, at(-1, 2, 5), at(1, 2, 3))) << "over the edge, into it";
    EXPECT_TRUE(is_free(scene, at(-1, 2, 3), at(1, 2, 5))) << "over the edge";
    EXPECT_TRUE(is_free(scene, at(-2, -1, 3), at(2, 1, 5))) << "over the corner";
}

TEST(FreeSegment3, ARayEndsAtAllFacesThatMeetWhereItEnds) {
    const Scene3 scene = scene3(box);
    EXPECT_EQ(hit(scene, at(-2, 1, 1), {1, 0, 0}), "(0, 1, 1) | f5");
    EXPECT_EQ(hit(scene, at(-2, 1, -2), {1, 0, 1}), "(0, 1, 0) | f0 f5");
    EXPECT_EQ(hit(scene, at(-2, -2, -2), {1, 1, 1}), "(0, 0, 0) | f0 f2 f5");
    EXPECT_EQ(hit(scene, at(-2, 1, 1), {-1, 0, 0}), "| inf");
    EXPECT_EQ(hit(scene, at(0, 1, 1), {1, 0, 0}), "(0, 1, 1) | f5") << "blocked from the start";
    EXPECT_EQ(hit(scene, at(-2, 1, 4), {1, 0, 0}), "| inf") << "grazes the top";
}

TEST(FreeSegment3, LabelsNameWhatALineTouches) {
    const Scene3 scene = scene3(box);
    // Edges are numbered by their vertices: e0 v0v1, e1 v0v3, e2 v0v4, e3 v1v2, e4 v1v5, ...
    EXPECT_THAT(labels(scene, at(-1, 0, 0), at(5, 0, 0)), ElementsAre("v0 v1 | inf | inf"));
    EXPECT_THAT(labels(scene, at(-1, 1, 0), at(5, 1, 0)), ElementsAre("e1 e3 | inf | inf"));
    EXPECT_THAT(labels(scene, at(-1, 1, 1), at(5, 1, 1)),
                ElementsAre(" | inf | f5", " | f3 | inf"));
    EXPECT_THAT(labels(scene, at(1, 1, 9), at(2, 1, 9)), ElementsAre(" | inf | inf"));
}

TEST(FreeSegment3, SurdLinesAreCutLikeOthers) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; box 8 0 0, 12 4 4");
    const Surd root = Surd::square_root(Rational(2));
    // Through (-1, √2, √2) along x: hits both boxes; at height 4 + √2 it misses.
    const auto along_x = [](const Surd& y, const Surd& z) {
        const SurdVector3 d{1, 0, 0};
        return SurdLine3{d, cross(SurdVector3{-1, y, z}, d)};
    };
    EXPECT_EQ(maximal_segments(scene, along_x(root, root)).size(), 3U);
    EXPECT_EQ(maximal_segments(scene, along_x(root, root + Surd(4))).size(), 1U);
    const auto grazing = maximal_segments(scene, along_x(root, 4));
    ASSERT_EQ(grazing.size(), 1U);
    EXPECT_EQ(grazing[0].support.edges.size(), 4U) << "the edges across it of two tops";
}

// ---- contacts ------------------------------------------------------------------------------------

TEST(FreeSegment3Degenerate, ASharedPieceOfAFaceIsSealed) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; box 1 1 4, 3 3 6");
    EXPECT_FALSE(is_free(scene, at(-1, 2, 4), at(5, 2, 4))) << "between the two";
    EXPECT_TRUE(is_free(scene, at(-1, 2, 4), at(1, 2, 4))) << "up to the contact";
    EXPECT_TRUE(is_free(scene, at(-1, 1, 4), at(5, 1, 4))) << "along its border";
    // What is behind (1, 2, 4) lies on the boundary of both.
    EXPECT_EQ(hit(scene, at(-1, 2, 4), {1, 0, 0}), "(1, 2, 4) | f1 f6 f11");
}

TEST(FreeSegment3Degenerate, ASharedEdgeIsASlit) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; box 4 4 0, 8 8 4");
    EXPECT_TRUE(is_free(scene, at(6, 2, 2), at(2, 6, 2))) << "through the slit";
    EXPECT_TRUE(is_free(scene, at(4, 4, -1), at(4, 4, 5))) << "along the slit";
    EXPECT_FALSE(is_free(scene, at(6, 3, 2), at(2, 6, 2)));
}

TEST(FreeSegment3Degenerate, ASlitIsClosedBySolidsOnItsSides) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; box 4 4 0, 8 8 4; box 0 4 0, 4 8 4");
    EXPECT_TRUE(is_free(scene, at(6, 2, 2), at(4, 4, 2)));
    EXPECT_EQ(hit(scene, at(6, 2, 2), {-1, 1, 0}), "(4, 4, 2) | f14 f15")
        << "the third box's faces; the others' do not bound what stops the ray";
    EXPECT_TRUE(is_free(scene, at(4, 4, -1), at(4, 4, 5))) << "a reflex edge is free";
}

TEST(FreeSegment3Degenerate, ASharedVertexIsAPinhole) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; box 4 4 4, 8 8 8");
    EXPECT_TRUE(is_free(scene, at(2, 6, 4), at(6, 2, 4)));
    EXPECT_TRUE(is_free(scene, at(2, 6, 6), at(6, 2, 2)));
    EXPECT_FALSE(is_free(scene, at(2, 2, 2), at(6, 6, 6)));
}

TEST(FreeSegment3Degenerate, EightCubesSealTheirVertex) {
    const Scene3 scene = scene3("family cubes-round-vertex 8");
    const auto& v = scene.vertices();
    // The vertex that all cubes share is the middle of the box of all.
    Box3 all;
    for (const Point3& p : v) all.include(p);
    const RationalPoint3 middle{(Rational(all.low[0]) + Rational(all.high[0])) / 2,
                                (Rational(all.low[1]) + Rational(all.high[1])) / 2,
                                (Rational(all.low[2]) + Rational(all.high[2])) / 2};
    EXPECT_TRUE(reference::is_interior(scene, middle));
    EXPECT_FALSE(reference::is_interior(scene3("family cubes-round-vertex 7"), middle));
}

TEST(FreeSegment3Degenerate, OutsideOfAWorldIsSolid) {
    const Scene3 scene = scene3("world; box 0 0 0, 8 8 8; box 2 3 0, 5 5 4");
    EXPECT_TRUE(is_free(scene, at(0, 0, 0), at(8, 0, 8))) << "from corner to corner";
    EXPECT_FALSE(is_free(scene, at(1, 1, 1), at(1, 1, 9)));
    EXPECT_FALSE(is_free(scene, at(9, 9, 9), at(10, 9, 9)));
    EXPECT_TRUE(is_free(scene, at(0, 0, 1), at(0, 8, 1))) << "along the world's wall";
    EXPECT_EQ(hit(scene, at(1, 1, 1), {0, 0, -1}), "(1, 1, 0) | f0");
    EXPECT_EQ(hit(scene, at(1, 4, 0), {1, 0, 0}), "(2, 4, 0) | f0 f6 f11")
        << "along the floor, up to the box that stands on it";
}

// ---- sheets --------------------------------------------------------------------------------------

const char* const sheet = "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0";

TEST(FreeSegment3Degenerate, ASheetBlocksWithinAndNotAtItsBorder) {
    const Scene3 scene = scene3(sheet);
    EXPECT_FALSE(is_free(scene, at(1, 2, -1), at(2, 1, 1)));
    EXPECT_TRUE(is_free(scene, at(1, 0, -1), at(1, 0, 1))) << "through the border";
    EXPECT_TRUE(is_free(scene, at(0, 0, -1), at(0, 0, 1))) << "through a corner";
    EXPECT_TRUE(is_free(scene, at(1, 2, -1), at(1, 2, 0))) << "up to the sheet";
    EXPECT_TRUE(is_free(scene, at(-1, 2, 0), at(5, 1, 0))) << "in its plane";
    EXPECT_EQ(hit(scene, at(1, 2, -1), {0, 0, 1}), "(1, 2, 0) | f0-");
    EXPECT_EQ(hit(scene, at(1, 2, 1), {0, 0, -1}), "(1, 2, 0) | f0");
    EXPECT_EQ(hit(scene, at(1, 2, 0), {0, 0, -1}), "| inf") << "from a sheet one sees both sides";
}

/// An open book: two squares that meet at a right angle along the y-axis.
Scene3 folded_sheet() {
    MeshInput3 mesh;
    mesh.vertices = {{0, 0, 0}, {0, 4, 0}, {4, 0, 0}, {4, 4, 0}, {0, 0, 4}, {0, 4, 4}};
    mesh.faces = {{0, 2, 3, 1}, {0, 1, 5, 4}};
    mesh.kind = SurfaceKind::sheet;
    SceneInput3 input;
    input.meshes = {mesh};
    return testing::scene3(input);
}

TEST(FreeSegment3Degenerate, AFoldIsFreeFromOutsideAndSealedFromInside) {
    const Scene3 scene = folded_sheet();
    EXPECT_TRUE(is_free(scene, at(-1, 1, 1), at(1, 1, -1))) << "grazes the back of the book";
    EXPECT_FALSE(is_free(scene, at(-1, 1, -1), at(1, 1, 1))) << "through the fold";
    EXPECT_EQ(hit(scene, at(1, 1, 1), {-1, 0, -1}), "(0, 1, 0) | f0 f1");
    EXPECT_EQ(hit(scene, at(-1, 1, -1), {1, 0, 1}), "(0, 1, 0) | f0- f1-");
    EXPECT_TRUE(is_free(scene, at(0, -1, 0), at(0, 5, 0))) << "along the fold";
}

TEST(FreeSegment3Degenerate, ASegmentAlongASheetIsJudgedByTheSidesItComesAndLeaves) {
    const Scene3 scene = folded_sheet();
    // In the plane of the lower page, it runs into the fold and out behind the upright page: it came
    // past the lower page's border, so that it may be taken to pass below.
    EXPECT_TRUE(is_free(scene, at(5, 1, 0), at(-1, 1, 0)));
    // Two upright pages, one on each side of a level one: whatever it comes past, it crosses.
    MeshInput3 z_shape;
    z_shape.vertices = {{0, 0, 0}, {0, 4, 0}, {4, 0, 0},  {4, 4, 0},
                        {0, 0, 4}, {0, 4, 4}, {4, 0, -4}, {4, 4, -4}};
    z_shape.faces = {{0, 2, 3, 1}, {0, 1, 5, 4}, {3, 2, 6, 7}};
    z_shape.kind = SurfaceKind::sheet;
    SceneInput3 input;
    input.meshes = {z_shape};
    const Scene3 two_folds = testing::scene3(input);
    EXPECT_FALSE(is_free(two_folds, at(5, 1, 0), at(-1, 1, 0)));
    EXPECT_TRUE(is_free(two_folds, at(5, 1, 0), at(0, 1, 0))) << "up to the far fold";
    EXPECT_TRUE(is_free(two_folds, at(4, 1, 0), at(-1, 1, 0))) << "from the near fold";
    EXPECT_EQ(hit(two_folds, at(5, 1, 0), {-1, 0, 0}), "(0, 1, 0) | f0 f1");
}

TEST(FreeSegment3Degenerate, ASheetThatStandsOnABoxIsSealedThere) {
    const Scene3 scene = scene3("box 0 0 0, 4 4 4; sheet 1 2 4, 3 2 4, 3 2 6, 1 2 6");
    EXPECT_FALSE(is_free(scene, at(2, 1, 4), at(2, 3, 4))) << "along the top, through the foot";
    EXPECT_TRUE(is_free(scene, at(1, 1, 4), at(1, 3, 4))) << "past the sheet's corner";
    EXPECT_TRUE(is_free(scene, at(2, 1, 6), at(2, 3, 6))) << "over the sheet";
}

TEST(FreeSegment3Degenerate, NothingSeparatesWhatSolidsSeparateAlready) {
    // A sheet that ends in the slit between two boxes: the boxes alone part its two sides.
    const Scene3 scene =
        scene3("box 0 0 0, 4 4 4; box 4 4 0, 8 8 4; sheet 4 4 0, 4 4 4, 6 2 4, 6 2 0");
    EXPECT_FALSE(is_free(scene, at(6, 1, 2), at(Rational(11, 2), Rational(7, 2), 2)));
    EXPECT_TRUE(is_free(scene, at(7, 3, 2), at(4, 4, 2)));
    EXPECT_TRUE(is_free(scene, at(6, 2, 2), at(2, 6, 2))) << "in the sheet, through the slit";
}

}  // namespace
}  // namespace sightline
