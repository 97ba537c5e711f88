// SPDX-License-Identifier: GPL-3.0-or-later
// Shooting against the definition, on random small scenes and on degenerate ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <sstream>
#include <string>

#include "sightline/reference/free_segment3.hpp"
#include "sightline/spatial/shooting.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

std::string text_of(const FreeEnd3& end) {
    std::ostringstream out;
    out << end;
    return out.str();
}

/// Points with whole or half coordinates round scenes on grids: often on features, or in line with them.
class Points {
public:
    Points(std::uint64_t seed, const Scene3& scene) : random_(seed), scene_(scene) {
        for (const Point3& p : scene.vertices()) {
            largest_ = std::max({largest_, p.x, p.y, p.z});
        }
    }
    Point3 operator()() {
        const auto below = [&](std::size_t n) { return random_() % n; };
        if (below(3) == 0) return scene_.vertices()[below(scene_.vertices().size())];
        const auto coordinate = [&] {
            const auto steps = static_cast<std::size_t>(2 * largest_) + 5;
            return static_cast<double>(below(steps)) / 2 - 1;
        };
        return {coordinate(), coordinate(), coordinate()};
    }

private:
    std::mt19937_64 random_;
    const Scene3& scene_;
    double largest_ = 1;
};

struct Compared {
    int free = 0;
    int blocked = 0;
    int hits = 0;
};

/// Compares every answer for `pairs` pairs of points; says where they differ.
Compared compare(const Scene3& scene, std::uint64_t seed, int pairs, const std::string& name) {
    Compared compared;
    SegmentShooter shooter(scene);
    SegmentShooter exact(scene, Arithmetic::exact);
    Points points(seed, scene);
    for (int i = 0; i < pairs; ++i) {
        const Point3 p = points();
        const Point3 q = points();
        if (p == q) continue;
        std::ostringstream where;
        where << name << ", seed " << seed << ": " << p << " to " << q;
        const RationalPoint3 from = to_rational(p);
        const RationalPoint3 to = to_rational(q);
        const bool free = reference::is_free(scene, from, to);
        EXPECT_EQ(shooter.is_free(p, q), free) << where.str();
        EXPECT_EQ(exact.is_free(p, q), free) << "exact, " << where.str();
        ++(free ? compared.free : compared.blocked);
        if (reference::is_interior(scene, from)) continue;
        EXPECT_EQ(shooter.sees(p, q), free) << where.str();
        const std::string end = text_of(reference::first_hit(scene, from, to - from));
        EXPECT_EQ(text_of(shooter.first_hit(p, q)), end) << where.str();
        EXPECT_EQ(text_of(exact.first_hit(p, q)), end) << "exact, " << where.str();
        // A third of the way: a point that is no double.
        const RationalPoint3 third = from + Rational(1, 3) * (to - from);
        if (!reference::is_interior(scene, third)) {
            EXPECT_EQ(text_of(shooter.first_hit(third, to - from)),
                      text_of(reference::first_hit(scene, third, to - from)))
                << "from a third, " << where.str();
        }
        ++compared.hits;
        if (::testing::Test::HasFailure()) break;
    }
    return compared;
}

TEST(SegmentShooter, AgreesWithTheReferenceOnRandomScenes) {
    Compared sum;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Scene3 scene = testing::scene3(testing::random_scene3(seed));
        const Compared c = compare(scene, seed, 12, "random scene");
        sum.free += c.free;
        sum.blocked += c.blocked;
        sum.hits += c.hits;
        ASSERT_FALSE(HasFailure()) << testing::to_text(testing::random_scene3(seed));
    }
    EXPECT_GT(sum.free, 200);
    EXPECT_GT(sum.blocked, 150);
    EXPECT_GT(sum.hits, 600);
}

class EveryCorpusScene3 : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryCorpusScene3, ShootsLikeTheReference) {
    compare(testing::degenerate_scene3(GetParam()), 1, 12, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Corpus, EveryCorpusScene3, ::testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, text] : testing::degenerate_scenes3()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& scene) { return scene.param; });

/// Sheets that bend, branch, stand on solids and end in contacts.
const std::map<std::string, std::string>& scenes_of_sheets() {
    static const std::map<std::string, std::string> scenes{
        {"square", "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0"},
        {"on_a_box", "box 0 0 0, 4 4 4; sheet 1 2 4, 3 2 4, 3 2 6, 1 2 6"},
        {"between_boxes", "box 0 0 0, 4 4 2; box 0 0 4, 4 4 6; sheet 1 2 2, 3 2 2, 3 2 4, 1 2 4"},
        {"lid_on_a_box", "box 0 0 0, 4 4 2; sheet 0 0 2, 4 0 2, 4 4 2, 0 4 2"},
        {"larger_lid", "box 1 1 0, 3 3 2; sheet 0 0 2, 4 0 2, 4 4 2, 0 4 2"},
        {"between_two_boxes",
         "box 0 0 0, 2 2 2; box 0 0 2, 2 2 4; sheet 0 0 2, 2 0 2, 2 2 2, 0 2 2"},
        {"two_that_share_an_edge",
         "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0; sheet 0 0 0, 0 4 0, 0 4 4, 0 0 4"},
        {"one_ends_on_another",
         "sheet 0 0 0, 4 0 0, 4 4 0, 0 4 0; sheet 2 1 0, 2 3 0, 2 3 4, 2 1 4"},
        {"in_a_room", "world; box 0 0 0, 8 8 8; sheet 0 4 0, 8 4 0, 8 4 8, 0 4 8"},
        {"screen_in_a_room", "world; box 0 0 0, 8 8 8; sheet 2 4 0, 6 4 0, 6 4 4, 2 4 4"},
        {"in_a_slit", "box 0 0 0, 4 4 4; box 4 4 0, 8 8 4; sheet 4 4 0, 4 4 4, 6 2 4, 6 2 0"},
        {"three_pages",
         "sheet 0 0 0, 4 0 0, 4 0 4, 0 0 4; sheet 0 0 0, 0 4 0, 0 4 4, 0 0 4; sheet 0 0 0, -4 0 0, "
         "-4 0 4, 0 0 4"},
        {"four_pages",
         "sheet 0 0 0, 4 0 0, 4 0 4, 0 0 4; sheet 0 0 0, 0 4 0, 0 4 4, 0 0 4; sheet 0 0 0, -4 0 0, "
         "-4 0 4, 0 0 4; sheet 0 0 0, 0 -4 0, 0 -4 4, 0 0 4"},
        {"at_a_corner", "box 0 0 0, 4 4 4; sheet 4 4 4, 8 4 4, 4 8 6"},
    };
    return scenes;
}

