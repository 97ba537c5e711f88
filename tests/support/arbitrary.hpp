// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid scenes on small integer grids, where everything degenerate is common: by seed, and for
// RapidCheck.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "sightline/scene/scene2.hpp"
#include "support/scenes.hpp"

namespace sightline::testing {

/// What random scenes are made of.
struct SceneRecipe {
    int grid = 4;  ///< coordinates are 0 … grid
    int proposals =
        5;  ///< elements that are tried; those that would make the scene invalid are dropped
    bool world = false;
    bool walls = true;
    bool points = true;
};

/// Adds the element unless the scene would become invalid.
inline bool add_if_valid(SceneInput2& input, const SceneElement2& element) {
    input.elements.push_back(element);
    if (Scene2::make(input)) return true;
    input.elements.pop_back();
    return false;
}

/// Adds a hole to the first polygon unless the scene would become invalid.
inline bool add_hole_if_valid(SceneInput2& input, const Ring2& hole) {
    auto& holes = std::get<Polygon2>(input.elements.front()).holes;
    holes.push_back(hole);
    if (Scene2::make(input)) return true;
    holes.pop_back();
    return false;
}

/// Draws scenes: the same seed and recipe give the same scene on every machine.
class SceneLottery {
public:
    SceneLottery(std::uint64_t seed, const SceneRecipe& recipe) : bits_(seed), recipe_(recipe) {}

    [[nodiscard]] SceneInput2 draw() {
        SceneInput2 input;
        const double size = recipe_.grid;
        if (recipe_.world) {
            input.world = true;
            const Polygon2 square{{{0, 0}, {size, 0}, {size, size}, {0, size}}, {}};
            if (below(2) == 0 || !add_if_valid(input, Polygon2{ring(), {}})) {
                input.elements.assign(1, square);
            }
        }
        for (int i = 0; i < recipe_.proposals; ++i) propose(input);
        if (input.elements.empty())
            input.elements.emplace_back(Polygon2{{{0, 0}, {1, 0}, {0, 1}}, {}});
        return input;
    }

private:
    int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
    Point2 point() {
        const int x = below(recipe_.grid + 1);
        const int y = below(recipe_.grid + 1);
        return {static_cast<double>(x), static_cast<double>(y)};
    }
    Ring2 ring() {
        const int kind = below(4);
        if (kind == 0) return box();
        Ring2 result;
        for (int i = 0; i < 2 + kind + below(2); ++i) result.push_back(point());
        if (result.front() == result.back()) result.pop_back();  // scenes drop it, too
        return result;
    }
    Ring2 box() {
        const Point2 a = point();
        const Point2 b{a.x + 1 + below(2), a.y + 1 + below(2)};
        return {a, {b.x, a.y}, b, {a.x, b.y}};
    }
    void propose(SceneInput2& input) {
        const int kind = below(8);
        if (kind == 0 && recipe_.points) {
            add_if_valid(input, point());
        } else if (kind <= 2 && recipe_.walls) {
            Polyline2 wall;
            for (int i = 0; i < 2 + below(3); ++i) wall.points.push_back(point());
            add_if_valid(input, wall);
        } else if (kind <= 5 && recipe_.world) {
            add_hole_if_valid(input, ring());
        } else if (kind == 6 && !input.elements.empty() &&
                   std::holds_alternative<Polygon2>(input.elements.front())) {
            add_hole_if_valid(input, ring());
        } else {
            add_if_valid(input, Polygon2{ring(), {}});
        }
    }

    std::mt19937_64 bits_;
    SceneRecipe recipe_;
};

/// The mixture that differential tests use: grids, worlds, walls and points in turn.
inline SceneInput2 random_scene(std::uint64_t seed) {
    SceneRecipe recipe;
    recipe.grid = 2 + static_cast<int>(seed % 5);
    recipe.proposals = 2 + static_cast<int>(seed / 5 % 6);
    recipe.world = seed % 3 == 0;
    recipe.walls = seed % 2 == 0;
    recipe.points = seed % 7 < 4;
    return SceneLottery(seed, recipe).draw();
}

/// Points, crossing walls and triangles whose coordinates are of any size that a double
/// has: one point, then so many elements where they fit.
inline SceneInput2 scene_of_all_sizes(std::uint64_t seed, int least, int greatest, int elements) {
    std::mt19937_64 bits(seed);
    const auto below = [&](int n) {
        return static_cast<int>(bits() % static_cast<std::uint64_t>(n));
    };
    const auto coordinate = [&] {
        if (below(6) == 0) return 0.0;
        const double size = std::ldexp(1 + below(4) / 4.0, least + below(greatest - least));
        return below(2) == 0 ? size : -size;
    };
    const auto point = [&] {
        const double x = coordinate();
        return Point2{x, below(4) == 0 ? x : coordinate()};
    };
    SceneInput2 input;
    input.elements.emplace_back(point());
    for (int i = 0; i < elements; ++i) {
        const int kind = below(3);
        if (kind == 0)
            add_if_valid(input, point());
        else if (kind == 1)
            add_if_valid(input, Polyline2{{point(), point()}});
        else
            add_if_valid(input, Polygon2{{point(), point(), point()}, {}});
    }
    return input;
}

}  // namespace sightline::testing

namespace rc {

/// Points of a small grid: three on a line, or two at one place, are common.
template <>
struct Arbitrary<sightline::Point2> {
    static Gen<sightline::Point2> arbitrary() {
        return gen::map(gen::pair(gen::inRange(0, 6), gen::inRange(0, 6)), [](std::pair<int, int>
                                                                                  xy) {
            return sightline::Point2{static_cast<double>(xy.first), static_cast<double>(xy.second)};
        });
    }
};

/// Valid scenes of triangles, walls and points, of which RapidCheck can leave out elements.
template <>
struct Arbitrary<sightline::SceneInput2> {
    static Gen<sightline::SceneInput2> arbitrary() {
        using sightline::Point2;
        const auto proposals = gen::container<std::vector<std::pair<int, std::vector<Point2>>>>(
            gen::pair(gen::inRange(0, 4),
                      gen::container<std::vector<Point2>>(3, gen::arbitrary<Point2>())));
        return gen::map(proposals, [](const auto& list) {
            sightline::SceneInput2 input;
            for (const auto& [kind, points] : list) {
                if (kind == 0) {
                    sightline::testing::add_if_valid(input, sightline::Polyline2{points});
                } else if (kind == 1) {
                    sightline::testing::add_if_valid(input, points.front());
                } else {
                    sightline::testing::add_if_valid(input, sightline::Polygon2{points, {}});
                }
            }
            if (input.elements.empty()) input.elements.emplace_back(Point2{0, 0});
            return input;
        });
    }
};

}  // namespace rc

namespace sightline {

/// How RapidCheck shows a scene.
inline void showValue(const SceneInput2& input, std::ostream& out) {
    out << testing::to_text(input);
}

}  // namespace sightline
