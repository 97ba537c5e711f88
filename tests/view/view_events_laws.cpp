// SPDX-License-Identifier: GPL-3.0-or-later
// Between two events all views are equal; across an event, or at it, they differ.
#include "sightline/view/view_events.hpp"

#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

void expect_events(const Scene3& scene, const RationalPoint3& a, const RationalPoint3& b,
                   std::size_t& events) {
    const PointVisibility3 visibility(scene);
    const auto change = view_change(visibility, a, b);
    if (!change) {
        EXPECT_EQ(change.error().code, Errc::inside_body) << change.error().message;
        return;
    }
    ASSERT_EQ(change->views.size(), change->events.size() + 1);
    events += change->events.size();
    for (std::size_t i = 0; i < change->events.size(); ++i) {
        const bool differ = !(change->views[i].map == change->views[i + 1].map);
        EXPECT_NE(differ, change->events[i].only_there);
        EXPECT_FALSE(change->events[i].causes.empty());
    }
    // Samples that the algorithm did not choose.
    constexpr int samples = 61;
    for (int k = 1; k < samples; ++k) {
        const Rational t = Rational(k) / samples;
        std::size_t i = 0;
        while (i < change->events.size() && change->events[i].at < Surd(t)) ++i;
        if (i < change->events.size() && change->events[i].at == Surd(t)) continue;
        const auto view = visibility.from(a + t * (b - a));
        ASSERT_TRUE(view.has_value());
        EXPECT_EQ(view->map, change->views[i].map) << "at " << t;
    }
}

TEST(ViewEventsLaw, ViewsAreEqualBetweenEventsOfRandomScenes) {
    std::size_t events = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        const Scene3 scene = scene3(random_scene3(seed));
        if (scene.edges().size() > 30) continue;
        SCOPED_TRACE(seed);
        std::mt19937_64 bits(seed);
        const auto coordinate = [&] { return Rational(static_cast<int>(bits() % 31) - 12) / 3; };
        const RationalPoint3 a{coordinate(), coordinate(), Rational(-9) / 2};
        const RationalPoint3 b{coordinate(), coordinate() - 8, Rational(15) / 2};
        expect_events(scene, a, b, events);
        if (HasFailure()) return;
    }
    EXPECT_GT(events, 50U);
}

TEST(ViewEvents, PassingACubeFacesAppearAndDisappear) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    const PointVisibility3 visibility(cube);
    const auto change = view_change(visibility, {-3, -1, 1}, {5, -1, 1});
    ASSERT_TRUE(change.has_value());
    // The planes of the two sides; at the middle nothing of one cube changes.
    ASSERT_EQ(change->events.size(), 2U);
    EXPECT_EQ(change->events[0].at, Surd(Rational(3) / 8));
    EXPECT_EQ(change->events[1].at, Surd(Rational(5) / 8));
    EXPECT_EQ(change->views[0].visible_faces().size(), 2U);
    EXPECT_EQ(change->views[1].visible_faces().size(), 1U);
}

TEST(ViewEvents, ThreeEdgesMeetAtAnIrrationalPlace) {
    // Three skew needles: their edges' images meet where the viewpoint crosses quadrics.
    const Scene3 scene = scene3(
        "hull -9 4 0, 9 4 1, 0 4 0, 0 5 0; hull 0 8 -9, 1 8 9, 0 8 0, 0 9 0; "
        "hull -7 12 -9, 8 13 9, 0 12 1, 0 14 0");
    const PointVisibility3 visibility(scene);
    const auto change = view_change(visibility, {-4, -5, -3}, {3, -6, 4});
    ASSERT_TRUE(change.has_value()) << change.error().message;
    const auto irrational = std::count_if(change->events.begin(), change->events.end(),
                                          [](const ViewEvent& e) { return !e.at.is_rational(); });
    EXPECT_GT(irrational, 0);
    for (const ViewEvent& e : change->events) {
        if (e.at.is_rational()) continue;
        EXPECT_EQ(e.causes.front().kind, ViewEventCause::Kind::three_edges);
    }
}

TEST(ViewEvents, ASegmentThroughABodyHasNoViews) {
    const Scene3 cube = scene3("box 0 0 0, 2 2 2");
    const auto change = view_change(PointVisibility3(cube), {-3, 1, 1}, {5, 1, 1});
    ASSERT_FALSE(change.has_value());
    EXPECT_EQ(change.error().code, Errc::inside_body);
}

}  // namespace
}  // namespace sightline::testing
