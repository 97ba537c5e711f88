// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D families that touch, align and nearly align do so exactly as they say; rooms and cities are made of disjoint
// boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/families3_support.hpp"
#include "sightline/scene/families3.hpp"

namespace sightline {
namespace {

using families::Contact;
using families_test::Counts3;
using families_test::counts_of;
using families_test::Int3;
using families_test::Lie;
using families_test::lies_of;
using families_test::Part;
using families_test::parts_of;
using families_test::six_volumes;
using families_test::stabs;
using families_test::Wide;

using Lies = std::map<Lie, std::size_t>;

TEST(Touching, HappensInEachWayWithoutOverlap) {
    for (std::size_t i = 0; i < families::contact_count; ++i) {
        EXPECT_EQ(lies_of(families::touching(static_cast<Contact>(i))), (Lies{{Lie::touch, 1}}))
            << i;
    }
}

TEST(Touching, GeneralScenesDoNotOverlap) {
    EXPECT_EQ(lies_of(families::random_tetrahedra({.count = 40}, 1)), (Lies{{Lie::apart, 780}}));
    EXPECT_EQ(lies_of(families::thin_tetrahedra({.count = 40}, 1)), (Lies{{Lie::apart, 780}}));
    EXPECT_EQ(lies_of(families::random_boxes({.count = 40}, 1)), (Lies{{Lie::apart, 780}}));
    EXPECT_EQ(lies_of(families::turned_boxes({.count = 40}, 1)), (Lies{{Lie::apart, 780}}));
    EXPECT_EQ(lies_of(families::random_polytopes({.count = 20}, 1)), (Lies{{Lie::apart, 190}}));
    EXPECT_EQ(lies_of(families::two_boxes_triangle()), (Lies{{Lie::apart, 3}}));
    EXPECT_EQ(lies_of(families::perturbed_grid3({3, 3, 2}, 1)), (Lies{{Lie::apart, 153}}));
    EXPECT_EQ(lies_of(families::turned_grid3({3, 3, 2}, 1)), (Lies{{Lie::apart, 153}}));
    EXPECT_EQ(lies_of(families::packed_grid3({2, 2, 2})), (Lies{{Lie::touch, 28}}));
}

TEST(RoomWithFurniture, HasTheFacesThatAreAskedFor) {
    EXPECT_EQ(counts_of(families::room_with_furniture({}, 1)), (Counts3{2000, 3000, 1500}));
    EXPECT_EQ(counts_of(families::room_with_furniture({.turned = true, .world = false}, 1)),
              (Counts3{2000, 3000, 1500}));
    EXPECT_EQ(counts_of(families::room_with_furniture({.polygons = 100}, 1)),
              (Counts3{128, 192, 96}));
}

TEST(RoomWithFurniture, TouchesInFacesOrNotAtAllAndStaysInTheRoom) {
    for (const bool turned : {false, true}) {
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            const SceneInput3 room =
                families::room_with_furniture({.polygons = 600, .turned = turned}, seed);
            Lies lies = lies_of(room);
            EXPECT_EQ(lies[Lie::overlap], 0U);
            EXPECT_GT(lies[Lie::touch], 60U);
            const SceneInput3 lifted = families::room_with_furniture(
                {.polygons = 600, .turned = turned, .lifted = true}, seed);
            EXPECT_EQ(lies_of(lifted), (Lies{{Lie::apart, 99 * 98 / 2}}));
            for (const SceneInput3* scene : {&room, &lifted}) {
                const Point3& corner = scene->meshes[0].vertices[6];
                bool on_floor = false;
                for (const Point3& p : scene->meshes[1].vertices) {
                    EXPECT_TRUE(p.x > 0 && p.y > 0 && p.z >= 0);
                    EXPECT_TRUE(p.x < corner.x && p.y < corner.y && p.z < corner.z);
                    on_floor = on_floor || p.z == 0;
                }
                EXPECT_EQ(on_floor, scene == &room);
            }
        }
    }
}

TEST(RoomWithFurniture, TurnsEachPieceAsAWhole) {
    const auto slanted_edges = [](bool turned) {
        const SceneInput3 room = families::room_with_furniture({.turned = turned}, 5);
        std::size_t count = 0;
        for (const Part& part : parts_of(room.meshes[1])) {
            for (const Int3& edge : part.edges())
                count += (edge.x != 0) + (edge.y != 0) + (edge.z != 0) > 1 ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(slanted_edges(false), 0U);
    EXPECT_EQ(slanted_edges(true), 249U * 8U);
}

TEST(Building, HasPillarsWallsAndDoors) {
    const SceneInput3 scene = families::building({.columns = 3, .rows = 2}, 4);
    ASSERT_TRUE(scene.world);
    EXPECT_EQ(scene.meshes[0].vertices.size(), 8U);
    const std::vector<Part> parts = parts_of(scene.meshes[1]);
    EXPECT_EQ(parts.size(), 2U + 7U);  // pillars, inner walls
    const auto doors = std::count_if(parts.begin(), parts.end(),
                                     [](const Part& part) { return part.faces.size() == 10; });
    EXPECT_GT(doors, 2);
    EXPECT_EQ(lies_of(scene)[Lie::overlap], 0U);
    const Point3 corner = scene.meshes[0].vertices[6];
    const Point3 origin = scene.meshes[0].vertices[0];
    for (const Point3& p : scene.meshes[1].vertices) {
        EXPECT_TRUE(p.x >= origin.x && p.y >= origin.y && p.x <= corner.x && p.y <= corner.y);
        EXPECT_TRUE(p.z == 0 || p.z == 30 || p.z == corner.z);
    }
    const SceneInput3 open = families::building({.columns = 3, .rows = 2, .world = false}, 4);
    EXPECT_EQ(parts_of(open.meshes[0]).size(), 1U + 12U + 17U);
}

TEST(City3, IsOfDisjointOrTouchingHouses) {
    const SceneInput3 scene = families::city3({4, 4}, 2);
    Lies lies = lies_of(scene);
    EXPECT_EQ(lies[Lie::overlap], 0U);
    EXPECT_GE(lies[Lie::touch], 16U);
    EXPECT_GT(lies[Lie::apart], 100U);
}

TEST(Terrain, IsAHeightFieldOfTriangles) {
    for (const std::size_t levels : {0U, 1U, 4U}) {
        const std::size_t side = std::size_t{1} << levels;
        const SceneInput3 sheet = families::terrain({.levels = levels}, 3);
        EXPECT_EQ(counts_of(sheet),
                  (Counts3{(side + 1) * (side + 1), 3 * side * side + 2 * side, 2 * side * side}));
        const MeshInput3& mesh = sheet.meshes.front();
        for (const auto& face : mesh.faces) {
            const auto at = [&](std::size_t i) { return mesh.vertices[face[i]]; };
            EXPECT_EQ((at(1).x - at(0).x) * (at(2).y - at(0).y) -
                          (at(1).y - at(0).y) * (at(2).x - at(0).x),
                      256.0 * 256.0);
        }
        const SceneInput3 solid = families::terrain({.levels = levels, .solid = true}, 3);
        EXPECT_EQ(solid.meshes.front().faces.size(), 2 * side * side + 4 * side + 1);
    }
}

TEST(CurvedSurfaces, HaveTheirEulerCharacteristics) {
    const auto euler = [](const SceneInput3& scene) {
        const Counts3 c = counts_of(scene);
        return static_cast<int>(c.vertices + c.faces) - static_cast<int>(c.edges);
    };
    EXPECT_EQ(euler(families::icosphere({3})), 2);
    EXPECT_EQ(counts_of(families::icosphere({3})).faces, 1280U);
    EXPECT_EQ(euler(families::torus({7, 5})), 0);
    EXPECT_EQ(counts_of(families::torus({7, 5})).faces, 70U);
    EXPECT_EQ(euler(families::cylinder({9, 4})), 2);
    EXPECT_EQ(counts_of(families::cylinder({9, 4})).faces, 38U);
}

TEST(CurvedSurfaces, HaveTheFeaturesOfTheirShapes) {
    const auto cylinder = Scene3::make(families::cylinder({9, 4}));
    ASSERT_TRUE(cylinder);
    EXPECT_EQ(cylinder->faces().size(), 11U);
    EXPECT_EQ(cylinder->edges().size(), 27U);
    const auto ring = Scene3::make(families::solid(families::SolidShape::ring));
    ASSERT_TRUE(ring);
    EXPECT_EQ(ring->faces().size(), 10U);
    EXPECT_EQ(ring->edges().size(), 24U);
    const auto holes = std::count_if(ring->faces().begin(), ring->faces().end(),
                                     [](const Face3& face) { return face.rings.size() == 2; });
    EXPECT_EQ(holes, 2);
    const auto sphere = families::icosphere({2});
    for (const Part& part : parts_of(sphere.meshes.front())) EXPECT_TRUE(part.is_convex());
}

TEST(CoplanarFaces, LieInOnePlaneOnBothSides) {
    const SceneInput3 scene = families::coplanar_faces({.count = 20}, 3);
    EXPECT_EQ(lies_of(scene)[Lie::overlap], 0U);
    std::map<Sign, std::size_t> sides;
    // Each body has exactly three vertices of height zero along the turned z axis.
    const families::detail::Turn turn = families::detail::turn_of(3, 1, 2, 1);
    for (const Part& part : parts_of(scene.meshes.front())) {
        std::size_t on = 0;
        for (const Int3& p : part.points) {
            const Wide height = families_test::extent({p}, turn.z).first;
            on += height == 0 ? 1 : 0;
            if (height != 0) ++sides[height > 0 ? Sign::positive : Sign::negative];
        }
        EXPECT_EQ(on, 3U);
    }
    EXPECT_GT(sides[Sign::positive], 2U);
    EXPECT_GT(sides[Sign::negative], 2U);
}

TEST(CollinearEdges, LieOnOneLine) {
    const SceneInput3 scene = families::collinear_edges({.count = 20}, 3);
    EXPECT_EQ(lies_of(scene), (Lies{{Lie::apart, 190}}));
    const Int3 direction = families::detail::turn_of(3, 1, 2, 1).x;
    for (const Part& part : parts_of(scene.meshes.front())) {
        const auto on = std::count_if(part.points.begin(), part.points.end(), [&](Int3 p) {
            return families::detail::cross3(p, direction) == Int3{};
        });
        EXPECT_EQ(on, 2);
    }
}

TEST(ConcurrentEdges, PointAtTheFreeOrigin) {
    const SceneInput3 scene = families::concurrent_edges({.count = 30}, 3);
    EXPECT_EQ(lies_of(scene), (Lies{{Lie::apart, 435}}));
    for (const Part& part : parts_of(scene.meshes.front())) {
        std::size_t through = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                through += families::detail::cross3(part.points[i], part.points[j]) == Int3{};
            }
        }
        EXPECT_EQ(through, 1U);
    }
}

TEST(VerticesInPlane, TouchThePlaneOfTheTableInOneVertexEach) {
    const SceneInput3 scene = families::vertices_in_plane({.count = 12}, 3);
    EXPECT_EQ(lies_of(scene)[Lie::overlap], 0U);
    const Int3 up = families::detail::turn_of(3, 1, 2, 1).z;
    const std::vector<Part> parts = parts_of(scene.meshes.front());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto on = std::count_if(parts[i].points.begin(), parts[i].points.end(), [&](Int3 p) {
            return families_test::extent({p}, up).first == 0;
        });
        EXPECT_EQ(on, i == 0 ? 3 : 1);
        EXPECT_EQ(families_test::extent(parts[i].points, up).first < 0, i == 0);
    }
}

