// SPDX-License-Identifier: GPL-3.0-or-later
// What an exact view of space costs, under each arithmetic.

#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "sightline/scene/families3.hpp"
#include "sightline/view/view3.hpp"

namespace sightline {
namespace {

Scene3 scene_of(const std::string& family, const std::vector<std::string>& parameters) {
    return *Scene3::make(*families::generate3(family, parameters, 1));
}

// Points of the scene's box, and a little around it, from which there is a view.
std::vector<Point3> viewpoints(const Scene3& scene, const PointVisibility3& visibility) {
    Point3 low = scene.vertices().front();
    Point3 high = low;
    for (const Point3& p : scene.vertices()) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    std::mt19937_64 random(1);
    const auto between = [&](double a, double b) {
        return a + (b - a) * (static_cast<double>(random() >> 11U) * 0x1p-53);
    };
    std::vector<Point3> points;
    while (points.size() < 16) {
        const Point3 p{between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
        if (visibility.from(p)) points.push_back(p);
    }
    return points;
}

void view_from_points(benchmark::State& state, const std::string& family,
                      const std::vector<std::string>& parameters, Arithmetic arithmetic) {
    const Scene3 scene = scene_of(family, parameters);
    const PointVisibility3 visibility(scene);
    const std::vector<Point3> points = viewpoints(scene, visibility);
    Tally tally;
    std::size_t next = 0;
    std::size_t pieces = 0;
    std::size_t views = 0;
    for (auto _ : state) {
        const auto view = visibility.from(points[next++ % points.size()],
                                          {.arithmetic = arithmetic, .tally = &tally});
        // Plain doubles may contradict themselves, and then there is no view.
        if (view) pieces += view->map.pieces.size();
        ++views;
    }
    state.counters["faces"] = static_cast<double>(scene.faces().size());
    state.counters["pieces"] = static_cast<double>(pieces) / static_cast<double>(views);
    const TierCounts& counts = tally[Predicate::image_orientation3];
    state.counters["calls"] = static_cast<double>(counts.calls) / static_cast<double>(views);
    state.counters["exact"] = static_cast<double>(counts.exact) / static_cast<double>(views);
}

void register_all() {
    struct Case {
        const char* name;
        const char* family;
        std::vector<std::string> parameters;
    };
    const std::vector<Case> cases{{"room", "room", {"1500"}},
                                  {"polytopes", "polytopes", {"60"}},
                                  {"tetrahedra", "tetrahedra", {"300"}},
                                  {"grid", "grid3", {"6", "6", "6"}},
                                  {"terrain", "terrain-solid", {}}};
    for (const Case& c : cases) {
        for (const auto& [name, arithmetic] : {std::pair{"filtered", Arithmetic::filtered},
                                               std::pair{"double", Arithmetic::double_}}) {
            benchmark::RegisterBenchmark((std::string("view/") + c.name + "/" + name).c_str(),
                                         view_from_points, std::string(c.family), c.parameters,
                                         arithmetic)
                ->Unit(benchmark::kMillisecond);
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
}  // namespace sightline
