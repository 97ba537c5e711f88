// SPDX-License-Identifier: GPL-3.0-or-later
// All positions of two small bodies on a grid, touching in every way and apart, against brute force.
#include <gtest/gtest.h>

#include "sightline/skeleton/build.hpp"
#include "support/skeleton_laws.hpp"

namespace sightline {
namespace {

VisibilitySkeleton swept(const Scene3& scene) { return visibility_skeleton(scene); }

void expect_same(const SceneInput3& input) {
    EXPECT_TRUE(testing::equals_reference(testing::scene3(input), swept))
        << testing::to_text(input);
}

/// Offsets with |x| >= |y| >= |z| stand for all, up to symmetry; signs are kept, since ids are not symmetric.
TEST(VisibilitySkeletonExhaustive, TwoBoxesAtAllOffsets) {
    const MeshInput3 box = testing::box_mesh({0, 0, 0}, {2, 2, 2});
    for (int x = 2; x <= 3; ++x) {
        for (int y = -x; y <= x; ++y) {
            for (int z = 0; z <= std::abs(y); ++z) {
                const double dx = x;
                const double dy = y;
                const double dz = z;
                SceneInput3 input;
                input.meshes = {box, testing::box_mesh({dx, dy, dz}, {dx + 2, dy + 2, dz + 2})};
                expect_same(input);
            }
        }
    }
}

/// A tetrahedron whose top is moved over, into the corners of, and beside the side of a box.
TEST(VisibilitySkeletonExhaustive, ATetrahedronUnderABox) {
    const MeshInput3 box = testing::box_mesh({0, 0, 0}, {2, 2, 2});
    for (double x = -1; x <= 3; ++x) {
        for (double y = -1; y <= x; ++y) {
            SceneInput3 input;
            input.meshes = {box, testing::hull_mesh(
                                     {{x, y, 0}, {x - 1, y, -2}, {x + 2, y, -2}, {x, y + 3, -2}})};
            expect_same(input);
        }
    }
}

/// Two triangles in space: one fixed, of the other one corner goes everywhere where they do not cross.
TEST(VisibilitySkeletonExhaustive, TwoTriangles) {
    const MeshInput3 fixed = testing::sheet_mesh({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
    for (double x = -1; x <= 3; ++x) {
        for (double y = -1; y <= 3; ++y) {
            for (double z = 1; z <= 2; ++z) {
                SceneInput3 input;
                input.meshes = {fixed, testing::sheet_mesh({{x, y, z}, {0, 1, 1}, {2, 2, 1}})};
                if (x == 2 * (y - 1) && z == 1) continue;  // on one line
                expect_same(input);
            }
        }
    }
}

}  // namespace
}  // namespace sightline
