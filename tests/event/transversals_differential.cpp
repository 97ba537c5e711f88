// SPDX-License-Identifier: GPL-3.0-or-later
// Transversals against the obvious search, on grids so small that most cases are degenerate.
#include "sightline/event/transversals.hpp"

#include <gtest/gtest.h>

#include <map>

#include "sightline/reference/transversals.hpp"
#include "support/transversals.hpp"

namespace sightline {
namespace {

using testing::ElementLottery;
using testing::Elements;

// How often each kind of result came up, so that none is missed by all.
struct Coverage {
    std::map<std::string, int> counts;

    void add(const Transversals& t) {
        counts["lines " + std::to_string(t.lines.size())] += 1;
        for (const auto& c : t.components) counts[name_of(c.kind)] += 1;
        if (t.components.size() > 1) counts["several components"] += 1;
        if (!t.components.empty() && !t.lines.empty()) counts["both"] += 1;
    }
};

void compare(int seeds, int grid, int kinds, int count, Coverage& coverage) {
    for (int seed = 0; seed < seeds; ++seed) {
        ElementLottery lottery(static_cast<std::uint64_t>(seed) * 100 + grid * 10 + kinds, grid,
                               kinds);
        const Elements four = lottery.draw(count);
        const Transversals actual = transversals(four);
        ASSERT_TRUE(testing::same_transversals(actual, reference::transversals(four)))
            << "seed " << seed << ": " << testing::to_string(four);
        coverage.add(actual);
    }
}

TEST(TransversalsDifferential, SegmentsOnSmallGrids) {
    Coverage coverage;
    compare(400, 2, 1, 4, coverage);
    compare(400, 3, 1, 4, coverage);
    compare(200, 5, 1, 4, coverage);
    for (const char* kind : {"pencil", "plane", "bundle", "lines 0", "lines 1", "lines 2", "both",
                             "several components"}) {
        EXPECT_GT(coverage.counts[kind], 0) << kind;
    }
}

TEST(TransversalsDifferential, MixturesWithPointsAndLines) {
    Coverage coverage;
    compare(400, 2, 3, 4, coverage);
    compare(300, 3, 3, 4, coverage);
    for (const char* kind : {"pencil", "plane", "bundle"}) EXPECT_GT(coverage.counts[kind], 0);
}

TEST(TransversalsDifferential, LinesOfOneRegulus) {
    Coverage coverage;
    for (int seed = 0; seed < 500; ++seed) {
        ElementLottery lottery(static_cast<std::uint64_t>(seed), 3 + seed % 4, 1 + seed % 2);
        const Elements four = lottery.draw_on_paraboloid();
        const Transversals actual = transversals(four);
        ASSERT_TRUE(testing::same_transversals(actual, reference::transversals(four)))
            << "seed " << seed << ": " << testing::to_string(four);
        coverage.add(actual);
    }
    for (const char* kind : {"regulus", "lines 1", "congruence"}) {
        EXPECT_GT(coverage.counts[kind], 0) << kind;
    }
}

// Where whole lines leave out a line, several ranges may begin at it.
TEST(TransversalsDifferential, RangesThatBeginAtOneMissingLine) {
    for (const char* text : {"segment 1 2 1, 1 2 3 | line 2 2 0, 3 0 1 | line 2 0 3, 0 1 3",
                             "line 1 1 1, 0 0 3 | line 2 0 0, 2 2 1 | segment 3 2 2, 0 2 0",
                             "segment 2 1 2, 0 2 0 | segment 2 1 2, 1 0 1 | segment 1 2 2, 2 2 0 | "
                             "line 1 2 1, 2 0 2",
                             "line 2 1 2, 1 0 2 | line 2 2 2, 3 1 3 | segment 1 3 2, 3 2 1"}) {
        const Elements all = testing::elements(text);
        const Transversals actual = transversals(all);
        EXPECT_TRUE(testing::same_transversals(actual, reference::transversals(all))) << text;
        ASSERT_EQ(actual.components.size(), 1u);
        EXPECT_GT(actual.components[0].ranges.size(), 1u);
    }
}

// Found by long runs: an isolated line in the middle of what might be a range, and planes whose
// corners are parallel to a line element.
TEST(TransversalsDifferential, ASampleOfAFamilyIsNotYetAFamily) {
    for (const char* text : {"segment 0 0 2, 1 1 0 | segment 1 0 0, 0 1 1 | segment 1 3 1, 3 1 3 | "
                             "segment 3 0 2, 0 3 1",
                             "segment 0 1 0, 1 1 1 | line 0 1 0, 0 0 0 | segment 1 0 1, 1 1 1",
                             "line 1 2 2, 1 2 1 | segment 1 0 2, 1 1 1 | segment 1 0 0, 1 1 1",
                             "segment 0 1 1, 2 1 2 | segment 0 1 0, 1 1 1 | segment 1 1 0, 2 1 1 | "
                             "line 2 1 0, 0 1 0"}) {
        const Elements all = testing::elements(text);
        EXPECT_TRUE(testing::same_transversals(transversals(all), reference::transversals(all)))
            << text;
    }
}

TEST(TransversalsDifferential, FewerElements) {
    Coverage coverage;
    for (int count = 1; count <= 3; ++count) {
        compare(150, 2, 3, count, coverage);
        compare(100, 3, 1, count, coverage);
    }
    for (const char* kind : {"regulus", "plane", "bundle", "congruence", "segment"}) {
        EXPECT_GT(coverage.counts[kind], 0) << kind;
    }
}

}  // namespace
}  // namespace sightline
