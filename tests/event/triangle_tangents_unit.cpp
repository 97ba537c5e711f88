// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/triangle_tangents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "sightline/event/segment_transversals.hpp"

namespace sightline {
namespace {

using ::testing::IsEmpty;
using Family = TransversalComponent::Kind;
using Triangles = std::array<RationalTriangle3, 4>;

Triangles triangles(const std::string& text) {
    const auto read = read_triangles(text, "test").value();
    return {read.at(0), read.at(1), read.at(2), read.at(3)};
}

SurdLine3 line(const std::string& text) {
    const auto s = read_segments(text, "test").value().at(0);
    return scaled(to_surd(line_through(s.source, s.target)));
}

Triangles draw(std::uint64_t seed, int grid) {
    std::mt19937_64 bits(seed);
    const auto coordinate = [&] {
        return Rational(static_cast<int>(bits() % std::uint64_t(grid)));
    };
    const auto point = [&] {
        Rational x = coordinate(), y = coordinate(), z = coordinate();
        return RationalPoint3{x, y, z};
    };
    Triangles result;
    for (RationalTriangle3& t : result) {
        do {
            t = {point(), point(), point()};
        } while (plane_through(t[0], t[1], t[2]).is_degenerate());
    }
    return result;
}

TEST(TriangleTangents, InGeneralPositionAreTheLinesThroughOneEdgeOfEach) {
    std::size_t all = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Triangles four = draw(seed, 100);
        std::vector<RationalSegment3> edges;
        for (const auto& t : four) {
            for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(t, i));
        }
        std::set<SurdLine3> expected;
        const auto batch = transversals(edges).value();
        for (const auto& l : batch.lines) {
            bool one_of_each = true;
            for (std::uint32_t k = 0; k < 4; ++k) one_of_each &= l.support[k] / 3 == k;
            if (one_of_each) expected.insert(exact_line(edges, l));
        }
        const TriangleTangents found = triangle_tangents(four);
        EXPECT_THAT(found.components, IsEmpty());
        std::set<SurdLine3> actual;
        for (const auto& l : found.lines) {
            actual.insert(l.line);
            const std::array<TransversalElement, 4> support{
                TransversalElement::segment(edge_of(four[0], l.edges[0])),
                TransversalElement::segment(edge_of(four[1], l.edges[1])),
                TransversalElement::segment(edge_of(four[2], l.edges[2])),
                TransversalElement::segment(edge_of(four[3], l.edges[3]))};
            EXPECT_TRUE(verify(support, l.line));
        }
        EXPECT_EQ(actual, expected);
        EXPECT_EQ(actual.size(), found.lines.size());
        all += actual.size();
    }
    EXPECT_GT(all, 20u);
}

TEST(TriangleTangentsDegenerate, Rule1GrazingIsNotEntering) {
    const RationalTriangle3 t = triangles(
        "0 0 0 4 0 0 0 4 0 0 0 0 1 0 0 0 1 0 "
        "0 0 0 1 0 0 0 1 0 0 0 0 1 0 0 0 1 0")[0];
    EXPECT_TRUE(is_tangent(line("2 0 0 2 0 1"), t)) << "across an edge";
    EXPECT_TRUE(is_tangent(line("0 0 0 1 1 1"), t)) << "through a corner";
    EXPECT_FALSE(is_tangent(line("1 1 0 1 1 1"), t)) << "through the inside";
    EXPECT_FALSE(is_tangent(line("9 9 0 9 9 1"), t)) << "beside it";
    EXPECT_TRUE(is_tangent(line("0 0 0 1 0 0"), t)) << "along an edge";
    EXPECT_TRUE(is_tangent(line("0 0 0 1 -1 0"), t)) << "in the plane, through a corner";
    EXPECT_FALSE(is_tangent(line("0 0 0 1 1 0"), t)) << "in the plane, along a chord";
    EXPECT_FALSE(is_tangent(line("0 -1 0 1 -1 0"), t)) << "in the plane, beside it";
    EXPECT_FALSE(is_tangent(line("0 0 1 1 0 1"), t)) << "parallel to the plane";
}

TEST(TriangleTangentsDegenerate, CoplanarTrianglesHaveTheBitangentsOfThePlane) {
    const TriangleTangents found = triangle_tangents(
        triangles("0 0 0 1 0 0 0 1 0  9 0 0 10 0 0 9 1 0  0 0 0 1 0 0 0 1 0  9 0 0 10 0 0 9 1 0"));
    EXPECT_THAT(found.components, IsEmpty());
    std::set<SurdLine3> lines;
    for (const auto& l : found.lines) lines.insert(l.line);
    EXPECT_EQ(lines, (std::set{line("0 0 0 1 0 0"), line("0 1 0 9 1 0"), line("0 1 0 9 0 0"),
                               line("1 0 0 9 1 0")}));
}