/// Twice the point, so that halves are whole.
Part doubled(Part part) {
    for (Int3& p : part.points) p = 2 * p;
    return part;
}

TEST(RegulusEdges, AreAllGrazedByTheLinesOfTheOtherRuling) {
    const SceneInput3 scene = families::regulus_edges({.count = 10}, 3);
    EXPECT_EQ(lies_of(scene), (Lies{{Lie::apart, 45}}));
    for (const Part& small : parts_of(scene.meshes.front())) {
        const Part part = doubled(small);
        const auto on = std::count_if(part.points.begin(), part.points.end(), [](Int3 p) {
            return 2 * p.z == p.x * p.y;  // z = xy in halves
        });
        EXPECT_EQ(on, 2);
        for (std::int64_t y = -7; y <= 7; ++y) {  // the line (t, y/2, t y/2)
            EXPECT_FALSE(stabs(part, {0, y, 0}, {2, 0, y}));
            EXPECT_TRUE(stabs(part, {0, y, 1}, {2, 0, y})) << "no grazing at y = " << y << "/2";
        }
    }
}

/// The sign of the discriminant of xy − z along the line of the fourth body's first edge: how many of the lines that
/// meet three rulings meet it.
Sign discriminant(const SceneInput3& scene) {
    std::vector<Point3> ends;
    for (const Point3& p : scene.meshes.front().vertices) {
        if ((p.x == 15 || p.x == 17) && std::abs(p.y) == 1) ends.push_back(p);
    }
    EXPECT_EQ(ends.size(), 2U);
    const auto f = [&](int s) {  // at ends[0] + s (ends[1] − ends[0])
        const Rational t(s);
        const auto at = [&](double a, double b) {
            return Rational(a) + t * (Rational(b) - Rational(a));
        };
        return at(ends[0].x, ends[1].x) * at(ends[0].y, ends[1].y) - at(ends[0].z, ends[1].z);
    };
    const Rational c = f(0);
    const Rational a = (f(1) + f(-1)) / Rational(2) - c;
    const Rational b = (f(1) - f(-1)) / Rational(2);
    return (b * b - Rational(4) * a * c).sign();
}

