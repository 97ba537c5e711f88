// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random points of space that are hard, as points.hpp has them for the plane.

#include <array>

#include "points.hpp"
#include "sightline/geom/vector3.hpp"

namespace sightline::testing {

/// Points whose sums and small multiples are exact.
inline rc::Gen<Point3> grid_points3(int n = 3) {
    const auto coordinate = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-n, n + 1));
    return rc::gen::map(rc::gen::tuple(coordinate, coordinate, coordinate), [](const auto& p) {
        return Point3{double(std::get<0>(p)), double(std::get<1>(p)), double(std::get<2>(p))};
    });
}

/// Seeded quadruples near a common plane at every scale of doubles, with one-ulp neighbourhoods.
/// Calls test(a, b, c, d).
template <typename Test>
void for_hard_quadruples(std::uint64_t seed, int rounds, const Test& test) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double scales[] = {1, 1e8, 1e-8, 1e100, 1e-100, 1e300, 1e-300, 0x1p-1060, 0x1p1022};
    for (const double scale : scales) {
        const auto point = [&] {
            return Point3{scale * unit(random), scale * unit(random), scale * unit(random)};
        };
        for (int i = 0; i < rounds; ++i) {
            const Point3 a = point(), b = point(), c = point();
            const double s = unit(random), t = unit(random), r = 1 - s - t;
            const auto mix = [&](double x, double y, double z) { return r * x + s * y + t * z; };
            const Point3 in{mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
            const Point3 middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
            for (const Point3& d : {in, middle, Point3{unit(random), in.y, in.z}}) {
                for (const int ulps : {-1, 0, 1}) {
                    test(a, b, c, Point3{nudged(d.x, ulps), d.y, nudged(d.z, ulps * (i % 3 - 1))});
                }
            }
        }
    }
}

/// The eight corners and more: all points of {0, …, n-1}³.
inline std::vector<Point3> grid3(int n) {
    std::vector<Point3> points;
    for (int i = 0; i < n * n * n; ++i) {
        points.push_back({double(i % n), double(i / n % n), double(i / n / n)});
    }
    return points;
}

}  // namespace sightline::testing

namespace rc {

template <>
struct Arbitrary<sightline::Point3> {
    static Gen<sightline::Point3> arbitrary() {
        using sightline::Point3;
        const auto free =
            gen::build<Point3>(gen::set(&Point3::x, sightline::testing::coordinates()),
                               gen::set(&Point3::y, sightline::testing::coordinates()),
                               gen::set(&Point3::z, sightline::testing::coordinates()));
        return gen::weightedOneOf<Point3>({{2, sightline::testing::grid_points3()}, {1, free}});
    }
};

}  // namespace rc
