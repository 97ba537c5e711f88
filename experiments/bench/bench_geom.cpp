// SPDX-License-Identifier: GPL-3.0-or-later
// What the orientation of three points costs, by the tier that decides it.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace {

struct Triple {
    Point2 a;
    Point2 b;
    Point2 c;
};

constexpr std::size_t count = 1024;

class Points {
public:
    double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
    double whole(int bits) { return static_cast<double>(random_() >> (64 - bits)); }

    Triple random() { return {{unit(), unit()}, {unit(), unit()}, {unit(), unit()}}; }
    // c = a + k (b - a), all whole.
    Triple collinear(int bits, double scale) {
        const Point2 a{whole(bits), whole(bits)};
        const Point2 d{whole(bits), whole(bits)};
        const double k = 2 + whole(3);
        return {{a.x * scale, a.y * scale},
                {(a.x + d.x) * scale, (a.y + d.y) * scale},
                {(a.x + k * d.x) * scale, (a.y + k * d.y) * scale}};
    }
    Triple nearly_collinear() {
        Triple t = collinear(10, 0x1p-10);
        t.c.y = std::nextafter(t.c.y, 1e9);
        return t;
    }
    // Rounded to doubles from a line through far points: differences need more than 53 bits.
    Triple differences_inexact() {
        const double x = unit();
        return {{x, x}, {1e8 + whole(20), 0}, {0, 0}};
    }

private:
    std::mt19937_64 random_{1};
};

using Maker = Triple (*)(Points&);

void run(benchmark::State& state, Maker make, Arithmetic arithmetic) {
    Points points;
    std::vector<Triple> triples;
    for (std::size_t i = 0; i < count; ++i) triples.push_back(make(points));
    Tally tally;
    const Predicates2 counted(arithmetic, &tally);
    for (const Triple& t : triples) benchmark::DoNotOptimize(counted.orientation(t.a, t.b, t.c));
    const Predicates2 predicates(arithmetic);
    for (auto _ : state) {
        for (const Triple& t : triples) {
            benchmark::DoNotOptimize(predicates.orientation(t.a, t.b, t.c));
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
    const TierCounts& tiers = tally[Predicate::orientation2];
    const double calls = static_cast<double>(tiers.calls);
    state.counters["filter"] = static_cast<double>(tiers.filter) / calls;
    state.counters["interval"] = static_cast<double>(tiers.interval) / calls;
    state.counters["exact"] = static_cast<double>(tiers.exact) / calls;
}

struct Kind {
    const char* name;
    Maker make;
};

const Kind kinds[] = {
    {"random", [](Points& p) { return p.random(); }},
    {"collinear_10_bits", [](Points& p) { return p.collinear(10, 1); }},
    {"collinear_45_bits", [](Points& p) { return p.collinear(45, 1); }},
    {"one_ulp_off", [](Points& p) { return p.nearly_collinear(); }},
    {"inexact_differences", [](Points& p) { return p.differences_inexact(); }},
    {"collinear_1e-150", [](Points& p) { return p.collinear(20, 0x1p-518); }},
    {"collinear_denormal", [](Points& p) { return p.collinear(20, 0x1p-1074); }},
};

struct Policy {
    const char* name;
    Arithmetic arithmetic;
};

const Policy policies[] = {{"filtered", Arithmetic::filtered},
                           {"exact", Arithmetic::exact},
                           {"interval", Arithmetic::interval},
                           {"double", Arithmetic::double_}};

[[maybe_unused]] const bool registered = [] {
    for (const Kind& kind : kinds) {
        for (const Policy& policy : policies) {
            const std::string name = std::string("orientation/") + kind.name + "/" + policy.name;
            benchmark::RegisterBenchmark(name.c_str(), [kind, policy](benchmark::State& state) {
                run(state, kind.make, policy.arithmetic);
            });
        }
    }
    return true;
}();

}  // namespace
}  // namespace sightline
