// SPDX-License-Identifier: GPL-3.0-or-later
// Each test states the rule that decides its case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sightline/event/bitangents.hpp"
#include "sightline/planar/free_bitangents.hpp"
#include "support/bitangents.hpp"
#include "support/corpus.hpp"

namespace sightline {
namespace {

using testing::scene2;

std::string free_between(const std::string& scene) {
    return testing::to_string(free_bitangents(scene2(scene), {.one_body = false}));
}

TEST(FreeBitangents, ThirdBodiesBlockThem) {
    const std::string pair = "0 0, 2 0, 1 2 | 5 1, 8 1, 6 4";
    EXPECT_EQ(free_between(pair), "LL v1 v4 b0 b1; LR v1 v5 b0 b1; RL v2 v3 b0 b1; RR v2 v5 b0 b1");
    // A needle across two of them.
    const Scene2 blocked = scene2(pair + " | 4 0, 4.1 0, 4 2");
    const auto free = free_bitangents(blocked, {.one_body = false});
    EXPECT_EQ(bitangents(blocked).size(), 24U);
    EXPECT_LT(free.size(), 24U);
    const Bitangent crossing{{0}, {1}, Side::right, Side::left, {2}, {3}};
    EXPECT_THAT(bitangents(blocked), ::testing::Contains(crossing));
    EXPECT_THAT(free, ::testing::Not(::testing::Contains(crossing)));
}

TEST(FreeBitangents, OfOneBodyAreItsConvexEdgesAndTheLidsOfItsBays) {
    EXPECT_EQ(testing::to_string(free_bitangents(scene2("0 0, 4 0, 4 4, 2 1, 0 4"))),
              "LL v0 v1 b0 b0; RR v0 v4 b0 b0; LL v1 v2 b0 b0; LL v2 v4 b0 b0");
}

TEST(FreeBitangents, OnOneLineReachTheNearestVertexWhateverItBelongsTo) {
    const auto on_the_line = [](const std::string& scene) {
        std::string found;
        for (const Bitangent& b : free_bitangents(scene2(scene), {.one_body = false})) {
            if (b.is_canonical() && b.type() == "LL") found += to_string(b) + "; ";
        }
        return found;
    };
    EXPECT_EQ(on_the_line("0 0, 1 0, 0 1 | 3 0, 4 0, 4 1 | 6 0, 7 0, 7 1"),
              "LL v1 v3 b0 b1; LL v4 v6 b1 b2; ");
}

TEST(FreeBitangents, LeadThroughPinholes) {
    const Scene2 scene = testing::degenerate_scene("pinhole");
    const auto all = free_bitangents(scene, {.one_body = false});
    // The tips v1 and v5 lie at the origin, one above and one below the line between the points v6, v7.
    const auto has = [&](const Bitangent& b) {
        return std::binary_search(all.begin(), all.end(), b);
    };
    EXPECT_TRUE(has({{0}, {}, Side::left, Side::on, {1}, {7}}));
    EXPECT_TRUE(has({{1}, {}, Side::right, Side::on, {5}, {7}}));
    EXPECT_TRUE(has({{}, {1}, Side::on, Side::right, {6}, {5}}));
    EXPECT_FALSE(has({{}, {}, Side::on, Side::on, {6}, {7}})) << "the tips lie between";
}

TEST(FreeBitangents, AreTheSameFromTheTangentGraph) {
    const Scene2 scene = scene2("0 0, 2 0, 1 2 | 5 1, 8 1, 6 4 | 4 0, 4.1 0, 4 2");
    const auto graph = visibility_graph(scene, {.tangent_only = true});
    const auto all = free_bitangents(scene, graph);
    EXPECT_EQ(all.size(), 2 * graph.edge_count());
    EXPECT_EQ(all, free_bitangents(scene));
    EXPECT_THROW((void)free_bitangents(scene, VisibilityGraph{}), ContractViolation);
}

TEST(FreeBitangents, StopAtTheLimit) {
    const Scene2 scene = scene2("0 0, 2 0, 1 2 | 5 1, 8 1, 6 4");
    Limits limits;
    limits.max_elements = 3;
    const auto stopped = free_bitangents(scene, {}, limits);
    ASSERT_FALSE(stopped.has_value());
    EXPECT_EQ(stopped.error().code, Errc::limit_reached);
}

}  // namespace
}  // namespace sightline
