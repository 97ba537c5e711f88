// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random points that are hard: on small grids, nearly collinear, huge, tiny and denormal.

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "sightline/geom/line2.hpp"
#include "sightline/geom/point.hpp"

namespace sightline::testing {

/// Coordinates of very different kinds; equal and collinear ones are frequent.
inline rc::Gen<double> coordinates() {
    const auto small = rc::gen::map(rc::gen::inRange(-3, 4), [](int i) { return double(i); });
    const auto tenths = rc::gen::map(rc::gen::inRange(-30, 31), [](int i) { return i / 10.0; });
    const auto denormal =
        rc::gen::map(rc::gen::inRange(-9, 10), [](int i) { return i * 0x1p-1074; });
    const auto any = rc::gen::map(rc::gen::arbitrary<std::int64_t>(),
                                  [](std::int64_t i) { return std::ldexp(double(i), -63); });
    const auto scaled = rc::gen::map(rc::gen::pair(any, rc::gen::inRange(-1020, 1020)),
                                     [](const auto& p) { return std::ldexp(p.first, p.second); });
    return rc::gen::weightedOneOf<double>(
        {{8, small}, {4, tenths}, {1, denormal}, {4, any}, {1, scaled}});
}

/// Points whose sums and small multiples are exact; of the whole grid from the first test on.
inline rc::Gen<Point2> grid_points(int n = 4) {
    const auto coordinate = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-n, n + 1));
    return rc::gen::map(rc::gen::pair(coordinate, coordinate),
                        [](const auto& p) { return Point2{double(p.first), double(p.second)}; });
}

/// A double moved by some units in the last place.
inline double nudged(double x, int ulps) {
    const double goal = std::copysign(std::numeric_limits<double>::max(), ulps);
    for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, goal);
    return x;
}

/// Seeded triples near a common line at every scale of doubles, with one-ulp neighbourhoods.
/// Calls test(a, b, c).
template <typename Test>
void for_hard_triples(std::uint64_t seed, int rounds, const Test& test) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double scales[] = {1,     1e8,    1e-8,      1e150,     1e-150,
                             1e300, 1e-300, 0x1p-1060, 0x1p-1070, 0x1p1023};
    const auto finite = [](const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    for (const double scale : scales) {
        for (int i = 0; i < rounds; ++i) {
            const Point2 a{scale * unit(random), scale * unit(random)};
            const Point2 b{scale * unit(random), scale * unit(random)};
            const double t = 2 * unit(random);
            const Point2 on{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            const Point2 middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
            const Point2 mixed{unit(random), scale * unit(random)};
            for (const Point2& c : {on, middle, mixed}) {
                for (const int dx : {-1, 0, 1}) {
                    const Point2 d{nudged(c.x, dx), nudged(c.y, dx * (i % 3 - 1))};
                    if (finite(d)) test(a, b, d);
                }
            }
        }
    }
}

}  // namespace sightline::testing

namespace rc {

template <>
struct Arbitrary<sightline::Point2> {
    static Gen<sightline::Point2> arbitrary() {
        using sightline::Point2;
        const auto free =
            gen::build<Point2>(gen::set(&Point2::x, sightline::testing::coordinates()),
                               gen::set(&Point2::y, sightline::testing::coordinates()));
        return gen::weightedOneOf<Point2>({{2, sightline::testing::grid_points()}, {1, free}});
    }
};

}  // namespace rc