TEST(TriangleTangentsDegenerate, ASharedCornerIsABundle) {
    const TriangleTangents found = triangle_tangents(
        triangles("0 0 0 1 0 0 0 1 0  0 0 0 0 1 0 0 0 1  0 0 0 0 0 1 1 0 0  0 0 0 -1 0 0 0 -1 3"));
    ASSERT_FALSE(found.components.empty());
    EXPECT_TRUE(std::ranges::any_of(found.components, [](const auto& c) {
        return c.kind == Family::bundle && c.point == RationalPoint3{0, 0, 0};
    }));
}

TEST(TriangleTangentsDegenerate, Rule3APencilInTheTrianglesPlaneIsCutToWhatGrazes) {
    // One corner shared by all in one plane: lines through it outside of all four angles.
    const TriangleTangents found = triangle_tangents(
        triangles("0 0 0 1 0 0 1 1 0  0 0 0 2 0 0 1 1 0  0 0 0 1 0 0 2 1 0  0 0 0 3 0 0 3 1 0"));
    ASSERT_FALSE(found.components.empty());
    for (const auto& c : found.components) {
        if (c.kind != Family::pencil) continue;
        for (const auto& r : c.ranges) {
            for (const auto& t : triangles("0 0 0 1 0 0 1 1 0  0 0 0 2 0 0 1 1 0 "
                                           "0 0 0 1 0 0 2 1 0  0 0 0 3 0 0 3 1 0")) {
                EXPECT_TRUE(is_tangent(to_surd(r.through), t));
            }
        }
    }
}

// Whatever comes out is tangent, does not depend on the order, and isolated lines are in no family.
TEST(TriangleTangentsDegenerate, HoldTheirLawsOnSmallGrids) {
    std::size_t with_families = 0;
    // Rule 3: in a triangle's plane the sample of a range may be an exception.
    const auto touches = [](const RationalLine3& l, const RationalTriangle3& t) {
        return is_tangent(to_surd(l), t) || meets(l, TransversalElement::segment(edge_of(t, 0))) ||
               meets(l, TransversalElement::segment(edge_of(t, 1)));
    };
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Triangles four = draw(seed, seed % 2 == 0 ? 2 : 3);
        const TriangleTangents found = triangle_tangents(four);
        with_families += found.components.empty() ? 0 : 1;
        std::set<SurdLine3> lines;
        for (const auto& l : found.lines) {
            lines.insert(l.line);
            for (const auto& t : four) ASSERT_TRUE(is_tangent(l.line, t)) << seed;
            for (const auto& c : found.components) {
                ASSERT_TRUE(c.kind == Family::plane || !is_in_family(c, l.line)) << seed;
            }
        }
        for (const auto& c : found.components) {
            if (c.kind != Family::pencil && c.kind != Family::regulus) continue;
            for (const auto& r : c.ranges) {
                for (const auto& t : four) ASSERT_TRUE(touches(r.through, t)) << seed;
            }
        }
        std::rotate(four.begin(), four.begin() + 1, four.end());
        for (auto& t : four) std::rotate(t.begin(), t.begin() + 1, t.end());
        const TriangleTangents turned = triangle_tangents(four);
        std::set<SurdLine3> other;
        for (const auto& l : turned.lines) other.insert(l.line);
        ASSERT_EQ(other, lines) << seed;
        ASSERT_EQ(turned.components.size(), found.components.size()) << seed;
    }
    EXPECT_GT(with_families, 20u);
}

TEST(SegmentFile, ReadsDecimalsAndFractionsExactly) {
    const auto read = read_segments("# two\n1.5 -2e-1 3/7\n 0 0 .25 # c\n1 2 3 4 5 6", "f").value();
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].source, (RationalPoint3{*Rational::parse("3/2"), *Rational::parse("-1/5"),
                                              *Rational::parse("3/7")}));
    EXPECT_EQ(read[0].target, (RationalPoint3{0, 0, *Rational::parse("1/4")}));
    EXPECT_EQ(read_triangles("0 0 0 1 0 0 0 1 0", "f").value().size(), 1u);
}

TEST(SegmentFile, ErrorsNameLineAndObject) {
    const auto message = [](const char* text) { return read_segments(text, "f").error().message; };
    EXPECT_EQ(
        message("1 2 3\n4 five 6"),
        "f:2: segment 0: 'five' is no number; write a decimal as 1.5 or 2e-3, or a fraction as "
        "3/7");
    EXPECT_EQ(message("1 2 3 4 5 6\n7 8"),
              "f:2: the text ends within segment 1; each has 6 numbers");
    EXPECT_EQ(message("# nothing\n"), "f: there is no segment; write 6 numbers for each");
    EXPECT_EQ(
        message("1 2 3 4 5 1/0"),
        "f:1: segment 0: '1/0' is no number; write a decimal as 1.5 or 2e-3, or a fraction as "
        "3/7");
    const auto flat = read_triangles("0 0 0 1 0 0 0 1 0\n\n0 0 0\n1 1 1 2 2 2", "f");
    EXPECT_EQ(flat.error().code, Errc::zero_length);
    EXPECT_EQ(flat.error().message, "f:3: triangle 1: its corners are collinear; move one");
}

}  // namespace
}  // namespace sightline
