// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {

void add_path(DrawList& list, std::span<const RationalPoint2> points, const Interval& length) {
    if (points.empty()) return;
    Polyline line;
    for (const RationalPoint2& p : points) line.points.push_back(detail::position(p));
    const Position from = line.points.front();
    const Position to = line.points.back();

    Layer turns{
        .name = "turns",
        .legend = "turns of the path",
        .count = points.size() > 2 ? points.size() - 2 : 0,
        .order = PaintOrder::paths,
        .style = {
            .colour = Palette::vermilion, .width = 0, .marker = Marker::disc, .marker_size = 6}};
    if (turns.count > 0) turns.points.assign(line.points.begin() + 1, line.points.end() - 1);
    list.add({.name = "path",
              .legend = fmt::format("shortest path, length {:.6g}", length.approx_middle()),
              .order = PaintOrder::paths,
              .style = {.colour = Palette::vermilion, .width = 3},
              .polylines = {std::move(line)}});
    if (turns.count > 0) list.add(std::move(turns));
    list.add(
        {.name = "from",
         .legend = "from",
         .order = PaintOrder::marks,
         .style = {.colour = {0, 110, 80}, .width = 0, .marker = Marker::disc, .marker_size = 11},
         .points = {from},
         .labels = {{from, "from"}}});
    list.add({.name = "to",
              .legend = "to",
              .order = PaintOrder::marks,
              .style = {.colour = {130, 40, 110},
                        .width = 0,
                        .marker = Marker::square,
                        .marker_size = 11},
              .points = {to},
              .labels = {{to, "to"}}});
}

DrawList draw(const Scene2& scene, const ShortestPath& path, const DrawOptions& options) {
    DrawList list = detail::begin(scene, options, path.points);
    add_path(list, path.points, path.length);
    return list;
}

}  // namespace sightline::viz