TEST(DoubleRoot, HasOneTwoOrNoTransversals) {
    EXPECT_EQ(discriminant(families::double_root()), Sign::zero);
    EXPECT_EQ(discriminant(families::double_root(1)), Sign::positive);
    EXPECT_EQ(discriminant(families::double_root(-1)), Sign::negative);
    EXPECT_EQ(discriminant(families::double_root(100)), Sign::positive);
}

TEST(DoubleRoot, IsFree) {
    const SceneInput3 scene = families::double_root();
    EXPECT_EQ(lies_of(scene), (Lies{{Lie::apart, 6}}));
    for (const Part& part : parts_of(scene.meshes.front()))
        EXPECT_FALSE(stabs(part, {0, 0, 0}, {1, 0, 0}));
}

TEST(NearlyAligned, DiffersByAnUlpAndNoLongerAligns) {
    const SceneInput3 exact = families::coplanar_faces({.count = 20}, 3);
    const SceneInput3 near = families::coplanar_faces({.count = 20, .near = true}, 3);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < exact.meshes[0].vertices.size(); ++v) {
        const double a = exact.meshes[0].vertices[v].z;
        const double b = near.meshes[0].vertices[v].z;
        EXPECT_TRUE(a == b || std::nextafter(a, b) == b);
        moved += a == b ? 0 : 1;
    }
    EXPECT_GT(moved, 20U);
    EXPECT_EQ(exact.meshes[0].faces, near.meshes[0].faces);
}

TEST(FarPolytopes, AreThePolytopesMovedAndScaledExactly) {
    const SceneInput3 near = families::random_polytopes({.count = 4}, 6);
    const SceneInput3 far = families::far_polytopes({.count = 4, .shift = 1e8, .exponent = 10}, 6);
    EXPECT_EQ(six_volumes(far.meshes[0]), six_volumes(near.meshes[0]) * Rational(0x1p30));
    EXPECT_EQ(far.meshes[0].vertices[0].y, (near.meshes[0].vertices[0].y - 1e8) * 1024);
    const SceneInput3 denormal = families::far_polytopes({.count = 4, .exponent = -1074}, 6);
    for (const Point3& p : denormal.meshes[0].vertices) EXPECT_LT(std::abs(p.x), 0x1p-1022);
}

}  // namespace
}  // namespace sightline
