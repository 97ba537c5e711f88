// SPDX-License-Identifier: GPL-3.0-or-later
// The batch against the solution of each quadruple by itself, and its arithmetics against each
// other.
#include "sightline/event/segment_transversals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/transversals.hpp"

namespace sightline {
namespace {

using Segments = std::vector<RationalSegment3>;

SegmentTransversals one_by_one(const Segments& segments) {
    SegmentTransversals result;
    const auto n = static_cast<std::uint32_t>(segments.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
            for (std::uint32_t k = j + 1; k < n; ++k) {
                for (std::uint32_t l = k + 1; l < n; ++l) {
                    std::vector<TransversalElement> four;
                    for (const auto x : {i, j, k, l}) {
                        four.push_back(TransversalElement::segment(segments[x]));
                    }
                    const Transversals found = transversals(four);
                    for (const auto& line : found.lines) {
                        result.lines.push_back({{i, j, k, l}, line.root});
                    }
                    for (const auto& c : found.components) {
                        result.components.push_back({{i, j, k, l}, c});
                    }
                }
            }
        }
    }
    return result;
}

void expect_same(const SegmentTransversals& actual, const SegmentTransversals& expected,
                 const std::string& what) {
    ASSERT_EQ(actual.lines.size(), expected.lines.size()) << what;
    for (std::size_t i = 0; i < actual.lines.size(); ++i) {
        const auto &a = actual.lines[i], &b = expected.lines[i];
        ASSERT_TRUE(a == b) << what << " line " << i << " root " << int(a.root) << int(b.root);
    }
    ASSERT_TRUE(actual.components == expected.components) << what;
}

// Coordinates on a grid, moved by so small a step that doubles alone would not see it.
Segments draw(std::uint64_t seed, int count, int grid, const Rational& step) {
    std::mt19937_64 bits(seed);
    const auto coordinate = [&] {
        const auto whole = static_cast<int>(bits() % static_cast<std::uint64_t>(grid));
        return Rational(whole) + step * static_cast<int>(bits() % 5);
    };
    const auto point = [&] {
        Rational x = coordinate(), y = coordinate(), z = coordinate();
        return RationalPoint3{x, y, z};
    };
    Segments segments;
    for (int i = 0; i < count; ++i) {
        RationalPoint3 a = point(), b = point();
        segments.push_back({a, b});
    }
    return segments;
}

TEST(SegmentTransversalsDifferential, EqualsTheSolutionOfEachQuadruple) {
    std::size_t lines = 0, components = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const int grid = seed % 3 == 0 ? 2 : seed % 3 == 1 ? 6 : 1000;
        const Segments segments = draw(seed, 8, grid, 0);
        const auto batch = transversals(segments);
        ASSERT_TRUE(batch);
        expect_same(*batch, one_by_one(segments), "seed " + std::to_string(seed));
        lines += batch->lines.size();
        components += batch->components.size();
    }
    EXPECT_GT(lines, 100u);
    EXPECT_GT(components, 50u);
}

TEST(SegmentTransversalsDifferential, NearlyDegenerateSegmentsNeedEveryTier) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Segments segments =
            draw(seed, 7, 3, seed % 2 == 0 ? Rational(0x1p-70) : *Rational::parse("1e-30"));
        TransversalOptions options;
        options.tally = &tally;
        const auto batch = transversals(segments, options);
        ASSERT_TRUE(batch);
        expect_same(*batch, one_by_one(segments), "seed " + std::to_string(seed));
    }
    const TierCounts& counts = tally[Predicate::transversals3];
    EXPECT_GT(counts.filter, 0u);
    EXPECT_GT(counts.exact, 50u);
    EXPECT_EQ(counts.calls, 6u * 35u);
    EXPECT_EQ(counts.undecided, 0u);
}

