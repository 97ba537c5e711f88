// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/trails.hpp"

#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace sightline::viz::detail {
namespace {

GridSegment ordered(GridSegment s) {
    return s.second < s.first ? GridSegment{s.second, s.first} : s;
}

std::vector<GridSegment> some_segments() {
    const auto coordinate = rc::gen::inRange<std::int32_t>(0, 4);
    const auto point =
        rc::gen::apply([](int x, int y) { return GridPoint{x, y}; }, coordinate, coordinate);
    return *rc::gen::container<std::vector<GridSegment>>(rc::gen::pair(point, point));
}

RC_GTEST_PROP(TrailsLaw, EachDistinctSegmentIsDrawnOnce, ()) {
    const std::vector<GridSegment> segments = some_segments();
    std::set<GridSegment> wanted;
    for (const GridSegment& s : segments) wanted.insert(ordered(s));
    std::set<GridSegment> drawn;
    for (const auto& chain : trails(segments)) {
        RC_ASSERT(chain.size() >= 2u);
        for (std::size_t i = 1; i < chain.size(); ++i) {
            RC_ASSERT(drawn.insert(ordered({chain[i - 1], chain[i]})).second);
        }
    }
    RC_ASSERT(drawn == wanted);
}

RC_GTEST_PROP(TrailsLaw, OrderAndDirectionOfTheInputDoNotMatter, ()) {
    const std::vector<GridSegment> segments = some_segments();
    std::vector<GridSegment> turned(segments.rbegin(), segments.rend());
    for (auto& [a, b] : turned) std::swap(a, b);
    RC_ASSERT(trails(turned) == trails(segments));
}

TEST(Trails, ChainOfSegmentsBecomesOneTrail) {
    const auto chains = trails({{{0, 0}, {1, 0}}, {{2, 0}, {1, 0}}, {{2, 0}, {3, 5}}});
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0], (std::vector<GridPoint>{{0, 0}, {1, 0}, {2, 0}, {3, 5}}));
}

}  // namespace
}  // namespace sightline::viz::detail
