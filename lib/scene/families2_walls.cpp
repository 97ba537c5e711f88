// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "scene/families2_detail.hpp"
#include "sightline/scene/families.hpp"

namespace sightline::families {

using namespace detail;

SceneInput2 random_walls(const Walls& parameters, std::uint64_t seed) {
    SIGHTLINE_EXPECT(parameters.count >= 1 && parameters.count <= 1'000'000);
    Rng rng(seed);
    const std::int64_t side = ceil_sqrt(parameters.count);
    const std::int64_t extent = std::max<std::int64_t>(std::int64_t{1} << 20, side * 1024);
    const std::int64_t longest = std::min(extent / side * 3 / 2, extent / 2);
    Placer placer(extent, parameters.count);
    SceneInput2 scene;
    std::int64_t length = longest;
    while (scene.elements.size() < parameters.count) {
        const IntPoint source{rng.between(0, extent), rng.between(0, extent)};
        const IntPoint reach{rng.between(-length, length), rng.between(-length, length)};
        const IntPoint target = source + reach;
        if (reach == IntPoint{}) continue;
        if (parameters.crossing || placer.try_add({source, target})) {
            scene.elements.emplace_back(to_wall(source, target));
            length = longest;
        } else {
            length =
                std::max<std::int64_t>(length * 15 / 16, 16);  // a shorter one fits more easily
        }
    }
    return scene;
}

}  // namespace sightline::families
