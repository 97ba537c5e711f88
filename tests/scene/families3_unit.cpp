// SPDX-License-Identifier: GPL-3.0-or-later
// Counts and properties that the 3D families promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "scene/families3_detail.hpp"
#include "scene/families3_support.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline {
namespace {

using families::Contact;
using families::SolidShape;
using families::detail::Int3;
using families_test::Counts3;
using families_test::counts_of;

TEST(Solids, HaveTheVerticesEdgesAndFacesOfTheirNames) {
    const auto counts = [](SolidShape shape) { return counts_of(families::solid(shape)); };
    EXPECT_EQ(counts(SolidShape::tetrahedron), (Counts3{4, 6, 4}));
    EXPECT_EQ(counts(SolidShape::cube), (Counts3{8, 12, 6}));
    EXPECT_EQ(counts(SolidShape::octahedron), (Counts3{6, 12, 8}));
    EXPECT_EQ(counts(SolidShape::icosahedron), (Counts3{12, 30, 20}));
    EXPECT_EQ(counts(SolidShape::dodecahedron), (Counts3{20, 30, 12}));
    EXPECT_EQ(counts(SolidShape::l_shape), (Counts3{12, 18, 8}));
    EXPECT_EQ(counts(SolidShape::u_shape), (Counts3{16, 24, 10}));
    EXPECT_EQ(counts(SolidShape::notched_cube), (Counts3{14, 21, 9}));
    EXPECT_EQ(counts(SolidShape::ring), (Counts3{16, 32, 16}));  // top and bottom in four each
}

TEST(Solids, HaveTheRightVolumes) {
    const auto six_volumes = [](SolidShape shape) {
        return families_test::six_volumes(families::solid(shape).meshes.front());
    };
    EXPECT_EQ(six_volumes(SolidShape::tetrahedron), Rational(2));
    EXPECT_EQ(six_volumes(SolidShape::cube), Rational(6));
    EXPECT_EQ(six_volumes(SolidShape::octahedron), Rational(8));
    EXPECT_EQ(six_volumes(SolidShape::l_shape), Rational(18));
    EXPECT_EQ(six_volumes(SolidShape::u_shape), Rational(42));
    EXPECT_EQ(six_volumes(SolidShape::ring), Rational(48));
    EXPECT_EQ(six_volumes(SolidShape::notched_cube), Rational(42));
}

TEST(Solids, PrismsPyramidsAndCombsGrowAsPromised) {
    for (const std::size_t n : {3U, 4U, 7U, 100U}) {
        EXPECT_EQ(counts_of(families::prism({n})), (Counts3{2 * n, 3 * n, n + 2}));
        EXPECT_EQ(counts_of(families::pyramid({n})), (Counts3{n + 1, 2 * n, n + 1}));
        EXPECT_EQ(counts_of(families::comb3({.teeth = n}, 5)), (Counts3{8 * n, 12 * n, 4 * n + 2}));
    }
}

TEST(RandomPolytopes, HaveTheEdgesOnAverageThatAreAskedFor) {
    EXPECT_EQ(counts_of(families::random_polytopes({.count = 60}, 1)), (Counts3{520, 1200, 800}));
    EXPECT_EQ(counts_of(families::random_polytopes({.count = 5, .edges_per_body = 60}, 1)),
              (Counts3{110, 300, 200}));
    EXPECT_EQ(counts_of(families::random_polytopes({.count = 7, .edges_per_body = 6}, 1)),
              (Counts3{28, 42, 28}));
    EXPECT_EQ(
        counts_of(families::random_polytopes({.count = 1, .edges_per_body = 1000}, 1)).vertices,
        335U);
}

/// Vertex lists of the components of a mesh.
std::vector<std::vector<Point3>> components(const MeshInput3& mesh) {
    std::vector<std::vector<Point3>> result;
    for (const families_test::Part& part : families_test::parts_of(mesh)) {
        result.emplace_back();
        for (const Int3& p : part.points) result.back().push_back(families::detail::to_point(p));
    }
    return result;
}

TEST(RandomPolytopes, AreConvexGenericAndOfEvenSizes) {
    const SceneInput3 scene = families::random_polytopes({.count = 9}, 4);
    std::multiset<std::size_t> sizes;
    for (const auto& body : components(scene.meshes.front())) {
        sizes.insert(body.size());
        for (std::size_t i = 0; i < body.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                for (std::size_t k = 0; k < j; ++k) {
                    for (std::size_t l = 0; l < k; ++l) {
                        EXPECT_NE(
                            families_test::determinant(body[i], body[j], body[k], body[l]).sign(),
                            Sign::zero);
                    }
                }
            }
        }
    }
    EXPECT_EQ(sizes, (std::multiset<std::size_t>{8, 8, 8, 9, 9, 9, 9, 9, 9}));
}

TEST(RandomBalls, AreDisjointAndAsDenseAsAsked) {
    for (const std::uint64_t percent : {1U, 10U, 30U}) {
        families::detail::Rng rng(percent);
        const std::vector<Int3> centres = families::detail::random_balls(rng, 400, 1000, percent);
        std::int64_t side = 0;
        for (std::size_t i = 0; i < centres.size(); ++i) {
            side = std::max({side, centres[i].x + 1000, centres[i].y + 1000, centres[i].z + 1000});
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_GT(families::detail::squared_length(centres[i] - centres[j]), 2000 * 2000);
            }
        }
        const auto cube =
            static_cast<double>(side) * static_cast<double>(side) * static_cast<double>(side);
        const double fill = 400 * 4.18879e9 / cube;
        EXPECT_NEAR(fill, static_cast<double>(percent) / 100.0, static_cast<double>(percent) / 500);
    }
}

