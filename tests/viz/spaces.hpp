// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

/// The faces and edges of a box, without a shared layer: faces "<name>", edges "<name> edges".
inline void add_box(DrawList& list, const std::string& name, Position low, Position high,
                    Colour colour, double opacity) {
    const auto corner = [&](int i) {
        return Position{(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                        (i & 4) != 0 ? high.z : low.z};
    };
    Layer faces{.name = name,
                .legend = name,
                .order = 1,
                .style = {.width = 0, .fill = colour, .fill_opacity = opacity}};
    const int rings[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::uint32_t id = 0;
    for (const auto& ring : rings) {
        Polygon polygon{{}, {}, id++};
        for (const int i : ring) polygon.outer.push_back(corner(i));
        faces.polygons.push_back(std::move(polygon));
    }
    Layer edges{
        .name = name + " edges", .order = 2, .style = {.colour = Palette::outline, .width = 1.6}};
    for (int i = 0; i < 8; ++i) {
        for (const int bit : {1, 2, 4}) {
            if ((i & bit) == 0)
                edges.segments.insert(edges.segments.end(), {corner(i), corner(i | bit)});
        }
    }
    list.add(std::move(faces));
    list.add(std::move(edges));
}

/// Seen from above: a red box over a blue one, and over both a sheet of glass that ends at x = 0; a
/// line below everything on the left, above everything on the right, with a ball at its end.
inline DrawList small_space() {
    DrawList list;
    list.title = "Boxes";
    list.scale_bar = false;
    list.camera = Camera{.from = {0, 0, 1}, .up = {0, 1, 0}};
    list.view = {{-10, -10, -5}, {10, 10, 5}};
    add_box(list, "red box", {-4, -4, 0}, {4, 4, 1}, Palette::vermilion, 1);
    add_box(list, "blue box", {-8, -2, -3}, {8, 2, -2}, Palette::blue, 1);
    list.add({.name = "glass",
              .legend = "glass",
              .order = 5,
              .style = {.width = 0, .fill = Palette::green, .fill_opacity = 0.5},
              .polygons = {{{{-9, -9, 3}, {0, -9, 3}, {0, 9, 3}, {-9, 9, 3}}, {}, 0}}});
    list.add({.name = "line",
              .legend = "line",
              .order = 6,
              .style = {.colour = Palette::black, .width = 5},
              .segments = {{-9, 1, -4}, {0, 1, -4}, {0, 1, 4}, {9, 1, 4}}});
    list.add({.name = "end",
              .order = 7,
              .style = {.colour = Palette::purple,
                        .width = 0,
                        .marker = Marker::disc,
                        .marker_size = 20},
              .points = {{9, 1, 4}},
              .labels = {{{9, 1, 4}, "end"}}});
    return list;
}

}  // namespace sightline::viz
