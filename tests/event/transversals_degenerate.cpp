// SPDX-License-Identifier: GPL-3.0-or-later
// Each rule of sightline/event/transversals.hpp on degenerate elements, by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sightline/event/transversals.hpp"
#include "support/transversals.hpp"

namespace sightline {
namespace {

using testing::elements;
using Family = TransversalComponent::Kind;

Transversals of(const std::string& text) { return transversals(elements(text)); }

RationalLine3 line(const std::string& text) {
    return scaled(elements("line " + text)[0].carrier());
}

std::vector<Family> kinds(const Transversals& t) {
    std::vector<Family> result;
    for (const auto& c : t.components) result.push_back(c.kind);
    return result;
}

using testing::elements;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Transversals, FourSkewLinesHaveTwoThatAreConjugate) {
    const auto four =
        elements("line 0 0 0, 1 0 0 | line 0 0 2, 0 1 2 | line 1 2 0, 2 3 1 | line 2 1 0, 3 1 3");
    const Transversals t = transversals(four);
    ASSERT_EQ(t.lines.size(), 2u);
    EXPECT_THAT(t.components, IsEmpty());
    EXPECT_LT(t.lines[0].line, t.lines[1].line);
    EXPECT_EQ(t.lines[0].root, 0);
    EXPECT_EQ(t.lines[1].root, 1);
    const auto first = t.lines[0].line.coordinates(), second = t.lines[1].line.coordinates();
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(first[i].conjugate(), second[i]);
    EXPECT_FALSE(first[1].is_rational());
    EXPECT_TRUE(verify(four, t.lines[0].line) && verify(four, t.lines[1].line));
}

TEST(Transversals, ASegmentMayLeaveTheSecondRootOnly) {
    // Through z = 0 and z = 2 crossing lines, and two verticals at (1, 2) and (2, 1).
    const auto whole = elements(
        "line 0 0 0, 1 0 0 | line 0 0 2, 0 1 2 | line 1 2 0, 1 2 1 | "
        "line 2 1 0, 2 1 1");
    const Transversals all = transversals(whole);
    ASSERT_EQ(all.lines.size(), 1u) << "the other is parallel to the verticals";
    const Transversals two =
        of("line 0 0 0, 1 0 0 | line 0 0 2, 0 1 2 | line 1 2 0, 2 3 1 | line 2 1 0, 3 1 3");
    ASSERT_EQ(two.lines.size(), 2u);
    const RationalPoint3 on = foot_of_origin(line("0 0 0, 1 0 0"));
    EXPECT_EQ(on, (RationalPoint3{0, 0, 0}));
    // Cut the first element at the middle between the two witnesses: one stays, and keeps its root.
    const auto x = [&](int i) {
        return witness(two.lines[i].line, elements("line 0 0 0, 1 0 0")[0]).x;
    };
    const double middle = (x(0).approx_double() + x(1).approx_double()) / 2;
    const RationalPoint3 cut{Rational(middle), 0, 0};
    for (const int far : {-1000, 1000}) {
        auto four = elements(
            "line 0 0 0, 1 0 0 | line 0 0 2, 0 1 2 | line 1 2 0, 2 3 1 | "
            "line 2 1 0, 3 1 3");
        four[0] = TransversalElement::segment(cut, {far, 0, 0});
        const Transversals one = transversals(four);
        ASSERT_EQ(one.lines.size(), 1u);
        EXPECT_EQ(one.lines[0], two.lines[(x(0) < Surd(Rational(middle))) == (far < 0) ? 0 : 1]);
    }
}

TEST(Transversals, ADoubleLineHasRootZero) {
    // z = xy has the lines x = k; the fourth line touches it: it is tangent at (1, 1, 1).
    const Transversals t =
        of("line 0 0 0, 0 1 0 | line 2 0 0, 2 1 2 | line 3 0 0, 3 1 3 | "
           "line 1 1 1, 2 3 4");
    ASSERT_EQ(t.lines.size(), 1u);
    EXPECT_EQ(t.lines[0].root, 0);
    EXPECT_EQ(t.lines[0].line, to_surd(line("0 1 0, 1 1 1")));
}

TEST(TransversalsDegenerate, Rule1ParallelsDoNotMeet) {
    EXPECT_FALSE(meets(line("0 0 0, 1 0 0"), elements("line 0 1 0, 1 1 0")[0]));
    EXPECT_TRUE(meets(line("0 0 0, 1 0 0"), elements("line 5 0 0, 7 0 0")[0])) << "itself";
    EXPECT_TRUE(meets(line("0 0 0, 1 0 0"), elements("segment 5 0 0, 7 0 0")[0]));
    EXPECT_TRUE(meets(line("0 0 0, 1 0 0"), elements("segment 1 0 0, 1 1 0")[0])) << "closed";
    EXPECT_FALSE(meets(line("0 0 0, 1 0 0"), elements("segment 1 1 0, 1 2 0")[0]));
    // Three parallel lines that are not coplanar have no line in common.
    const Transversals t = of("line 0 0 0, 0 0 1 | line 1 0 0, 1 0 1 | line 0 1 0, 0 1 1");
    EXPECT_THAT(t.lines, IsEmpty());
    EXPECT_THAT(t.components, IsEmpty());
    // The pencil of lines in the plane z = 0 through (0, 1, 0), less the parallel to the x axis.
    const Transversals u = of("line 0 0 0, 1 0 0 | point 0 1 0");
    ASSERT_EQ(u.components.size(), 1u);
    ASSERT_EQ(u.components[0].ranges.size(), 1u);
    EXPECT_FALSE(u.components[0].ranges[0].has_from);
    EXPECT_EQ(u.components[0].ranges[0].from, line("0 1 0, 1 1 0"));
    EXPECT_FALSE(is_in_family(u.components[0], to_surd(line("0 1 0, 1 1 0"))));
    EXPECT_TRUE(is_in_family(u.components[0], to_surd(line("0 1 0, 1 2 0"))));
}

TEST(TransversalsDegenerate, Rule2CollinearSegmentsCountAsTheirCommonPiece) {
    const Transversals overlap = of("segment 0 0 0, 2 0 0 | segment 1 0 0, 3 0 0");
    ASSERT_THAT(kinds(overlap), ElementsAre(Family::segment));
    EXPECT_EQ(overlap.components[0].pieces, elements("segment 1 0 0, 2 0 0"));
    const Transversals touching = of("segment 0 0 0, 1 0 0 | segment 1 0 0, 3 0 0");
    ASSERT_THAT(kinds(touching), ElementsAre(Family::bundle));
    EXPECT_EQ(touching.components[0].point, (RationalPoint3{1, 0, 0}));
    const Transversals apart = of("segment 0 0 0, 1 0 0 | segment 2 0 0, 3 0 0");
    EXPECT_THAT(apart.components, IsEmpty());
    ASSERT_EQ(apart.lines.size(), 1u);
    EXPECT_EQ(apart.lines[0].line, to_surd(line("0 0 0, 1 0 0")));
    EXPECT_EQ(of("segment 1 0 0, 1 0 0 | segment 0 1 0, 0 1 0"), of("point 1 0 0 | point 0 1 0"));
    EXPECT_EQ(of("segment 1 0 0, 1 0 0").components[0].kind, Family::bundle);
}

TEST(TransversalsDegenerate, Rule3APencilThatShrinksToALineIsALine) {
    // From the origin both segments are seen in one direction only: that of their common end line.
    const Transversals t =
        of("point 0 0 0 | segment 1 1 0, 2 1 0 | segment 2 2 0, 2 3 0 | segment 3 3 0, 3 3 1");
    EXPECT_THAT(t.components, IsEmpty());
    ASSERT_EQ(t.lines.size(), 1u);
    EXPECT_EQ(t.lines[0].line, to_surd(line("0 0 0, 1 1 0")));
}

TEST(TransversalsDegenerate, Rule4ConcurrentSegmentsHaveABundleAndCoplanarOnesAPlane) {
    EXPECT_THAT(kinds(of("segment -1 0 0, 1 0 0 | segment 0 -1 0, 0 1 0 | segment 0 0 -1, 0 0 1 | "
                         "segment -1 -1 -1, 1 1 1")),
                ElementsAre(Family::bundle));
    const Transversals plane =
        of("segment 0 0 0, 0 4 0 | segment 1 1 0, 1 5 0 | "
           "segment 2 0 0, 2 3 0 | segment 3 1 0, 3 2 0");
    ASSERT_THAT(kinds(plane), ElementsAre(Family::plane));
    EXPECT_THAT(plane.lines, IsEmpty());
    for (const RationalLine3& l : plane.components[0].extremal) {
        EXPECT_TRUE(verify(elements("segment 0 0 0, 0 4 0 | segment 1 1 0, 1 5 0 | "
                                    "segment 2 0 0, 2 3 0 | segment 3 1 0, 3 2 0"),
                           to_surd(l)));
    }
    // Two crossing segments: all lines in their plane that meet both, and all through the crossing.
    EXPECT_THAT(kinds(of("segment -1 0 0, 1 0 0 | segment 0 -1 0, 0 1 0")),
                ElementsAre(Family::plane, Family::bundle));
    // A third one across leaves a pencil in each of two planes.
    EXPECT_THAT(kinds(of("segment -1 0 0, 1 0 0 | segment 0 -1 0, 0 1 0 | segment 2 2 -1, 2 2 1")),
                ElementsAre(Family::pencil, Family::pencil));
}

TEST(TransversalsDegenerate, Rule4ThinPartsOfAPlaneArePencils) {
    // Lines that meet both segments at x = 0 (they share one point there) turn round that point.
    const Transversals t =
        of("segment 0 0 0, 0 1 0 | segment -1 0 0, 0 0 0 | segment 1 -1 0, 2 0 0");
    EXPECT_THAT(kinds(t), ::testing::Contains(Family::pencil));
}

TEST(TransversalsDegenerate, ARegulusIsCutToRanges) {
    // z = xy: four lines x = k, cut to 0 <= y <= 1: all lines y = c with c between 0 and 1.
    const Transversals t =
        of("segment 0 0 0, 0 1 0 | segment 1 0 0, 1 1 1 | "
           "segment 2 0 0, 2 1 2 | segment 3 -1 -3, 3 1 3");
    ASSERT_THAT(kinds(t), ElementsAre(Family::regulus));
    ASSERT_EQ(t.components[0].ranges.size(), 1u);
    const TransversalRange& range = t.components[0].ranges[0];
    EXPECT_EQ(range.from, line("0 0 0, 1 0 0"));
    EXPECT_EQ(range.to, line("0 1 0, 1 1 1"));
    EXPECT_TRUE(is_in_family(t.components[0], to_surd(line("0 1/3 0, 3 1/3 1"))));
    EXPECT_FALSE(is_in_family(t.components[0], to_surd(line("0 2 0, 1 2 2"))));
    // The whole lines leave out the regulus' line at infinity only.
    const Transversals whole =
        of("line 0 0 0, 0 1 0 | line 1 0 0, 1 1 1 | line 2 0 0, 2 1 2 | "
           "line 3 0 0, 3 1 3");
    ASSERT_THAT(kinds(whole), ElementsAre(Family::regulus));
    EXPECT_FALSE(whole.components[0].ranges[0].has_from);
    EXPECT_FALSE(whole.components[0].ranges[0].from.is_line());
    // Ends that touch: one line.
    const Transversals one =
        of("segment 0 0 0, 0 1 0 | segment 1 0 0, 1 1 1 | "
           "segment 2 1 2, 2 2 4 | segment 3 -1 -3, 3 1 3");
    EXPECT_THAT(one.components, IsEmpty());
    ASSERT_EQ(one.lines.size(), 1u);
    EXPECT_EQ(one.lines[0].line, to_surd(line("0 1 0, 1 1 1")));
}

TEST(TransversalsDegenerate, AWitnessLiesOnBoth) {
    const auto four = elements(
        "line 0 0 0, 1 0 0 | line 0 0 2, 0 1 2 | line 1 2 0, 2 3 1 | "
        "segment -99 1 -303, 99 1 291");
    for (const TransversalLine& l : transversals(four).lines) {
        for (const TransversalElement& e : four) {
            const SurdVector3 p = witness(l.line, e);
            EXPECT_TRUE(is_on(l.line, p));
            EXPECT_TRUE(is_on(to_surd(e.carrier()), p));
        }
    }
    const auto own = elements("segment 1 0 0, 2 0 0");
    EXPECT_EQ(witness(to_surd(line("0 0 0, 1 0 0")), own[0]), (SurdVector3{1, 0, 0}));
    EXPECT_THROW((void)witness(to_surd(line("0 1 0, 1 1 0")), own[0]), std::logic_error);
}

TEST(TransversalsDegenerate, ACertificateRefusesWhatIsNoTransversal) {
    const auto four = elements("line 0 0 0, 1 0 0 | segment 0 0 2, 0 1 2");
    EXPECT_TRUE(verify(four, to_surd(line("1 0 0, 0 1 2"))));
    EXPECT_FALSE(verify(four, to_surd(line("1 0 0, 0 2 2"))));
    SurdLine3 unscaled = to_surd(line("1 0 0, 0 1 2"));
    unscaled.d = Surd(2) * unscaled.d;
    EXPECT_FALSE(verify(four, unscaled)) << "d·m = 0 holds, but it is another line, or unscaled";
    EXPECT_FALSE(verify(four, SurdLine3{{1, 0, 0}, {1, 0, 0}})) << "no line";
}

}  // namespace
}  // namespace sightline