TEST(TurnedBoxes, AreExactlyRightAngledAndNotAxisParallel) {
    const SceneInput3 scene = families::turned_boxes({.count = 30}, 2);
    for (const auto& box : components(scene.meshes.front())) {
        ASSERT_EQ(box.size(), 8U);
        const auto edge = [&](std::size_t to) {
            return Int3{static_cast<std::int64_t>(box[to].x - box[0].x),
                        static_cast<std::int64_t>(box[to].y - box[0].y),
                        static_cast<std::int64_t>(box[to].z - box[0].z)};
        };
        const std::array<Int3, 3> axes{edge(1), edge(3), edge(4)};
        for (std::size_t i = 0; i < 3; ++i) {
            const Int3 u = axes[i];
            const Int3 v = axes[(i + 1) % 3];
            EXPECT_EQ(u.x * v.x + u.y * v.y + u.z * v.z, 0);
            EXPECT_GT((u.x != 0) + (u.y != 0) + (u.z != 0), 1);
        }
    }
}

TEST(ThinBodies, AreManyTimesLongerThanWide) {
    const SceneInput3 scene = families::thin_triangles({.count = 50}, 2);
    for (const auto& t : components(scene.meshes.front())) {
        std::array<double, 3> squares{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Point3& p = t[i];
            const Point3& q = t[(i + 1) % 3];
            squares[i] =
                (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
        }
        std::sort(squares.begin(), squares.end());
        // Heron: 16 area² = 4 a²b² − (a² + b² − c²)²; height = 2 area / longest.
        const double sum = squares[0] + squares[1] - squares[2];
        const double height_squared = (4 * squares[0] * squares[1] - sum * sum) / 4 / squares[2];
        EXPECT_GT(squares[2], 900 * height_squared);
        EXPECT_GT(height_squared, 0);
    }
}

/// How many bodies have a vertex at each place.
std::map<std::tuple<double, double, double>, int> places(const SceneInput3& scene) {
    std::map<std::tuple<double, double, double>, int> result;
    for (const MeshInput3& mesh : scene.meshes) {
        for (const Point3& p : mesh.vertices) ++result[{p.x, p.y, p.z}];
    }
    return result;
}

TEST(Grid3, IsALatticeOfUnitCubes) {
    const SceneInput3 scene = families::grid3({3, 2, 4});
    EXPECT_EQ(counts_of(scene), (Counts3{192, 288, 144}));
    EXPECT_EQ(places(scene).size(), 192U);
    const SceneInput3 packed = families::packed_grid3({3, 2, 4});
    EXPECT_EQ(counts_of(packed), (Counts3{192, 288, 144}));
    EXPECT_EQ(places(packed).size(), 4U * 3U * 5U);
}

TEST(RotatedGrid3, IsTheGridTimesAMatrixOfDeterminant3375) {
    const SceneInput3 scene = families::rotated_grid3({2, 2, 2});
    EXPECT_EQ(families_test::six_volumes(scene.meshes.front()), Rational(8 * 6 * 15 * 15 * 15));
    for (const auto& face : scene.meshes.front().faces) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Point3& p = scene.meshes.front().vertices[face[i]];
            const Point3& q = scene.meshes.front().vertices[face[(i + 1) % 4]];
            EXPECT_GT((p.x != q.x) + (p.y != q.y) + (p.z != q.z), 1);
        }
    }
}

TEST(Checkerboard3, HasFourBodiesAtEachInnerCorner) {
    const SceneInput3 scene = families::checkerboard3({3, 3, 3});
    EXPECT_EQ(components(scene.meshes.front()).size(), 14U);
    const auto all = places(scene);
    EXPECT_EQ(all.at({1, 1, 1}), 4);
    EXPECT_EQ(all.at({2, 1, 2}), 4);
    EXPECT_EQ(all.at({0, 0, 0}), 1);
}

TEST(CubesRoundVertex, AllContainTheOrigin) {
    for (std::size_t n = 1; n <= 8; ++n) {
        EXPECT_EQ(places(families::cubes_round_vertex({n}, 3)).at({0, 0, 0}), static_cast<int>(n));
    }
}

TEST(StackedBoxes, LieOnEachOther) {
    const SceneInput3 scene = families::stacked_boxes({30}, 9);
    const auto boxes = components(scene.meshes.front());
    ASSERT_EQ(boxes.size(), 30U);
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        const Point3& low = boxes[i][0];
        const Point3& high = boxes[i][6];
        const Point3& low_below = boxes[i - 1][0];
        const Point3& high_below = boxes[i - 1][6];
        EXPECT_EQ(low.z, high_below.z);
        EXPECT_LT(std::max(low.x, low_below.x), std::min(high.x, high_below.x));
        EXPECT_LT(std::max(low.y, low_below.y), std::min(high.y, high_below.y));
    }
}

TEST(TouchingChain3, TouchesOnlyNeighboursAndInAllWays) {
    const SceneInput3 scene = families::touching_chain3({200}, 9);
    const auto boxes = components(scene.meshes.front());
    std::map<std::pair<bool, bool>, int> ways;  // overlap of positive length in y, in z
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        EXPECT_EQ(boxes[i][0].x, boxes[i - 1][6].x);
        const double y = std::abs(boxes[i][0].y - boxes[i - 1][0].y);
        const double z = std::abs(boxes[i][0].z - boxes[i - 1][0].z);
        EXPECT_LE(std::max(y, z), 4);
        ++ways[{y < 4, z < 4}];
    }
    EXPECT_EQ(ways.size(), 4U);
}

}  // namespace
}  // namespace sightline
