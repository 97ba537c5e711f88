// SPDX-License-Identifier: GPL-3.0-or-later
// Small worlds, all of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::testing {

using GridTriangle = std::array<int, 3>;  // numbers of points of the 3×3 grid, ascending

inline Point2 grid_point(int number) {
    return {static_cast<double>(number % 3), static_cast<double>(number / 3)};
}

/// The 76 triangles with corners on the 3×3 grid.
inline std::vector<GridTriangle> grid_triangles() {
    std::vector<GridTriangle> triangles;
    for (int a = 0; a < 9; ++a) {
        for (int b = a + 1; b < 9; ++b) {
            for (int c = b + 1; c < 9; ++c) {
                const int twice_area =
                    (b % 3 - a % 3) * (c / 3 - a / 3) - (b / 3 - a / 3) * (c % 3 - a % 3);
                if (twice_area != 0) triangles.push_back({a, b, c});
            }
        }
    }
    return triangles;
}

/// Image of a pair of triangles under symmetry s (0 … 7) of the grid, in ascending form.
inline std::array<GridTriangle, 2> symmetric_image(std::array<GridTriangle, 2> pair, int s) {
    for (GridTriangle& triangle : pair) {
        for (int& point : triangle) {
            int x = point % 3;
            int y = point / 3;
            if ((s & 1) != 0) x = 2 - x;
            if ((s & 2) != 0) y = 2 - y;
            if ((s & 4) != 0) std::swap(x, y);
            point = 3 * y + x;
        }
        std::sort(triangle.begin(), triangle.end());
    }
    std::sort(pair.begin(), pair.end());
    return pair;
}

inline SceneInput2 input_of(const std::array<GridTriangle, 2>& pair) {
    SceneInput2 input;
    for (const GridTriangle& t : pair) {
        input.elements.emplace_back(
            Polygon2{{grid_point(t[0]), grid_point(t[1]), grid_point(t[2])}, {}});
    }
    return input;
}

/// All valid scenes of two triangles with corners on the 3×3 grid; up to the grid's symmetries on request.
inline std::vector<SceneInput2> scenes_of_two_triangles(bool up_to_symmetry = false) {
    std::vector<SceneInput2> scenes;
    const std::vector<GridTriangle> triangles = grid_triangles();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = i + 1; j < triangles.size(); ++j) {
            const std::array<GridTriangle, 2> pair{triangles[i], triangles[j]};
            bool is_canonical = true;
            for (int s = 1; s < 8 && up_to_symmetry; ++s)
                is_canonical &= !(symmetric_image(pair, s) < pair);
            if (!is_canonical) continue;
            SceneInput2 input = input_of(pair);
            if (Scene2::make(input)) scenes.push_back(std::move(input));
        }
    }
    return scenes;
}

}  // namespace sightline::testing
