// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that meet given points and lines, where these are not in general position: each case by hand.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "event/lines3.hpp"
#include "sightline/event/swath.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {
namespace {

using testing::any_line3;
using testing::any_point3;
using testing::is_zero;

RationalLine3 line(const RationalPoint3& p, const RationalPoint3& q) { return line_through(p, q); }
ProjectivePoint3 at(int x, int y, int z) { return {{x, y, z}, 1}; }
ProjectivePoint3 towards(int x, int y, int z) { return {{x, y, z}, 0}; }

const RationalLine3 x_axis = line({0, 0, 0}, {1, 0, 0});
const RationalLine3 y_axis = line({0, 0, 0}, {0, 1, 0});
const RationalLine3 z_axis = line({0, 0, 0}, {0, 0, 1});
const Plane3 ground{{0, 0, 1}, 0};

TEST(FamiliesDegenerate, TwoLinesThatMeetAndAThirdMakeTwoPencils) {
    // x and y axis, and an upright line at (1, 2).
    const RationalLine3 third = line({1, 2, 0}, {1, 2, 1});
    const LineFamilies all = families_meeting({}, {x_axis, y_axis, third});
    EXPECT_FALSE(all.has_larger);
    EXPECT_TRUE(all.isolated.empty());
    EXPECT_THAT(all.swaths, ::testing::UnorderedElementsAre(Swath::pencil(at(0, 0, 0), third),
                                                            Swath::pencil(at(1, 2, 0), ground)));
}

TEST(FamiliesDegenerate, TwoParallelsAndAThirdMakeAPencilAndParallels) {
    const RationalLine3 parallel = line({0, 5, 0}, {1, 5, 0});
    const RationalLine3 third = line({1, 2, 0}, {1, 2, 1});
    const LineFamilies all = families_meeting({}, {x_axis, parallel, third});
    EXPECT_THAT(all.swaths, ::testing::UnorderedElementsAre(Swath::pencil(towards(1, 0, 0), third),
                                                            Swath::pencil(at(1, 2, 0), ground)));
    EXPECT_EQ(all.swaths[0].kind() == SwathKind::parallel,
              all.swaths[1].kind() == SwathKind::pencil);
}

TEST(FamiliesDegenerate, ThirdLineParallelToThePlaneOfTwoMakesParallelsInIt) {
    const RationalLine3 above = line({0, 0, 1}, {1, 1, 1});
    const LineFamilies all = families_meeting({}, {x_axis, y_axis, above});
    EXPECT_THAT(all.swaths, ::testing::UnorderedElementsAre(Swath::pencil(towards(1, 1, 0), ground),
                                                            Swath::pencil(at(0, 0, 0), above)));
}

TEST(FamiliesDegenerate, ChainOfThreeLinesMakesTheSameTwoPencilsEitherWay) {
    // y meets x at 0, and the upright line at (0, 3, 0); x and that line are skew.
    const RationalLine3 upright = line({0, 3, 0}, {0, 3, 1});
    const auto expected = ::testing::UnorderedElementsAre(Swath::pencil(at(0, 0, 0), upright),
                                                          Swath::pencil(at(0, 3, 0), ground));
    EXPECT_THAT(families_meeting({}, {x_axis, y_axis, upright}).swaths, expected);
    EXPECT_THAT(families_meeting({}, {upright, x_axis, y_axis}).swaths, expected);
}

TEST(FamiliesDegenerate, ThreeLinesThroughAPointOrInAPlaneLeaveTwoDimensions) {
    const LineFamilies concurrent = families_meeting({}, {x_axis, y_axis, z_axis});
    EXPECT_TRUE(concurrent.has_larger);
    EXPECT_TRUE(concurrent.swaths.empty()) << "pencils in the bundle are part of it";
    const RationalLine3 third = line({1, 0, 0}, {0, 1, 0});
    const LineFamilies coplanar = families_meeting({}, {x_axis, y_axis, third});
    EXPECT_TRUE(coplanar.has_larger);
    EXPECT_TRUE(coplanar.swaths.empty()) << "pencils in the plane are part of it";
}

TEST(FamiliesDegenerate, FourthLineCutsABundleAndAPlaneToPencils) {
    const RationalLine3 far = line({1, 2, 0}, {1, 2, 1});
    const LineFamilies bundle = families_meeting({}, {x_axis, y_axis, z_axis, far});
    EXPECT_FALSE(bundle.has_larger);
    EXPECT_THAT(bundle.swaths, ::testing::ElementsAre(Swath::pencil(at(0, 0, 0), far)));
    const RationalLine3 third = line({1, 0, 0}, {0, 1, 0});
    const LineFamilies field = families_meeting({}, {x_axis, y_axis, third, far});
    EXPECT_THAT(field.swaths, ::testing::ElementsAre(Swath::pencil(at(1, 2, 0), ground)));
}

TEST(FamiliesDegenerate, ThreeSkewLinesParallelToAPlaneMakeAParaboloid) {
    // y = 0 at z = 0, x = y at z = 1, x = 0 at z = 2: one of the lines is at infinity.
    const RationalLine3 a = x_axis, b = line({0, 0, 1}, {1, 1, 1}), c = line({0, 0, 2}, {0, 1, 2});
    const LineFamilies all = families_meeting({}, {a, b, c});
    ASSERT_EQ(all.swaths.size(), 1u);
    const Swath& swath = all.swaths[0];
    EXPECT_EQ(swath.kind(), SwathKind::regulus);
    EXPECT_FALSE(swath.along({0, 0, 0}, {1, 0, 0}).at_infinity().is_line());
    // Its directions split into two planes of directions: d.z = 0 is one of them.
    EXPECT_TRUE(is_zero(swath.directions()({1, 1, 0})));
    EXPECT_TRUE(is_zero(swath.directions()({3, -2, 0})));
}

TEST(FamiliesDegenerate, FourLinesOfOneFamilyLeaveTheWholeRegulus) {
    // Lines of one ruling of z = x y: x = k, z = k y.
    std::vector<RationalLine3> rulings;
    for (int k = 0; k < 4; ++k) rulings.push_back(line({k, 0, 0}, {k, 1, k}));
    const LineFamilies all = families_meeting({}, rulings);
    ASSERT_EQ(all.swaths.size(), 1u);
    EXPECT_TRUE(all.isolated.empty());
    EXPECT_TRUE(all.swaths[0].contains(line({0, 7, 0}, {1, 7, 7}))) << "y = 7, z = 7 x";
    EXPECT_FALSE(all.swaths[0].contains(line({7, 0, 0}, {7, 1, 7}))) << "the other ruling";
}

TEST(FamiliesDegenerate, TangentFourthLineLeavesADoubleLineOnce) {
    // The upright at (1, 1) of z = x y, tilted within the tangent plane: meets the surface twice there.
    std::vector<RationalLine3> lines;
    for (int k = 0; k < 3; ++k) lines.push_back(line({k, 0, 0}, {k, 1, k}));
    // At (3, 5, 15) the tangent plane is spanned by (1, 0, 5) and (0, 1, 3).
    lines.push_back(line({3, 5, 15}, {4, 6, 23}));
    const LineFamilies all = families_meeting({}, lines);
    ASSERT_EQ(all.isolated.size(), 1u);
    EXPECT_EQ(all.isolated[0], scaled(to_surd(line({0, 5, 0}, {1, 5, 5}))));
}

TEST(FamiliesDegenerate, IrrationalLinesComeInTheOrderOfTheirVectors) {
    // Lines y = k, z = k x of z = x y that meet x = 0 + s, y = s, z = 2: k² = 2.
    std::vector<RationalLine3> lines;
    for (int k = 0; k < 3; ++k) lines.push_back(line({k, 0, 0}, {k, 1, k}));
    lines.push_back(line({0, 0, 2}, {1, 1, 2}));
    const LineFamilies all = families_meeting({}, lines);
    ASSERT_EQ(all.isolated.size(), 2u);
    EXPECT_LT(all.isolated[0], all.isolated[1]);
    EXPECT_EQ(all.isolated[1].d, (SurdVector3{1, 0, Surd::square_root(2)}));
    EXPECT_EQ(all.isolated[0].d, (SurdVector3{1, 0, -Surd::square_root(2)}));
}

TEST(FamiliesDegenerate, PointTakesPlanesOfAllLinesNotThroughIt) {
    const RationalPoint3 p{0, 0, 5};
    const RationalLine3 over_x = line({0, 3, -5}, {2, 3, -5});
    const LineFamilies one = families_meeting({p}, {x_axis, z_axis});
    EXPECT_THAT(one.swaths, ::testing::ElementsAre(Swath::pencil(at(0, 0, 5), x_axis)))
        << "the z axis passes through the point";
    const LineFamilies two = families_meeting({p}, {x_axis, over_x, z_axis});
    EXPECT_TRUE(two.swaths.empty());
    EXPECT_THAT(two.isolated, ::testing::ElementsAre(scaled(to_surd(line_along(p, {1, 0, 0})))))
        << "parallel to both";
    EXPECT_TRUE(families_meeting({p}, {z_axis}).has_larger);
}

TEST(FamiliesDegenerate, TwoPointsFixTheLineOrThereIsNone) {
    const RationalPoint3 o{0, 0, 0}, p{2, 2, 0}, q{3, 3, 0}, r{1, 0, 0};
    const auto diagonal = scaled(to_surd(line(o, p)));
    EXPECT_THAT(families_meeting({o, p}, {}).isolated, ::testing::ElementsAre(diagonal));
    EXPECT_THAT(families_meeting({o, p, q, p}, {x_axis}).isolated,
                ::testing::ElementsAre(diagonal));
    EXPECT_TRUE(families_meeting({o, p, r}, {}).isolated.empty());
    EXPECT_TRUE(families_meeting({o, p}, {line({0, 0, 1}, {1, 0, 1})}).isolated.empty());
}

TEST(FamiliesDegenerate, FewConditionsLeaveSomethingLarger) {
    EXPECT_TRUE(families_meeting({}, {}).has_larger);
    EXPECT_TRUE(families_meeting({}, {x_axis}).has_larger);
    EXPECT_TRUE(families_meeting({}, {x_axis, -x_axis, x_axis}).has_larger) << "one line thrice";
    EXPECT_TRUE(families_meeting({}, {x_axis, line({0, 1, 0}, {0, 1, 1})}).has_larger);
    EXPECT_TRUE(families_meeting({{1, 2, 3}}, {}).has_larger);
}

TEST(SwathDegenerate, ContractsAreKept) {
    EXPECT_THROW((void)Swath::pencil(at(3, 0, 0), x_axis), ContractViolation);
    EXPECT_THROW((void)Swath::pencil(towards(1, 0, 0), x_axis), ContractViolation);
    EXPECT_THROW((void)Swath::pencil(at(0, 0, 1), ground), ContractViolation);
    EXPECT_THROW((void)Swath::regulus(x_axis, y_axis, line({1, 2, 0}, {1, 2, 1})),
                 ContractViolation);
    const Swath pencil = Swath::pencil(at(0, 0, 1), x_axis);
    EXPECT_THROW((void)pencil.generators(), ContractViolation);
    EXPECT_THROW((void)pencil.along({0, 0, 0}, {0, 1, 0}), ContractViolation) << "not met by all";
    EXPECT_THROW((void)pencil.along({0, 0, 0}, {0, 0, 1}), ContractViolation) << "one of them";
}

/// Whether a line is accounted for.
bool is_known(const LineFamilies& all, const RationalLine3& l) {
    const SurdLine3 same = scaled(to_surd(l));
    return all.has_larger ||
           std::ranges::any_of(all.swaths, [&](const Swath& s) { return s.contains(l); }) ||
           std::ranges::find(all.isolated, same) != all.isolated.end();
}

RC_GTEST_PROP(FamiliesLaw, EveryLineThatMeetsAllIsFoundAndNoOther, ()) {
    std::vector<RationalLine3> lines;
    const int count = *rc::gen::inRange(3, 6);
    for (int i = 0; i < count; ++i) lines.push_back(any_line3(3));
    std::vector<RationalPoint3> points;
    if (*rc::gen::inRange(0, 3) == 0) points.push_back(any_point3(3));
    const LineFamilies all = families_meeting(points, lines);
    for (const Swath& swath : all.swaths) {
        for (const RationalLine3& l : lines) RC_ASSERT(swath.all_meet(l));
        for (const RationalPoint3& p : points) RC_ASSERT(swath.all_pass(p));
    }
    for (const SurdLine3& line : all.isolated) {
        RC_ASSERT(line.is_line());
        for (const RationalLine3& l : lines) {
            RC_ASSERT(side(line, to_surd(l)).sign() == Sign::zero);
        }
        for (const RationalPoint3& p : points) RC_ASSERT(is_on(line, to_surd(vector_to(p))));
        for (const Swath& swath : all.swaths) RC_ASSERT(!swath.contains(line));
    }
    // Grid lines that happen to meet all: dense enough to hit.
    for (int i = 0; i < 20; ++i) {
        const RationalLine3 l = points.empty() ? any_line3(3) : [&] {
            RationalPoint3 q = points[0];
            while (q == points[0]) q = any_point3(3);
            return line_through(points[0], q);
        }();
        const bool meets =
            std::ranges::all_of(lines, [&](const RationalLine3& k) { return is_zero(side(l, k)); });
        if (meets) RC_ASSERT(is_known(all, l));
    }
}

RC_GTEST_PROP(FamiliesLaw, OrderOfLinesDoesNotMatter, ()) {
    std::vector<RationalLine3> lines;
    for (int i = 0; i < 4; ++i) lines.push_back(any_line3(3));
    const LineFamilies one = families_meeting({}, lines);
    // Lines are taken in the order of their scaled vectors; turning space changes that.
    std::vector<RationalLine3> turned;
    for (const RationalLine3& l : lines) {
        turned.push_back({{-l.d.z, l.d.y, l.d.x}, {-l.m.z, l.m.y, l.m.x}});
    }
    const LineFamilies two = families_meeting({}, turned);
    RC_ASSERT(one.isolated.size() == two.isolated.size());
    RC_ASSERT(one.swaths.size() == two.swaths.size());
    RC_ASSERT(one.has_larger == two.has_larger);
    for (const Swath& swath : one.swaths) {
        RC_ASSERT(std::ranges::count(two.swaths, swath.kind(), &Swath::kind) ==
                  std::ranges::count(one.swaths, swath.kind(), &Swath::kind));
    }
}

}  // namespace
}  // namespace sightline
