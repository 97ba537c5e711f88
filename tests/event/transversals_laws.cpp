// SPDX-License-Identifier: GPL-3.0-or-later
// The numbered laws of transversals(), and every case of a very small world.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "sightline/event/transversals.hpp"
#include "sightline/reference/transversals.hpp"
#include "support/transversals.hpp"

namespace sightline {
namespace {

using testing::ElementLottery;
using testing::Elements;
using testing::same_transversals;

using Map = std::function<RationalPoint3(const RationalPoint3&)>;

TransversalElement mapped(const TransversalElement& e, const Map& f) {
    switch (e.kind()) {
        case TransversalElement::Kind::line:
            return TransversalElement::line(f(e.source()), f(e.target()));
        case TransversalElement::Kind::segment:
            return TransversalElement::segment(f(e.source()), f(e.target()));
        case TransversalElement::Kind::point:
            break;
    }
    return TransversalElement::point(f(e.source()));
}

Elements mapped(const Elements& all, const Map& f) {
    Elements result;
    for (const auto& e : all) result.push_back(mapped(e, f));
    return result;
}

// What must be equal after a change of coordinates: kinds, and how many lines of which kind.
std::map<std::string, std::size_t> shape(const Transversals& t) {
    std::map<std::string, std::size_t> counts;
    counts["lines"] = t.lines.size();
    for (const TransversalLine& l : t.lines) {
        const auto x = l.line.coordinates();
        const bool is_rational = std::ranges::all_of(x, &Surd::is_rational);
        counts["rational lines"] += is_rational ? 1 : 0;
    }
    for (const auto& c : t.components) {
        const std::string name = name_of(c.kind);
        counts[name] += 1;
        counts[name + " ranges"] += c.ranges.size();
        counts[name + " extremal"] += c.extremal.size();
    }
    return counts;
}

Elements draw(int seed) {
    ElementLottery lottery(static_cast<std::uint64_t>(seed), 2 + seed % 4, 1 + seed % 3);
    return seed % 5 == 0 ? lottery.draw_on_paraboloid() : lottery.draw();
}

TEST(TransversalsLaw1, PermutingChangesNothing) {
    for (int seed = 0; seed < 150; ++seed) {
        const Elements four = draw(seed);
        const Transversals expected = transversals(four);
        Elements other = four;
        for (int i = 0; i < 4; ++i) {
            std::rotate(other.begin(), other.begin() + 1, other.end());
            if (i % 2 == 0) std::swap(other[0], other[2]);
            for (TransversalElement& e : other) {
                if (i == 1 && e.kind() == TransversalElement::Kind::segment) {
                    e = TransversalElement::segment(e.target(), e.source());
                }
            }
            ASSERT_TRUE(same_transversals(transversals(other), expected))
                << testing::to_string(four);
        }
    }
}

TEST(TransversalsLaw2, MovingScalingAndMirroringMovesTheLinesAlike) {
    const Rational third = Rational(1) / 3;
    const Map maps[] = {[&](const RationalPoint3& p) {
                            return RationalPoint3{p.x + third, p.y - 5, p.z + 7};
                        },
                        [](const RationalPoint3& p) {
                            return RationalPoint3{p.x * 8, p.y * 8, p.z * 8};
                        },
                        [](const RationalPoint3& p) {
                            return RationalPoint3{p.y, p.x, p.z};
                        },
                        [](const RationalPoint3& p) {
                            return RationalPoint3{-p.x, p.z, p.y};
                        },
                        [](const RationalPoint3& p) {
                            return RationalPoint3{p.x + p.y, p.y - 2 * p.z, p.z};
                        }};
    for (int seed = 0; seed < 100; ++seed) {
        const Elements four = draw(seed);
        const Transversals expected = transversals(four);
        for (const Map& f : maps) {
            const Elements moved = mapped(four, f);
            const Transversals actual = transversals(moved);
            ASSERT_EQ(shape(actual), shape(expected)) << testing::to_string(four);
            ASSERT_TRUE(std::ranges::all_of(actual.lines,
                                            [&](const auto& l) { return verify(moved, l.line); }));
        }
    }
}

TEST(TransversalsLaw3, RepeatingAnElementChangesNothing) {
    for (int seed = 0; seed < 60; ++seed) {
        Elements three = draw(seed);
        three.pop_back();
        Elements four = three;
        four.push_back(three[static_cast<std::size_t>(seed) % 3]);
        ASSERT_TRUE(same_transversals(transversals(four), transversals(three)))
            << testing::to_string(three);
    }
}

TEST(TransversalsLaw4, EveryLineIsCertified) {
    for (int seed = 0; seed < 200; ++seed) {
        const Elements four = draw(seed);
        const Transversals t = transversals(four);
        for (const TransversalLine& l : t.lines) ASSERT_TRUE(verify(four, l.line));
        for (const TransversalComponent& c : t.components) {
            for (const RationalLine3& l : c.extremal) ASSERT_TRUE(verify(four, to_surd(l)));
            for (const TransversalRange& r : c.ranges) {
                ASSERT_TRUE(!r.has_from || verify(four, to_surd(r.from)));
                ASSERT_TRUE(!r.has_to || verify(four, to_surd(r.to)));
                ASSERT_TRUE(verify(four, to_surd(r.through)));
                ASSERT_TRUE(is_in_family(c, to_surd(r.through)));
                ASSERT_TRUE(r.from <= r.to);
            }
        }
    }
}

// The 28 segments between a cube's corners, three of them (every ninth of 3276 sets) with a diagonal.
TEST(TransversalsExhaustive, SegmentsOfACube) {
    Elements all;
    for (int a = 0; a < 8; ++a) {
        for (int b = a + 1; b < 8; ++b) {
            all.push_back(TransversalElement::segment({a & 1, a >> 1 & 1, a >> 2},
                                                      {b & 1, b >> 1 & 1, b >> 2}));
        }
    }
    const auto fixed = TransversalElement::segment({0, 0, 0}, {1, 1, 1});
    int number = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            for (std::size_t k = j + 1; k < all.size(); ++k) {
                if (++number % 9 != 0) continue;
                const Elements four{all[i], all[j], all[k], fixed};
                ASSERT_TRUE(same_transversals(transversals(four), reference::transversals(four)))
                    << testing::to_string(four);
            }
        }
    }
}

}  // namespace
}  // namespace sightline
