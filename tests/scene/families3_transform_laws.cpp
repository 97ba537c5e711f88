// SPDX-License-Identifier: GPL-3.0-or-later
// Exact transforms of 3D scenes, and the support of tests that draws random ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "scene/families3_support.hpp"
#include "sightline/scene/transform3.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

using families_test::fingerprint;
using families_test::six_volumes;

Rational total_volume(const SceneInput3& scene) {
    Rational sum;
    for (const MeshInput3& mesh : scene.meshes) {
        if (mesh.kind == SurfaceKind::solid) sum = sum + six_volumes(mesh);
    }
    return sum;
}

TEST(Transform3, ExactOnesComeBack) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const SceneInput3 scene = testing::random_scene3(seed);
        const auto there = families::translated3(scene, 1024.5, -3, 1e8);
        ASSERT_TRUE(there);
        EXPECT_NE(fingerprint(*there), fingerprint(scene));
        EXPECT_EQ(fingerprint(*families::translated3(*there, -1024.5, 3, -1e8)),
                  fingerprint(scene));
        EXPECT_EQ(fingerprint(*families::scaled3(*families::scaled3(scene, -1074), 1074)),
                  fingerprint(scene));
        EXPECT_EQ(fingerprint(families::mirrored3(families::mirrored3(scene))), fingerprint(scene));
        const SceneInput3 turned = families::with_axes_permuted3(scene, {1, 2, 0});
        EXPECT_EQ(fingerprint(families::with_axes_permuted3(turned, {2, 0, 1})),
                  fingerprint(scene));
    }
}

TEST(Transform3, KeepsSolidsSolid) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const SceneInput3 scene = testing::random_scene3(seed);
        const Rational volume = total_volume(scene);
        EXPECT_EQ(total_volume(families::mirrored3(scene)), volume);
        for (const std::array<int, 3>& axes :
             {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
            EXPECT_EQ(total_volume(families::with_axes_permuted3(scene, axes)), volume);
        }
        EXPECT_EQ(total_volume(*families::rotated3(scene, {3, 1, 2, 1})),
                  volume * Rational(15 * 15 * 15));
        EXPECT_EQ(total_volume(families::triangulated3(scene)), volume);
        EXPECT_EQ(total_volume(families::permuted3(scene, seed).scene), volume);
    }
}

TEST(Transform3, FailsWhenNotExact) {
    const SceneInput3 scene = testing::scene_input3("box 0 0 0, 1 1 1");
    EXPECT_EQ(families::translated3(scene, 0x1p53, 0, 0x1p-1).error().code, Errc::bad_parameter);
    EXPECT_EQ(
        families::translated3(scene, std::numeric_limits<double>::infinity(), 0, 0).error().code,
        Errc::bad_parameter);
    EXPECT_EQ(families::scaled3(scene, -1075).error().code, Errc::bad_parameter);
    EXPECT_EQ(families::scaled3(scene, 1024).error().code, Errc::coordinate_too_large);
    EXPECT_TRUE(families::scaled3(scene, 1023));
    const auto large = families::scaled3(scene, 1023);
    EXPECT_EQ(families::rotated3(*large, {3, 0, 0, 0}).error().code, Errc::coordinate_too_large);
    EXPECT_THROW(families::rotated3(scene, {0, 0, 0, 0}), ContractViolation);
    EXPECT_THROW(families::with_axes_permuted3(scene, {0, 0, 2}), ContractViolation);
}

TEST(Permuted3, IsARenamingOfVerticesAndFaces) {
    const SceneInput3 scene = testing::scene_input3(
        "world; box 0 0 0, 9 9 9; box 1 1 1, 2 2 2; hull 3 3 3, 4 3 3, 3 4 3, 3 3 4; "
        "sheet 5 5 5, 6 5 5, 5 6 5");
    std::vector<Point3> points;
    std::vector<std::vector<Point3>> faces;
    const auto collect = [](const SceneInput3& input, auto& all_points, auto& all_faces) {
        for (const MeshInput3& mesh : input.meshes) {
            all_points.insert(all_points.end(), mesh.vertices.begin(), mesh.vertices.end());
            for (const auto& face : mesh.faces) {
                all_faces.emplace_back();
                for (const std::uint32_t v : face) all_faces.back().push_back(mesh.vertices[v]);
                // from its least corner, in its own sense
                auto& ring = all_faces.back();
                std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
            }
        }
    };
    collect(scene, points, faces);
    std::set<std::uint64_t> prints;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const families::PermutedScene3 permuted = families::permuted3(scene, seed);
        EXPECT_TRUE(permuted.scene.world);
        EXPECT_EQ(permuted.scene.meshes.front().faces.size(), 6U);
        std::vector<Point3> new_points;
        std::vector<std::vector<Point3>> new_faces;
        collect(permuted.scene, new_points, new_faces);
        ASSERT_EQ(new_points.size(), points.size());
        ASSERT_EQ(new_faces.size(), faces.size());
        for (std::size_t v = 0; v < points.size(); ++v)
            EXPECT_EQ(new_points[v], points[permuted.old_vertex[v]]);
        for (std::size_t f = 0; f < faces.size(); ++f)
            EXPECT_EQ(new_faces[f], faces[permuted.old_face[f]]);
        prints.insert(fingerprint(permuted.scene));
        EXPECT_EQ(std::max_element(new_points.begin(), new_points.begin() + 8)->x, 9);  // the world
    }
    EXPECT_EQ(prints.size(), 20U);
}

