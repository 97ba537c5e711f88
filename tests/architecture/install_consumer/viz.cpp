// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <sstream>

#include "sightline/scene/scene2.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/svg.hpp"

int main() {
    using namespace sightline;
    const auto scene = Scene2::make({.elements = {Polygon2{.outer = {{0, 0}, {2, 0}, {1, 2}}}}});
    if (!scene) return 1;
    std::ostringstream picture;
    viz::write_svg(viz::draw(*scene), picture);
    std::cout << picture.str().size() << " bytes of SVG\n";
    return picture.str().find("</svg>") == std::string::npos ? 1 : 0;
}
