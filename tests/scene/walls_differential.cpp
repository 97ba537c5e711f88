// SPDX-License-Identifier: GPL-3.0-or-later
// Walls among bodies against the definition: between two places where its line meets a boundary line,
// a wall lies in one region, and its middle there says which.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "scene/scene_helpers.hpp"
#include "sightline/scene/locate2.hpp"

namespace sightline {
namespace {

RationalPoint2 at(const Segment2& s, const Rational& t) {
    const RationalPoint2 a = to_rational(s.source);
    const RationalPoint2 b = to_rational(s.target);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Whether some piece of the wall lies inside of a body or outside of the world, and not on a boundary.
bool enters_solid(const Scene2& scene, const Segment2& wall) {
    std::vector<Rational> cuts = {Rational(0), Rational(1)};
    const RationalPoint2 a = to_rational(wall.source);
    const RationalPoint2 b = to_rational(wall.target);
    for (const Edge2& e : scene.edges()) {
        const RationalPoint2 c = to_rational(scene[e.source]);
        const RationalPoint2 d = to_rational(scene[e.target]);
        const Rational w = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
        if (w == Rational(0)) {
            // Parallel: the ends of the edge cut the wall where they project onto it.
            for (const RationalPoint2& p : {c, d}) {
                const Rational length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
                cuts.push_back(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length);
            }
            continue;
        }
        cuts.push_back(((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / w);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i - 1] == cuts[i] || cuts[i] > Rational(1) || cuts[i - 1] < Rational(0)) continue;
        const Location2 found = locate(scene, at(wall, (cuts[i - 1] + cuts[i]) / Rational(2)));
        const bool on_edge = !found.edge.is_none();  // running along a sealed contact is allowed
        if (!on_edge &&
            (found.kind == PlaceKind2::inside_body || found.kind == PlaceKind2::outside_world))
            return true;
    }
    return false;
}

TEST(WallsDifferential, AreAcceptedExactlyWhenTheyEnterNoSolid) {
    const char* const world =
        "POLYGON ((0 0, 12 0, 12 12, 0 12), (1 1, 5 1, 5 5, 1 5), (5 2, 8 2, 8 4, 5 4), (0 8, 3 8, "
        "3 12, 0 12), (9 9, 12 12, 10 8)) "
        "POLYGON ((6 6, 9 6, 9 9, 6 9), (6 6, 8 7, 7 8)) POLYGON ((3 8, 5 6, 5 9, 4 8, 4 10)) ";
    const Scene2 bodies = test::scene_of(world, true);
    const SceneInput2 base = *read_wkt(std::string_view(world), {.world = true});
    std::mt19937_64 random(11);
    const auto coordinate = [&random] { return static_cast<double>(random() % 27) / 2 - 0.5; };
    int accepted = 0;
    for (int i = 0; i < 4000; ++i) {
        Segment2 wall{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
        // Short ones too: most long walls cross something.
        if (i % 2 == 0)
            wall.target = {wall.source.x + static_cast<double>(random() % 5) - 2,
                           wall.source.y + static_cast<double>(random() % 5) - 2};
        if (wall.source == wall.target) continue;
        SceneInput2 input = base;
        input.elements.emplace_back(Polyline2{{wall.source, wall.target}});
        const auto scene = Scene2::make(input);
        ASSERT_EQ(scene.has_value(), !enters_solid(bodies, wall))
            << wall.source.x << " " << wall.source.y << ", " << wall.target.x << " "
            << wall.target.y << ": " << (scene ? "accepted" : scene.error().message);
        accepted += scene ? 1 : 0;
    }
    EXPECT_GT(accepted, 200);
    EXPECT_LT(accepted, 3000);
}

}  // namespace
}  // namespace sightline
