// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

/// A body with a hole, a segment across it, a path, and two labelled points.
inline DrawList small_picture() {
    DrawList list;
    list.title = "A body & its <hole>";
    list.view = {{0, 0, 0}, {10, 10, 0}};
    list.add({.name = "bodies",
              .legend = "bodies",
              .count = 1,
              .order = 1,
              .style = {.colour = Palette::outline, .fill = Palette::solid, .fill_opacity = 1},
              .polygons = {{{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {{{4, 4}, {6, 4}, {5, 6}}}, 7}}});
    list.add({.name = "edges",
              .legend = "sightlines",
              .count = 2,
              .order = 2,
              .style = {.colour = Palette::blue, .width = 0.5, .opacity = 0.5},
              .segments = {{1, 1}, {9, 1}, {9, 1}, {9, 9}}});
    list.add({.name = "path",
              .legend = "path",
              .order = 3,
              .style = {.colour = Palette::vermilion, .width = 3},
              .polylines = {{{{1, 9}, {1, 1}, {5, 1}}, 0}}});
    list.add(
        {.name = "ends",
         .legend = "ends",
         .order = 4,
         .style = {.colour = Palette::green, .width = 0, .marker = Marker::disc, .marker_size = 10},
         .points = {{1, 9}, {5, 1}},
         .labels = {{{1, 9}, "from"}, {{5, 1}, "to"}}});
    return list;
}

}  // namespace sightline::viz
