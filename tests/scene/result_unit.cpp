// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace sightline {
namespace {

TEST(Errc, EveryCodeHasItsOwnName) {
    std::set<std::string> names;
    const int count = static_cast<int>(Errc::bad_parameter) + 1;
    for (int i = 0; i < count; ++i) names.insert(name_of(static_cast<Errc>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
    EXPECT_FALSE(names.contains("unknown"));
    EXPECT_STREQ(name_of(Errc::repeated_vertex), "repeated_vertex");
}

TEST(Contract, AViolationNamesItsConditionAndPlace) {
    const int sides = 2;
    SIGHTLINE_EXPECT(sides == 2);
    try {
        SIGHTLINE_EXPECT(sides > 2);
        FAIL() << "not thrown";
    } catch (const ContractViolation& violation) {
        EXPECT_THAT(violation.what(), testing::HasSubstr("sides > 2"));
        EXPECT_THAT(violation.what(), testing::HasSubstr("result_unit.cpp:"));
    }
}

TEST(Result, HoldsAValueOrAnError) {
    const Result<int> good = 3;
    const Result<int> bad = fail(Errc::spike, "body 0: vertex 2 is a spike; remove it");
    EXPECT_EQ(good, 3);
    ASSERT_FALSE(bad.has_value());
    EXPECT_EQ(bad.error(), (Error{Errc::spike, "body 0: vertex 2 is a spike; remove it"}));
}

}  // namespace
}  // namespace sightline