TEST(SegmentTransversalsDifferential, AllArithmeticsAgreeOnGenericSegments) {
    for (std::uint64_t seed = 20; seed < 23; ++seed) {
        const Segments segments = draw(seed, 16, 100000, 0);
        const auto filtered = transversals(segments);
        ASSERT_TRUE(filtered);
        EXPECT_GT(filtered->lines.size(), 0u);
        for (const Arithmetic a : {Arithmetic::exact, Arithmetic::interval, Arithmetic::double_}) {
            Tally tally;
            TransversalOptions options;
            options.arithmetic = a;
            options.tally = &tally;
            const auto other = transversals(segments, options);
            ASSERT_TRUE(other);
            expect_same(*other, *filtered, "arithmetic " + std::to_string(static_cast<int>(a)));
            EXPECT_EQ(tally[Predicate::transversals3].calls, 1820u);
        }
    }
}

TEST(SegmentTransversalsDifferential, ExactAndFilteredAgreeWhenDegenerate) {
    for (std::uint64_t seed = 30; seed < 36; ++seed) {
        const Segments segments = draw(seed, 9, 4, seed % 2 == 0 ? Rational(0) : Rational(0x1p-60));
        TransversalOptions exact;
        exact.arithmetic = Arithmetic::exact;
        expect_same(*transversals(segments), *transversals(segments, exact),
                    "seed " + std::to_string(seed));
    }
}

TEST(SegmentTransversalsDifferential, DoublesMissWhatIsDegenerate) {
    const Segments segments = draw(40, 9, 3, 0);
    TransversalOptions doubles;
    doubles.arithmetic = Arithmetic::double_;
    const auto rough = transversals(segments, doubles);
    ASSERT_TRUE(rough);
    EXPECT_FALSE(*rough == *transversals(segments));
    EXPECT_TRUE(rough->components.empty());
}

TEST(SegmentTransversals, ExtremeCoordinatesAreDecidedExactly) {
    // 1e200: determinants overflow in doubles, so nothing but exact numbers can decide.
    Segments segments = draw(50, 8, 1000, 0);
    const auto expected = transversals(segments);
    for (const char* factor : {"1e200", "1e-200", "1/3"}) {
        Segments scaled_segments = segments;
        for (RationalSegment3& s : scaled_segments) {
            for (RationalPoint3* p : {&s.source, &s.target}) {
                for (Rational* x : {&p->x, &p->y, &p->z}) *x *= *Rational::parse(factor);
            }
        }
        expect_same(*transversals(scaled_segments), *expected, factor);
    }
}

TEST(SegmentTransversals, AnExactLineIsTheLineOfItsSupport) {
    const Segments segments = draw(60, 8, 50, 0);
    const auto all = transversals(segments);
    ASSERT_GT(all->lines.size(), 0u);
    for (const auto& line : all->lines) {
        std::vector<TransversalElement> four;
        for (const auto i : line.support) {
            four.push_back(TransversalElement::segment(segments[i]));
        }
        const Transversals listed = transversals(four);
        const auto found = std::ranges::find(listed.lines, line.root, &TransversalLine::root);
        ASSERT_NE(found, listed.lines.end());
        EXPECT_EQ(exact_line(segments, line), found->line);
    }
    EXPECT_THROW((void)exact_line(segments, {{0, 1, 2, 99}, 0}), ContractViolation);
}

TEST(SegmentTransversals, FewerThanFourHaveNone) {
    EXPECT_EQ(*transversals(std::span<const RationalSegment3>{}), SegmentTransversals{});
    EXPECT_EQ(*transversals(draw(1, 3, 5, 0)), SegmentTransversals{});
}

TEST(SegmentTransversals, LimitsAreKept) {
    const Segments segments = draw(61, 12, 50, 0);
    const std::size_t size = transversals(segments)->lines.size();
    ASSERT_GT(size, 2u);
    TransversalOptions options;
    options.limits.max_elements = size;
    EXPECT_TRUE(transversals(segments, options));
    options.limits.max_elements = size - 1;
    EXPECT_EQ(transversals(segments, options).error().code, Errc::limit_reached);
    options.limits = {};
    options.limits.stop = [] { return true; };
    EXPECT_EQ(transversals(segments, options).error().code, Errc::cancelled);
    double last = 0;
    options.limits = {};
    options.limits.progress = [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
    };
    EXPECT_TRUE(transversals(segments, options));
    EXPECT_GT(last, 0.9);
}

}  // namespace
}  // namespace sightline
