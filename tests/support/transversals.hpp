// SPDX-License-Identifier: GPL-3.0-or-later
// Transversals in tests: elements written down or drawn by lot, and results compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "sightline/event/transversals.hpp"

namespace sightline::testing {

using Elements = std::vector<TransversalElement>;

/// "segment 0 0 0, 1 0 0 | line 0 0 0, 1/2 0 0 | point 1 2 3"
inline Elements elements(const std::string& text) {
    Elements result;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, '|');) {
        std::replace(part.begin(), part.end(), ',', ' ');
        std::istringstream words(part);
        std::string kind;
        words >> kind;
        std::vector<Rational> x;
        for (std::string word; words >> word;) x.push_back(Rational::parse(word).value());
        const RationalPoint3 a{x.at(0), x.at(1), x.at(2)};
        if (kind == "point") {
            result.push_back(TransversalElement::point(a));
            continue;
        }
        const RationalPoint3 b{x.at(3), x.at(4), x.at(5)};
        result.push_back(kind == "line" ? TransversalElement::line(a, b)
                                        : TransversalElement::segment(a, b));
    }
    return result;
}

inline std::string to_string(const Elements& all) {
    std::ostringstream out;
    for (const TransversalElement& e : all) {
        const char* names[] = {"line ", "segment ", "point "};
        out << (&e == all.data() ? "" : " | ") << names[static_cast<int>(e.kind())] << e.source();
        if (e.kind() != TransversalElement::Kind::point) out << ' ' << e.target();
    }
    return out.str();
}

inline std::string to_string(const Transversals& all) {
    std::ostringstream out;
    for (const TransversalLine& l : all.lines) {
        out << "  line " << l.line << " root " << static_cast<int>(l.root) << '\n';
    }
    for (const TransversalComponent& c : all.components) out << "  " << c << '\n';
    return out.str();
}

/// Four elements on a grid, where dependence is common. `kinds` 1: segments only; more: also points
/// and lines.
class ElementLottery {
public:
    explicit ElementLottery(std::uint64_t seed, int grid, int kinds = 1)
        : bits_(seed), grid_(grid), kinds_(kinds) {}

    [[nodiscard]] Elements draw(int count = 4) {
        Elements result;
        while (static_cast<int>(result.size()) < count) {
            const RationalPoint3 a = point(), b = point();
            const int kind = kinds_ == 1 ? 0 : below(8);
            if (kind == 7) {
                result.push_back(TransversalElement::point(a));
            } else if (kind == 6 && a != b) {
                result.push_back(TransversalElement::line(a, b));
            } else {
                result.push_back(TransversalElement::segment(a, b));
            }
        }
        return result;
    }
    /// On lines x = k of the surface z = xy: all on one regulus, unless they share a line.
    [[nodiscard]] Elements draw_on_paraboloid(int count = 4) {
        Elements result;
        while (static_cast<int>(result.size()) < count) {
            const Rational x = below(grid_), y = below(grid_) - 1, z = y + below(grid_);
            const RationalPoint3 a{x, y, x * y}, b{x, z, x * z};
            const bool is_line = kinds_ > 1 && below(4) == 0 && a != b;
            result.push_back(is_line ? TransversalElement::line(a, b)
                                     : TransversalElement::segment(a, b));
        }
        return result;
    }
    int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }

private:
    RationalPoint3 point() {
        const int x = below(grid_), y = below(grid_), z = below(grid_);
        return {x, y, z};
    }

    std::mt19937_64 bits_;
    int grid_;
    int kinds_;
};

/// Equal but for generators and `through` lines of reguli, which depend on the order of elements;
/// those must then lie in the other's ranges.
inline bool same_component(const TransversalComponent& a, const TransversalComponent& b) {
    if (a.kind != TransversalComponent::Kind::regulus) return a == b;
    if (a.kind != b.kind || a.ranges.size() != b.ranges.size()) return false;
    for (std::size_t i = 0; i < a.ranges.size(); ++i) {
        const TransversalRange &p = a.ranges[i], &q = b.ranges[i];
        if (p.from != q.from || p.to != q.to || p.has_from != q.has_from || p.has_to != q.has_to) {
            return false;
        }
        if (!is_in_family(b, to_surd(p.through)) || !is_in_family(a, to_surd(q.through))) {
            return false;
        }
    }
    return true;
}

/// Whether the results are equal; if not, both are shown.
inline ::testing::AssertionResult same_transversals(const Transversals& actual,
                                                    const Transversals& expected) {
    if (actual.lines == expected.lines &&
        std::ranges::equal(actual.components, expected.components, same_component)) {
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "actual\n"
                                         << to_string(actual) << "expected\n"
                                         << to_string(expected);
}

}  // namespace sightline::testing
