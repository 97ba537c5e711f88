// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/bitangent.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <unordered_set>

#include "sightline/event/bitangents.hpp"
#include "support/bitangents.hpp"
#include "support/scenes.hpp"

namespace sightline {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using testing::scene2;

constexpr Side all_sides[] = {Side::left, Side::right, Side::on, Side::both};

std::vector<Bitangent> every_kind() {
    std::vector<Bitangent> all;
    for (const Side s : all_sides) {
        for (const Side t : all_sides) {
            all.push_back({{0}, {1}, s, t, {3}, {7}});
            all.push_back({BodyId::none(), {1}, s, t, {7}, {3}});
        }
    }
    return all;
}

TEST(Bitangent, ReversingTwiceGivesItBack) {
    for (const Bitangent& b : every_kind()) {
        EXPECT_EQ(reversed(reversed(b)), b);
        EXPECT_NE(reversed(b), b);
        EXPECT_EQ(reversed(b).separates(), b.separates());
        EXPECT_EQ(reversed(b).is_outer(), b.is_outer());
    }
}

TEST(Bitangent, ReversingExchangesLLWithRRAndKeepsLR) {
    const Bitangent ll{{0}, {1}, Side::left, Side::left, {1}, {3}};
    const Bitangent lr{{0}, {1}, Side::left, Side::right, {1}, {3}};
    EXPECT_EQ(reversed(ll).type(), "RR");
    EXPECT_EQ(reversed(lr).type(), "LR");
    EXPECT_TRUE(lr.separates());
    EXPECT_FALSE(lr.is_outer());
    EXPECT_TRUE(ll.is_outer());
    EXPECT_FALSE(ll.separates());
}

TEST(Bitangent, ContactsWithoutASideAreNeitherInnerNorOuter) {
    const Bitangent b{{0}, BodyId::none(), Side::left, Side::on, {1}, {3}};
    EXPECT_FALSE(b.separates());
    EXPECT_FALSE(b.is_outer());
    EXPECT_EQ(reversed(b).type(), "OR");
}

TEST(Bitangent, OneDirectionIsCanonical) {
    for (const Bitangent& b : every_kind()) {
        EXPECT_NE(b.is_canonical(), reversed(b).is_canonical());
        EXPECT_TRUE(canonical(b).is_canonical());
        EXPECT_EQ(canonical(b), canonical(reversed(b)));
    }
}

TEST(Bitangent, IsReadBackFromItsText) {
    for (const Bitangent& b : every_kind()) {
        std::ostringstream out;
        out << b;
        const auto read = bitangent_from_text(out.str());
        ASSERT_TRUE(read.has_value()) << out.str();
        EXPECT_EQ(*read, b);
    }
    EXPECT_EQ(to_string(Bitangent{{0}, {}, Side::left, Side::on, {1}, {3}}), "LO v1 v3 b0 b-");
}

TEST(Bitangent, OtherTextIsRefused) {
    for (const char* text :
         {"", "LL", "LX v1 v3 b0 b1", "LL v1 v3 b0", "LL v1 v3 b0 b1 ", "LL v1 w3 b0 b1",
          "LL v1 v3 b b1", "LL v-1 v3 b0 b1", "LL v99999999999 v3 b0 b1", "LL v1  v3 b0 b1"}) {
        const auto read = bitangent_from_text(text);
        ASSERT_FALSE(read.has_value()) << text;
        EXPECT_EQ(read.error().code, Errc::syntax);
        EXPECT_THAT(read.error().message, ::testing::HasSubstr("LR v1 v3 b0 b1"));
    }
}

TEST(Bitangent, IsOrderedByItsContactsFirst) {
    const Bitangent a{{5}, {6}, Side::right, Side::right, {1}, {2}};
    const Bitangent b{{0}, {0}, Side::left, Side::left, {1}, {3}};
    const Bitangent c{{0}, {0}, Side::left, Side::right, {1}, {3}};
    EXPECT_LT(a, b);
    EXPECT_LT(b, c);
}

TEST(Bitangent, EqualOnesHaveEqualHashesAndTypesDifferentOnes) {
    std::unordered_set<Bitangent> set;
    for (const Bitangent& b : every_kind()) set.insert(b);
    for (const Bitangent& b : every_kind()) set.insert(b);
    EXPECT_EQ(set.size(), every_kind().size());
    std::unordered_set<std::size_t> hashes;
    for (const Bitangent& b : set) hashes.insert(std::hash<Bitangent>{}(b));
    EXPECT_EQ(hashes.size(), set.size());
}

TEST(Bitangents, TwoDisjointTrianglesHaveFour) {
    const Scene2 scene = scene2("0 0, 2 0, 1 2 | 5 1, 8 1, 6 4");
    const auto all = bitangents(scene);
    EXPECT_EQ(all.size(), 8U) << "four lines, each in two directions";
    EXPECT_EQ(std::ranges::count_if(all, &Bitangent::separates), 4);
    EXPECT_EQ(std::ranges::count_if(all, &Bitangent::is_outer), 4);
    testing::expect_both_directions(all);
    EXPECT_EQ(testing::to_string(all),
              "LL v1 v4 b0 b1; LR v1 v5 b0 b1; RL v2 v3 b0 b1; RR v2 v5 b0 b1");
}

TEST(Bitangents, OfOneBodyAreListedOnRequest) {
    const Scene2 scene = scene2("0 0, 4 0, 4 4, 2 1, 0 4");
    EXPECT_TRUE(bitangents(scene).empty());
    // The four edges between convex corners are three: the bay's edges end at its reflex corner.
    EXPECT_EQ(testing::to_string(bitangents(scene, {.one_body = true})),
              "LL v0 v1 b0 b0; RR v0 v4 b0 b0; LL v1 v2 b0 b0; LL v2 v4 b0 b0");
    EXPECT_EQ(bitangents(scene, BodyId{0}, BodyId{0}), bitangents(scene, {.one_body = true}));
}

TEST(Bitangents, OfTwoBodiesAreThoseOfTheScene) {
    const Scene2 scene = scene2("0 0, 2 0, 1 2 | 5 1, 8 1, 6 4 | -3 -3, -2 -5, -1 -3");
    const auto all = bitangents(scene);
    EXPECT_EQ(all.size(), 24U);
    std::vector<Bitangent> collected;
    for (const auto& [a, b] : {std::pair{0U, 1U}, std::pair{2U, 0U}, std::pair{1U, 2U}}) {
        const auto some = bitangents(scene, BodyId{a}, BodyId{b});
        EXPECT_EQ(some.size(), 8U);
        EXPECT_EQ(some, bitangents(scene, BodyId{b}, BodyId{a}));
        collected.insert(collected.end(), some.begin(), some.end());
    }
    std::sort(collected.begin(), collected.end());
    EXPECT_EQ(collected, all);
}

TEST(Bitangents, OfABodyThatIsNotThereBreakTheContract) {
    const Scene2 scene = scene2("0 0, 2 0, 1 2");
    EXPECT_THROW((void)bitangents(scene, BodyId{0}, BodyId{1}), ContractViolation);
    EXPECT_THROW((void)bitangents(scene, BodyId::none(), BodyId{0}), ContractViolation);
    EXPECT_THROW((void)supporting_lines(scene, BodyId{1}, {0, 0}), ContractViolation);
}

TEST(Bitangents, StopAtTheLimit) {
    const auto at_most = [](std::size_t n) {
        Limits limits;
        limits.max_elements = n;
        return limits;
    };
    const Scene2 scene = scene2("0 0, 2 0, 1 2 | 5 1, 8 1, 6 4");
    const auto stopped = bitangents(scene, {}, at_most(7));
    ASSERT_FALSE(stopped.has_value());
    EXPECT_EQ(stopped.error().code, Errc::limit_reached);
    const auto done = bitangents(scene, {}, at_most(8));
    ASSERT_TRUE(done.has_value());
    EXPECT_EQ(*done, bitangents(scene));
}

TEST(Bitangents, StopWhenAsked) {
    SceneInput2 input;
    for (int i = 0; i < 60; ++i) {
        const double x = 3 * i;
        input.elements.emplace_back(Polygon2{{{x, 0}, {x + 1, 0}, {x, 1}}, {}});
    }
    double progress = 0;
    Limits limits;
    limits.stop = [&] { return progress > 0; };
    limits.progress = [&](double done) { progress = done; };
    const auto stopped = bitangents(*Scene2::make(input), {}, limits);
    ASSERT_FALSE(stopped.has_value());
    EXPECT_EQ(stopped.error().code, Errc::cancelled);
    EXPECT_GT(progress, 0);
    EXPECT_LE(progress, 1);
}

TEST(SupportingLines, OfAConvexBodyAreTwo) {
    const Scene2 scene = scene2("0 0, 4 0, 4 2, 0 2");
    EXPECT_THAT(supporting_lines(scene, {0}, {-2, 1}),
                ElementsAre(SupportingLine2{{0}, {0}, Side::left, {-2, 1}},
                            SupportingLine2{{3}, {0}, Side::right, {-2, 1}}));
    EXPECT_TRUE(supporting_lines(scene, {0}, {1, 1}).empty()) << "from its inside";
}

TEST(SupportingLines, AlongAnEdgeTouchTheNearestVertex) {
    const Scene2 scene = scene2("0 0, 4 0, 4 2, 0 2");
    EXPECT_THAT(supporting_lines(scene, {0}, {-2, 0}),
                ElementsAre(SupportingLine2{{0}, {0}, Side::left, {-2, 0}},
                            SupportingLine2{{3}, {0}, Side::right, {-2, 0}}));
    EXPECT_THAT(supporting_lines(scene, {0}, {6, 0}),
                ElementsAre(SupportingLine2{{1}, {0}, Side::right, {6, 0}},
                            SupportingLine2{{2}, {0}, Side::left, {6, 0}}));
}

TEST(SupportingLines, FromACornerRunAlongItsEdges) {
    const Scene2 scene = scene2("0 0, 4 0, 4 2, 0 2");
    EXPECT_THAT(supporting_lines(scene, {0}, {0, 0}),
                ElementsAre(SupportingLine2{{1}, {0}, Side::left, {0, 0}},
                            SupportingLine2{{3}, {0}, Side::right, {0, 0}}));
}

TEST(SupportingLines, FromBetweenTwoCornersGoBothWays) {
    const Scene2 scene = scene2("0 0, 4 0, 4 2, 0 2");
    EXPECT_THAT(supporting_lines(scene, {0}, {2, 0}),
                ElementsAre(SupportingLine2{{0}, {0}, Side::right, {2, 0}},
                            SupportingLine2{{1}, {0}, Side::left, {2, 0}}));
}

TEST(SupportingLines, AreReadBackFromTheirText) {
    for (const Side side : all_sides) {
        const SupportingLine2 line{{12}, {4}, side, {0.1, -1e300}};
        const auto read = supporting_line_from_text(to_string(line));
        ASSERT_TRUE(read.has_value()) << to_string(line);
        EXPECT_EQ(*read, line);
    }
    EXPECT_EQ(to_string(SupportingLine2{{3}, {0}, Side::left, {1, 2.5}}), "L v3 b0 (1, 2.5)");
    EXPECT_FALSE(supporting_line_from_text("L v3 b0 (1, )").has_value());
    EXPECT_FALSE(supporting_line_from_text("L v3 b0 (1, 2").has_value());
}

TEST(SupportingLines, WithEqualPointsHaveEqualHashes) {
    const std::hash<SupportingLine2> hash;
    const SupportingLine2 a{{1}, {0}, Side::left, {0.0, 1}};
    const SupportingLine2 b{{1}, {0}, Side::left, {-0.0, 1}};
    EXPECT_EQ(a, b);
    EXPECT_EQ(hash(a), hash(b));
    EXPECT_NE(hash(a), hash({{1}, {0}, Side::right, {0.0, 1}}));
}

}  // namespace
}  // namespace sightline
