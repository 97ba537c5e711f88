// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of graphs and views under every arithmetic: they end, their tallies add up, certain ones are
// right for coordinates of all sizes, limits are kept.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "sightline/planar/exact_points.hpp"
#include "sightline/planar/visibility_graph.hpp"
#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/reference/visibility_graph.hpp"
#include "sightline/scene/families.hpp"
#include "support/arbitrary.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

constexpr Arithmetic all_arithmetics[] = {Arithmetic::filtered, Arithmetic::exact,
                                          Arithmetic::interval, Arithmetic::double_};

void expect_sums(const Tally& tally) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Predicate::count_); ++i) {
        const TierCounts& c = tally[static_cast<Predicate>(i)];
        EXPECT_EQ(c.calls, c.filter + c.interval + c.exact + c.undecided);
    }
}

// A small scene of each family: the smallest parameters that the family takes, or a few more.
Scene2 small_scene(const families::FamilyInfo& family) {
    std::vector<std::string> parameters;
    for (const families::FamilyParameter& p : family.parameters)
        parameters.push_back(
            std::to_string(std::min(p.default_value, std::max<std::uint64_t>(p.least, 40))));
    return Scene2::make(*families::generate2(family.name, parameters, 5)).value();
}

TEST(ArithmeticLaws, EveryArithmeticEndsAndItsTallyAddsUp) {
    for (const families::FamilyInfo& family : families::all2()) {
        SCOPED_TRACE(std::string(family.name));
        const Scene2 scene = small_scene(family);
        for (const bool tangent_only : {false, true}) {
            const VisibilityGraph expected =
                visibility_graph(scene, {.tangent_only = tangent_only});
            for (const Arithmetic arithmetic : all_arithmetics) {
                Tally tally;
                const VisibilityGraphOptions options{
                    .tangent_only = tangent_only, .arithmetic = arithmetic, .tally = &tally};
                const VisibilityGraph graph = visibility_graph(scene, options);
                expect_sums(tally);
                const TierCounts& counts = tally[Predicate::orientation2];
                if (arithmetic == Arithmetic::filtered) {
                    EXPECT_EQ(counts.undecided, 0U);
                }
                if (arithmetic != Arithmetic::exact) continue;
                EXPECT_EQ(graph, expected);
                EXPECT_EQ(counts.filter + counts.interval + counts.undecided, 0U);
            }
        }
    }
}

TEST(ArithmeticLaws, ViewsEndAndTheirTalliesAddUp) {
    for (const families::FamilyInfo& family : families::all2()) {
        SCOPED_TRACE(std::string(family.name));
        const Scene2 scene = small_scene(family);
        const PointVisibility2 visibility(scene);
        for (std::size_t v = 0; v < scene.vertex_count(); v += 7) {
            const RationalPoint2 p = to_rational(scene.vertices()[v]);
            for (const Rational& step : {Rational(0), Rational(1, 3)}) {
                const RationalPoint2 q{p.x + step, p.y + step * step};
                for (const Arithmetic arithmetic : all_arithmetics) {
                    Tally tally;
                    const auto view = visibility.from(q, {.needles = Needles::with_needles,
                                                          .arithmetic = arithmetic,
                                                          .tally = &tally});
                    expect_sums(tally);
                    if (!view) break;  // inside of a body
                    if (arithmetic == Arithmetic::interval || arithmetic == Arithmetic::double_)
                        continue;
                    EXPECT_EQ(tally[Predicate::orientation2].undecided, 0U);
                }
            }
        }
    }
}

TEST(ArithmeticLaws, ExactPointsAreTheVerticesOfTheRing) {
    for (const families::FamilyInfo& family : families::all2()) {
        SCOPED_TRACE(std::string(family.name));
        const Scene2 scene = small_scene(family);
        const PointVisibility2 visibility(scene);
        for (std::size_t v = 0; v < scene.vertex_count(); v += 5) {
            const RationalPoint2 p = to_rational(scene.vertices()[v]);
            for (const Rational& step : {Rational(0), Rational(1, 4), Rational(1, 3)}) {
                const auto view = visibility.from(RationalPoint2{p.x + step, p.y - step});
                if (!view) continue;
                const ExactPoints points = visibility.exact_points(*view);
                ASSERT_EQ(points.size(), view->ring.size());
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const ViewPoint expected = exact_point(scene, view->from, view->ring[i]);
                    ASSERT_EQ(points[i].at_infinity, expected.at_infinity);
                    if (expected.at_infinity) continue;
                    ASSERT_EQ(points[i], expected);
                }
            }
        }
    }
}

// Intervals settle what the filter, which sees rounded coordinates, does not.
TEST(ArithmeticLaws, RationalViewpointsSeldomNeedExactNumbers) {
    const Scene2 scene = Scene2::make(families::random_convex({.vertices = 300}, 4)).value();
    const PointVisibility2 visibility(scene);
    Tally tally;
    for (std::size_t v = 0; v < scene.vertex_count(); v += 3) {
        const RationalPoint2 p = to_rational(scene.vertices()[v]);
        static_cast<void>(visibility.from(
            RationalPoint2{p.x + Rational(1, 3), p.y - Rational(1, 7)}, {.tally = &tally}));
    }
    for (const Predicate predicate : {Predicate::orientation2, Predicate::point_location2}) {
        const TierCounts& counts = tally[predicate];
        EXPECT_GT(counts.filter, 1000U);
        EXPECT_EQ(counts.exact, 0U);
    }
}

TEST(ArithmeticLaws, GraphsAreRightForCoordinatesOfAllSizes) {
    const std::pair<int, int> ranges[] = {{-1074, 1019}, {-1074, -1000}, {900, 1019}, {-600, -400},
                                          {-60, 60},     {-340, 340},    {480, 530},  {-540, -480}};
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const auto [least, greatest] = ranges[seed % std::size(ranges)];
        const SceneInput2 input = testing::scene_of_all_sizes(seed, least, greatest, 7);
        SCOPED_TRACE(testing::to_text(input));
        const Scene2 scene = Scene2::make(input).value();
        for (const Collinear collinear : {Collinear::nearest_only, Collinear::every_vertex}) {
            const VisibilityGraphOptions options{.collinear = collinear};
            ASSERT_EQ(visibility_graph(scene, options),
                      reference::visibility_graph(scene, options));
        }
    }
}

Limits at_most(std::size_t elements) {
    Limits limits;
    limits.max_elements = elements;
    return limits;
}

TEST(ArithmeticLaws, LimitsAreKept) {
    const Scene2 scene = Scene2::make(families::random_convex({.vertices = 500}, 2)).value();
    const std::size_t edges = visibility_graph(scene).edge_count();
    for (const unsigned threads : {1U, 2U}) {
        const VisibilityGraphOptions options{.threads = threads};
        EXPECT_TRUE(visibility_graph(scene, options, at_most(edges)));
        const auto refused = visibility_graph(scene, options, at_most(edges - 1));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, Errc::limit_reached);
        int asked = 0;
        Limits impatient;
        impatient.stop = [&] { return ++asked == 2; };
        const auto stopped = visibility_graph(scene, options, impatient);
        ASSERT_FALSE(stopped);
        EXPECT_EQ(stopped.error().code, Errc::cancelled);
        EXPECT_EQ(asked, 2) << "nothing is asked or done after the end";
        double done = 0;
        Limits watched;
        watched.progress = [&](double share) { done = std::max(done, share); };
        ASSERT_TRUE(visibility_graph(scene, options, watched));
        EXPECT_EQ(done, 1.0);
    }
}

}  // namespace
}  // namespace sightline
