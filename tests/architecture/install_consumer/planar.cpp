// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>

#include "sightline/planar/visibility_graph.hpp"
#include "sightline/scene/scene2.hpp"

int main() {
    using namespace sightline;
    // The corner of a third triangle stands on the line through two others, or one ulp above it;
    // the installed library must tell these two scenes apart.
    const auto edges = [](double y) {
        const SceneInput2 input{.elements = {Polygon2{.outer = {{0, 0}, {0.5, 0}, {0.5, 0.5}}},
                                             Polygon2{.outer = {{12, 12}, {12.5, 11}, {13, 12}}},
                                             Polygon2{.outer = {{24, y}, {25, 20}, {26, 21}}}}};
        const auto scene = Scene2::make(input);
        if (!scene) {
            std::cout << scene.error().message << '\n';
            return std::size_t{0};
        }
        return visibility_graph(*scene).edge_count();
    };
    const std::size_t on_line = edges(24);
    const std::size_t above = edges(std::nextafter(24.0, 25.0));
    std::cout << on_line << " edges, " << above << " one ulp above\n";
    return on_line >= 9 && above > on_line ? 0 : 1;
}
