// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of bitangents in tests: shown, renamed, compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sightline/event/bitangent.hpp"

namespace sightline::testing {

using BitangentList = std::vector<Bitangent>;

/// "LL v1 v3 b0 b1; …", in one direction only.
inline std::string to_string(const BitangentList& list) {
    std::string text;
    for (const Bitangent& b : list) {
        if (!b.is_canonical()) continue;
        if (!text.empty()) text += "; ";
        text += sightline::to_string(b);
    }
    return text;
}

/// Whether the lists are equal; if not, how they differ.
inline ::testing::AssertionResult same_bitangents(const BitangentList& actual,
                                                  const BitangentList& expected) {
    if (actual == expected) return ::testing::AssertionSuccess();
    const auto without = [](const BitangentList& a, const BitangentList& b) {
        std::string text;
        for (const Bitangent& x : a) {
            if (std::find(b.begin(), b.end(), x) == b.end()) text += sightline::to_string(x) + "; ";
        }
        return text;
    };
    return ::testing::AssertionFailure()
           << "missing: " << without(expected, actual) << "\nfalse: " << without(actual, expected)
           << "\nactual has " << actual.size() << ", expected " << expected.size();
}

/// Every bitangent exactly once, ascending, and its reversed one with it.
inline void expect_both_directions(const BitangentList& list) {
    for (std::size_t i = 1; i < list.size(); ++i) EXPECT_LT(list[i - 1], list[i]);
    for (const Bitangent& b : list)
        EXPECT_TRUE(std::binary_search(list.begin(), list.end(), reversed(b))) << b;
}

/// With left and right exchanged.
inline BitangentList mirrored(BitangentList list) {
    for (Bitangent& b : list) {
        b.source_side = reversed(b.source_side);
        b.target_side = reversed(b.target_side);
    }
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace sightline::testing
