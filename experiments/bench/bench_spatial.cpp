// SPDX-License-Identifier: GPL-3.0-or-later
// Shooting rays and testing segments in scenes of space, and CGAL's AABB_tree beside it.
//
// Names: first/<scene>/<rays>/<arithmetic>, sees/…, cgal_epick_first/<scene>/<rays>, …, build/<scene>
// Rays: `random` from random points in random directions; `aimed` at vertices and at points of edges,
// rounded, where a leak would show; `whole` between points of a coarse grid, which graze and touch.
// Counters: cut = share of shots whose line was cut exactly; wrong = share of answers that are not the exact ones.

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "common/aabb_tree_cgal.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/spatial/box3.hpp"
#include "sightline/spatial/shooting.hpp"

namespace sightline {
namespace {

using benchmark::State;

constexpr std::size_t ray_count = 1000;

SceneInput3 input_of(const std::string& name) {
    if (name == "polytopes_60") return families::random_polytopes({.count = 60}, 1);
    if (name == "tetrahedra_4000") return families::random_tetrahedra({.count = 4000}, 1);
    if (name == "turned_grid_8") return families::turned_grid3({8, 8, 8}, 1);
    return families::grid3({8, 8, 8}, 1);
}

const Scene3& scene_of(const std::string& name) {
    static std::map<std::string, std::unique_ptr<const Scene3>> scenes;
    auto& scene = scenes[name];
    if (!scene) scene = std::make_unique<const Scene3>(Scene3::make(input_of(name)).value());
    return *scene;
}

struct Shot {
    Point3 p;
    Point3 q;
};

/// Shots from points outside of all solids.
std::vector<Shot> shots_of(const Scene3& scene, const std::string& kind) {
    Box3 box;
    for (const Point3& v : scene.vertices()) box.include(v);
    std::mt19937_64 random(1);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    const auto between = [&](double low, double high) { return low + unit() * (high - low); };
    const auto point = [&] {
        Point3 p{between(box.low[0], box.high[0]), between(box.low[1], box.high[1]),
                 between(box.low[2], box.high[2])};
        if (kind != "whole") return p;
        const double step = (box.high[0] - box.low[0]) / 32;
        for (double* x : {&p.x, &p.y, &p.z}) *x = std::floor(*x / step) * step;
        return p;
    };
    const auto aim = [&]() -> Point3 {
        if (kind != "aimed") return point();
        const Edge3& e = scene.edges()[random() % scene.edges().size()];
        const Point3& a = scene[e.source];
        const Point3& b = scene[e.target];
        const double t = static_cast<double>(random() % 5) / 4;
        return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    };
    SegmentShooter shooter(scene);
    std::vector<Shot> shots;
    while (shots.size() < ray_count) {
        const Shot shot{point(), aim()};
        if (shot.p == shot.q) continue;
        // In the interior of a solid everything is blocked, in all directions.
        const Point3 near{shot.p.x + 1e-3, shot.p.y + 2e-3, shot.p.z + 3e-3};
        if (!shooter.is_free(shot.p, near)) continue;
        shots.push_back(shot);
    }
    return shots;
}

double share(std::uint64_t part, std::uint64_t all) {
    return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
}

void first(State& state, const std::string& name, const std::string& rays, Arithmetic arithmetic) {
    const Scene3& scene = scene_of(name);
    const auto shots = shots_of(scene, rays);
    SegmentShooter shooter(scene, arithmetic);
    for (auto _ : state) {
        for (const Shot& s : shots) benchmark::DoNotOptimize(shooter.first_faces(s.p, s.q));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shots.size()));
    state.counters["cut"] = share(shooter.counts().cut_lines, shooter.counts().shots);
    if (arithmetic == Arithmetic::exact) return;
    SegmentShooter exact(scene, Arithmetic::exact);
    std::uint64_t wrong = 0;
    for (const Shot& s : shots) {
        wrong += shooter.first_faces(s.p, s.q) != exact.first_faces(s.p, s.q) ? 1 : 0;
    }
    state.counters["wrong"] = share(wrong, shots.size());
}

void sees(State& state, const std::string& name, const std::string& rays, Arithmetic arithmetic) {
    const Scene3& scene = scene_of(name);
    const auto shots = shots_of(scene, rays);
    SegmentShooter shooter(scene, arithmetic);
    for (auto _ : state) {
        for (const Shot& s : shots) benchmark::DoNotOptimize(shooter.sees(s.p, s.q));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shots.size()));
    state.counters["cut"] = share(shooter.counts().cut_lines, shooter.counts().shots);
}

using MakeTree = std::unique_ptr<experiments::CgalTree> (*)(const Scene3&);

void cgal_first(State& state, const std::string& name, const std::string& rays, MakeTree make) {
    const Scene3& scene = scene_of(name);
    const auto shots = shots_of(scene, rays);
    const auto tree = make(scene);
    for (auto _ : state) {
        for (const Shot& s : shots) benchmark::DoNotOptimize(tree->first(s.p, s.q));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shots.size()));
}

void cgal_sees(State& state, const std::string& name, const std::string& rays, MakeTree make) {
    const Scene3& scene = scene_of(name);
    const auto shots = shots_of(scene, rays);
    const auto tree = make(scene);
    for (auto _ : state) {
        for (const Shot& s : shots) benchmark::DoNotOptimize(tree->meets(s.p, s.q));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shots.size()));
}

void build(State& state, const std::string& name) {
    const Scene3& scene = scene_of(name);
    for (auto _ : state) {
        const SegmentShooter shooter(scene);
        benchmark::DoNotOptimize(&shooter);
    }
    state.counters["triangles"] = static_cast<double>(scene.triangles().size());
}

struct Policy {
    const char* name;
    Arithmetic arithmetic;
};

template <typename Function>
void add(const std::string& name, Function function) {
    benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
    const Policy policies[] = {{"filtered", Arithmetic::filtered},
                               {"double", Arithmetic::double_},
                               {"exact", Arithmetic::exact}};
    for (const std::string scene : {"polytopes_60", "tetrahedra_4000", "turned_grid_8", "grid_8"}) {
        add("build/" + scene, [=](State& s) { build(s, scene); });
        for (const std::string rays : {"random", "aimed", "whole"}) {
            if (rays == "whole" && scene != "grid_8") continue;
            const std::string of = "/" + scene + "/" + rays;
            for (const Policy& policy : policies) {
                add("first" + of + "/" + policy.name,
                    [=](State& s) { first(s, scene, rays, policy.arithmetic); });
                add("sees" + of + "/" + policy.name,
                    [=](State& s) { sees(s, scene, rays, policy.arithmetic); });
            }
            add("cgal_epick_first" + of,
                [=](State& s) { cgal_first(s, scene, rays, experiments::cgal_tree_epick); });
            add("cgal_epeck_first" + of,
                [=](State& s) { cgal_first(s, scene, rays, experiments::cgal_tree_epeck); });
            add("cgal_epick_sees" + of,
                [=](State& s) { cgal_sees(s, scene, rays, experiments::cgal_tree_epick); });
            add("cgal_epeck_sees" + of,
                [=](State& s) { cgal_sees(s, scene, rays, experiments::cgal_tree_epeck); });
        }
    }
    return true;
}();

}  // namespace
}  // namespace sightline
