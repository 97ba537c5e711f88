// SPDX-License-Identifier: GPL-3.0-or-later
// One prepared scene, asked from several threads at once. With std::thread, so that TSan can follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "sightline/planar/visibility_polygon.hpp"
#include "sightline/scene/families.hpp"

namespace sightline {
namespace {

TEST(VisibilityPolygonShared, gives_every_thread_the_same_views) {
    const std::vector<std::string> size{"300"};
    const Scene2 scene = *Scene2::make(*families::generate2("dense", size, 2));
    const PointVisibility2 prepared(scene);
    constexpr int points = 60;
    const auto look = [&prepared] {
        std::vector<std::vector<ViewVertex>> rings;
        for (int i = 0; i < points; ++i) {
            const auto view = prepared.from(Point2{16000.5 * i, 1e6 - 15000.25 * i});
            rings.push_back(view ? view->ring : std::vector<ViewVertex>{});
        }
        return rings;
    };
    std::vector<std::vector<std::vector<ViewVertex>>> seen(3);
    std::vector<std::thread> threads;
    for (auto& rings : seen) threads.emplace_back([&rings, &look] { rings = look(); });
    for (std::thread& thread : threads) thread.join();
    const auto alone = look();
    for (const auto& rings : seen) EXPECT_EQ(rings, alone);
    EXPECT_GT(std::count_if(alone.begin(), alone.end(), [](const auto& r) { return r.size() > 3; }),
              points / 2);
}

}  // namespace
}  // namespace sightline