TEST(Triangulated3, CutsEachFaceOfKSidesIntoKLessTwoTriangles) {
    for (const auto& [name, text] : testing::degenerate_scenes3()) {
        const SceneInput3 scene = testing::scene_input3(text);
        const SceneInput3 cut = families::triangulated3(scene);
        std::size_t expected = 0;
        std::size_t triangles = 0;
        for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
            for (const auto& face : scene.meshes[m].faces) expected += face.size() - 2;
            for (const auto& face : cut.meshes[m].faces) {
                EXPECT_EQ(face.size(), 3U);
                ++triangles;
            }
        }
        EXPECT_EQ(triangles, expected) << name;
        EXPECT_EQ(total_volume(cut), total_volume(scene)) << name;
    }
}

TEST(Triangulated3, KeepsTheAreaOfNonConvexFaces) {
    // The comb's outline has reflex corners; the sum of the squares of areas can't exceed the square of the sum, so
    // compare the sums of doubled signed areas in the xy plane of its top and bottom.
    const SceneInput3 scene = families::comb3({.teeth = 6}, 3);
    const auto positive_area = [](const MeshInput3& mesh) {
        Rational sum;
        for (const auto& face : mesh.faces) {
            Rational area;
            for (std::size_t i = 1; i + 1 < face.size(); ++i) {
                const Point3& a = mesh.vertices[face[0]];
                const Point3& b = mesh.vertices[face[i]];
                const Point3& c = mesh.vertices[face[i + 1]];
                area = area + Rational(b.x - a.x) * Rational(c.y - a.y) -
                       Rational(b.y - a.y) * Rational(c.x - a.x);
            }
            if (area.sign() == Sign::positive) sum = sum + area;
        }
        return sum;
    };
    EXPECT_EQ(positive_area(families::triangulated3(scene).meshes.front()),
              positive_area(scene.meshes.front()));
}

TEST(ApproxNudged3, MovesSomeCoordinatesByOneUlp) {
    const SceneInput3 scene = families::random_tetrahedra({}, 1);
    const SceneInput3 nudged = families::approx_nudged3(scene, 5, 500);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < scene.meshes[0].vertices.size(); ++v) {
        const double a = scene.meshes[0].vertices[v].y;
        const double b = nudged.meshes[0].vertices[v].y;
        EXPECT_TRUE(a == b || std::nextafter(a, b) == b);
        moved += a == b ? 0 : 1;
    }
    EXPECT_GT(moved, 5U);
    EXPECT_LT(moved, 35U);
    EXPECT_EQ(fingerprint(families::approx_nudged3(scene, 5, 0)), fingerprint(scene));
}

TEST(RandomScene3, IsValid) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const auto made = Scene3::make(testing::random_scene3(seed));
        ASSERT_TRUE(made) << seed << ": " << made.error().message;
    }
}

RC_GTEST_PROP(RandomScene3, KeepsItsFeaturesWhenTriangulatedAndPermuted,
              (const SceneInput3& scene, std::uint64_t seed)) {
    const auto made = Scene3::make(scene);
    RC_ASSERT(made.has_value());
    const auto cut = Scene3::make(families::permuted3(families::triangulated3(scene), seed).scene);
    RC_ASSERT(cut.has_value());
    RC_ASSERT(cut->edges().size() == made->edges().size());
    RC_ASSERT(cut->faces().size() == made->faces().size());
    RC_ASSERT(cut->bodies().size() == made->bodies().size());
}

TEST(DegenerateScenes3, AreValidAndKeepTheirFeaturesWhenTriangulated) {
    for (const auto& [name, text] : testing::degenerate_scenes3()) {
        const SceneInput3 input = testing::scene_input3(text);
        const auto made = Scene3::make(input);
        ASSERT_TRUE(made) << name << ": " << made.error().message;
        const auto cut = Scene3::make(families::triangulated3(input));
        ASSERT_TRUE(cut) << name << ": " << cut.error().message;
        EXPECT_EQ(cut->edges().size(), made->edges().size()) << name;
        EXPECT_EQ(cut->faces().size(), made->faces().size()) << name;
    }
}

TEST(RandomScene3, IsDisjointOrTouchingAndVaried) {
    std::set<std::uint64_t> prints;
    std::size_t shared = 0;
    std::size_t several = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const SceneInput3 scene = testing::random_scene3(seed);
        ASSERT_FALSE(scene.meshes.empty());
        prints.insert(fingerprint(scene));
        several += scene.meshes.size() > 1 ? 1 : 0;
        std::set<Point3> places;
        std::size_t vertices = 0;
        for (const MeshInput3& mesh : scene.meshes) {
            vertices += mesh.vertices.size();
            for (const Point3& p : mesh.vertices) places.insert(p);
            if (mesh.kind == SurfaceKind::solid) {
                EXPECT_EQ(six_volumes(mesh).sign(), Sign::positive);
            }
        }
        shared += places.size() < vertices ? 1 : 0;
    }
    EXPECT_GT(prints.size(), 250U);
    EXPECT_GT(several, 100U);
    EXPECT_GT(shared, 20U);
}

}  // namespace
}  // namespace sightline
