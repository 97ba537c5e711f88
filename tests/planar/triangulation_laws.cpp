// SPDX-License-Identifier: GPL-3.0-or-later
// What any triangulation of a scene must satisfy: on random scenes, on all families, and at the ends of
// the doubles.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "planar/triangulation.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/locate2.hpp"
#include "support/arbitrary.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

using namespace detail;

template <typename Visit>
void for_each_half_edge(const Triangulation& t, const Visit& visit) {
    for (HalfEdge h = 0; h < 4 * t.triangle_count(); ++h)
        if ((h & 3U) != 3U) visit(h);
}

void expect_sound_links(const Triangulation& t) {
    std::size_t border = 0;
    for_each_half_edge(t, [&](HalfEdge h) {
        const HalfEdge g = t.twin(h);
        ASSERT_EQ(t.orientation(t.origin(h), t.target(h), t.apex(h)), Sign::positive);
        if (g == no_index) {
            ++border;
            return;
        }
        ASSERT_EQ(t.twin(g), h);
        ASSERT_EQ(t.origin(g), t.target(h));
        ASSERT_EQ(t.target(g), t.origin(h));
        ASSERT_EQ(t.is_wall(g), t.is_wall(h));
        ASSERT_EQ(t.is_boundary(g), t.is_boundary(h));
        ASSERT_TRUE(t.is_boundary(h) || t.is_free(g) == t.is_free(h));
    });
    EXPECT_EQ(border, 6U) << "the frame has four corners and two places on its sides";
    EXPECT_EQ(t.triangle_count(), 2 * t.place_count() - 8) << "Euler's formula";
    for (Place p = 0; p < t.place_count(); ++p) ASSERT_EQ(t.origin(t.leaving(p)), p);
}

// The constrained half-edge from p straight towards `end`, or no_index.
HalfEdge piece_towards(const Triangulation& t, Place p, Place end) {
    HalfEdge h = t.leaving(p);
    do {
        const Place q = t.target(h);
        if (t.is_constrained(h) && t.orientation(p, end, q) == Sign::zero &&
            t.compare(p, q) == t.compare(p, end))
            return h;
        h = t.rotate_ccw(h);
    } while (h != t.leaving(p));
    return no_index;
}

void expect_scene_edges(const Scene2& scene, const Triangulation& t) {
    for (const Edge2& e : scene.edges()) {
        const Place end = t.place_of(e.target);
        for (Place p = t.place_of(e.source); p != end;) {
            const HalfEdge h = piece_towards(t, p, end);
            ASSERT_NE(h, no_index) << "a piece of an edge is missing";
            const bool wall = e.kind == EdgeKind2::wall;
            ASSERT_TRUE(wall ? t.is_wall(h) : t.is_boundary(h));
            ASSERT_TRUE(wall || !t.is_free(h)) << "a body lies on the left of its edges";
            p = t.target(h);
        }
    }
}

// Every step-th triangle, by its centroid.
void expect_labels(const Scene2& scene, const Triangulation& t, std::size_t step) {
    for (std::size_t i = 0; i < t.triangle_count(); i += step) {
        const auto h = static_cast<HalfEdge>(4 * i);
        RationalPoint2 center{0, 0};
        for (const Place p : {t.origin(h), t.target(h), t.apex(h)}) {
            const RationalPoint2 corner = t.exact_position(p);
            center = {center.x + corner.x / Rational(3), center.y + corner.y / Rational(3)};
        }
        const PlaceKind2 kind = locate(scene, center).kind;
        ASSERT_EQ(t.is_free(h), kind == PlaceKind2::free);
    }
}

void expect_sound(const Scene2& scene, unsigned threads, std::size_t step) {
    const Triangulation t(scene, {}, threads);
    expect_sound_links(t);
    if (::testing::Test::HasFatalFailure()) return;
    expect_scene_edges(scene, t);
    if (::testing::Test::HasFatalFailure()) return;
    expect_labels(scene, t, step);
}

TEST(TriangulationLaws, HoldOnRandomScenes) {
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        const SceneInput2 input = testing::random_scene(seed);
        SCOPED_TRACE(testing::to_text(input));
        expect_sound(Scene2::make(input).value(), 1 + seed % 2, 1);
        if (HasFailure()) return;
    }
}

TEST(TriangulationLaws, HoldOnAllFamilies) {
    for (const families::FamilyInfo& family : families::all2()) {
        SCOPED_TRACE(std::string(family.name));
        const Scene2 scene = Scene2::make(*families::generate2(family.name, {}, 3)).value();
        expect_sound(scene, 1, 1 + scene.vertex_count() / 50);
        expect_sound(scene, 2, 1 + scene.vertex_count() / 50);
        if (HasFailure()) return;
    }
}

TEST(TriangulationLaws, HoldForCoordinatesOfAllSizes) {
    const std::pair<int, int> ranges[] = {{-1074, 1019}, {-1074, -1000}, {900, 1019}, {-600, -400},
                                          {-60, 60},     {-340, 340},    {-1074, 60}};
    for (std::uint64_t seed = 1; seed <= 210; ++seed) {
        const auto [least, greatest] = ranges[seed % std::size(ranges)];
        const SceneInput2 input = testing::scene_of_all_sizes(seed, least, greatest, 8);
        SCOPED_TRACE(testing::to_text(input));
        expect_sound(Scene2::make(input).value(), 1, 1);
        if (HasFailure()) return;
    }
}

// One edge through a thousand others, which have to be flipped away.
TEST(TriangulationLaws, HoldForAnEdgeThatCrossesManyTriangles) {
    SceneInput2 input;
    for (int i = 0; i < 500; ++i) {
        const double x = i;
        input.elements.emplace_back(Point2{x, 1.0 + (i * 7) % 5});
        input.elements.emplace_back(Point2{x + 0.5, -1.0 - (i * 11) % 7});
    }
    input.elements.emplace_back(Polyline2{{{-1, 0}, {501, 0.25}}});
    expect_sound(Scene2::make(input).value(), 1, 20);
}

}  // namespace
}  // namespace sightline
