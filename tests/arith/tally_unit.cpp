// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/tally.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace sightline {
namespace {

TEST(Tally, CountsEachCallUnderItsTier) {
    Tally tally;
    tally.add(Predicate::orientation2, Tier::filter);
    tally.add(Predicate::orientation2, Tier::filter);
    tally.add(Predicate::orientation2, Tier::interval);
    tally.add(Predicate::orientation2, Tier::exact);
    tally.add(Predicate::constructed_order2, Tier::undecided);
    EXPECT_EQ(tally[Predicate::orientation2],
              (TierCounts{.calls = 4, .filter = 2, .interval = 1, .exact = 1}));
    EXPECT_EQ(tally[Predicate::constructed_order2], (TierCounts{.calls = 1, .undecided = 1}));
    EXPECT_EQ(tally[Predicate::order_along_line2], TierCounts{});
}

TEST(Tally, SumsAreSumsOfEveryCount) {
    Tally a;
    a.add(Predicate::orientation2, Tier::exact);
    Tally b;
    b.add(Predicate::orientation2, Tier::filter);
    b.add(Predicate::point_location2, Tier::interval);
    b.add(Predicate::point_location2, Tier::undecided);
    a += b;
    EXPECT_EQ(a[Predicate::orientation2], (TierCounts{.calls = 2, .filter = 1, .exact = 1}));
    EXPECT_EQ(a[Predicate::point_location2],
              (TierCounts{.calls = 2, .interval = 1, .undecided = 1}));
}

TEST(Tally, EveryPredicateHasItsOwnName) {
    std::set<std::string_view> names;
    for (int i = 0; i < static_cast<int>(Predicate::count_); ++i) {
        names.insert(name_of(static_cast<Predicate>(i)));
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(Predicate::count_));
    EXPECT_FALSE(names.contains("unknown"));
    EXPECT_TRUE(names.contains("orientation2"));
}

}  // namespace
}  // namespace sightline