class EverySceneOfSheets : public ::testing::TestWithParam<std::string> {};

TEST_P(EverySceneOfSheets, ShootsLikeTheReference) {
    compare(testing::scene3(scenes_of_sheets().at(GetParam())), 1, 20, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Sheets, EverySceneOfSheets, ::testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, text] : scenes_of_sheets()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& scene) { return scene.param; });

/// A mesh of three squares, each bent at a right angle from the next: a Z, or a U.
Scene3 bent_sheet(bool is_u) {
    MeshInput3 mesh;
    const double far = is_u ? 4 : -4;
    mesh.vertices = {{0, 0, 0}, {0, 4, 0}, {4, 0, 0},   {4, 4, 0},
                     {0, 0, 4}, {0, 4, 4}, {4, 0, far}, {4, 4, far}};
    mesh.faces = {{0, 2, 3, 1}, {0, 1, 5, 4}, {3, 2, 6, 7}};
    mesh.kind = SurfaceKind::sheet;
    SceneInput3 input;
    input.meshes = {mesh};
    return testing::scene3(input);
}

Scene3 one_sheet(std::vector<Point3> vertices, std::vector<std::vector<std::uint32_t>> faces) {
    MeshInput3 mesh;
    mesh.vertices = std::move(vertices);
    mesh.faces = std::move(faces);
    mesh.kind = SurfaceKind::sheet;
    SceneInput3 input;
    input.meshes = {mesh};
    return testing::scene3(input);
}

TEST(SegmentShooterDegenerate, PagesOfOneSheetAreSealedAtTheirBack) {
    const std::vector<Point3> pages{{0, 0, 0}, {0, 0, 4},  {4, 0, 0},  {4, 0, 4},  {0, 4, 0},
                                    {0, 4, 4}, {-4, 0, 0}, {-4, 0, 4}, {0, -4, 0}, {0, -4, 4}};
    compare(one_sheet(pages, {{0, 2, 3, 1}, {0, 4, 5, 1}, {0, 6, 7, 1}}), 1, 40, "3 pages");
    compare(one_sheet(pages, {{0, 2, 3, 1}, {0, 4, 5, 1}, {0, 6, 7, 1}, {0, 8, 9, 1}}), 1, 100,
            "4 pages");
}

TEST(SegmentShooterDegenerate, TheTipOfAnOpenPyramidIsSealed) {
    const std::vector<Point3> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 3}};
    compare(one_sheet(corners, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}), 1, 50, "pyramid");
    compare(one_sheet(corners, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}), 1, 50, "three sides of it");
    compare(one_sheet(corners, {{0, 1, 4}, {2, 3, 4}}), 1, 50, "a bow tie of two");
}

TEST(SegmentShooterDegenerate, BentSheetsAreSealedAtTheirFolds) {
    compare(bent_sheet(false), 1, 100, "Z");
    compare(bent_sheet(true), 1, 100, "U");
}

// No leak: rays aimed exactly at vertices, at points of edges and at points of diagonals of faces stay in
// a closed room.
RC_GTEST_PROP(SegmentShooterLaw, NothingLeavesAClosedRoom, ()) {
    const Scene3 scene = testing::degenerate_scene3(
        *rc::gen::element<std::string>("room_with_box", "room_with_box_on_floor"));
    SegmentShooter shooter(scene);
    const auto coordinate = [] { return *rc::gen::inRange(0, 65) / 8.0; };
    const Point3 p{coordinate(), coordinate(), coordinate()};
    RC_PRE(!reference::is_interior(scene, to_rational(p)));
    const auto& t = scene.triangles()[*rc::gen::inRange<std::size_t>(0, scene.triangles().size())];
    const Point3& a = scene[t.corners[*rc::gen::inRange<std::size_t>(0, 3)]];
    const Point3& b = scene[t.corners[*rc::gen::inRange<std::size_t>(0, 3)]];
    const double s = *rc::gen::inRange(0, 9) / 8.0;
    const Point3 aim{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
    RC_PRE(aim != p);
    const FreeEnd3 end = shooter.first_hit(p, aim);
    RC_ASSERT(end.point.has_value());
    for (const Rational& x : {end.point->x, end.point->y, end.point->z}) {
        RC_ASSERT(Rational(0) <= x && x <= Rational(8));
    }
    const Point3 outside{p.x + 1e6 * (aim.x - p.x), p.y + 1e6 * (aim.y - p.y),
                         p.z + 1e6 * (aim.z - p.z)};
    RC_ASSERT(!shooter.is_free(p, outside));
}

}  // namespace
}  // namespace sightline
