// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "sightline/viz/draw.hpp"
#include "viz/build.hpp"

namespace sightline::viz {
namespace {

/// The border of a box, and where rays from a point in the box reach it.
class Border {
public:
    Border(const Box& box, const Position& from) : box_(box), from_(from) {}

    /// Where the ray from the viewpoint in this direction leaves the box.
    [[nodiscard]] Position exit(const RationalPoint2& direction) const {
        // Directions matter by ratio only; scaled, they fit into doubles.
        const Rational size =
            std::max(direction.x.sign() == Sign::negative ? -direction.x : direction.x,
                     direction.y.sign() == Sign::negative ? -direction.y : direction.y);
        const double dx = (direction.x / size).approx_double();
        const double dy = (direction.y / size).approx_double();
        const double tx = reach(dx, from_.x, box_.low.x, box_.high.x);
        const double ty = reach(dy, from_.y, box_.low.y, box_.high.y);
        if (tx < ty) return {dx > 0 ? box_.high.x : box_.low.x, inside_y(from_.y + tx * dy), 0};
        return {inside_x(from_.x + ty * dx), dy > 0 ? box_.high.y : box_.low.y, 0};
    }

    /// The corners passed on the counter-clockwise way along the border from a to b.
    [[nodiscard]] std::vector<Position> corners_between(const Position& a,
                                                        const Position& b) const {
        const Position corners[] = {{box_.high.x, box_.low.y, 0},
                                    {box_.high.x, box_.high.y, 0},
                                    {box_.low.x, box_.high.y, 0},
                                    {box_.low.x, box_.low.y, 0}};
        const double start = along(a);
        double stop = along(b);
        if (stop <= start) stop += 4;
        std::vector<Position> passed;
        for (int corner = 1; corner <= 8; ++corner) {
            if (start < corner && corner < stop) passed.push_back(corners[(corner - 1) % 4]);
        }
        return passed;
    }

private:
    static double reach(double step, double from, double low, double high) {
        if (step == 0) return std::numeric_limits<double>::infinity();
        return ((step > 0 ? high : low) - from) / step;
    }
    [[nodiscard]] double inside_x(double x) const { return std::clamp(x, box_.low.x, box_.high.x); }
    [[nodiscard]] double inside_y(double y) const { return std::clamp(y, box_.low.y, box_.high.y); }

    /// Length of the way from the lower left corner counter-clockwise to p on the border, a side
    /// being 1.
    [[nodiscard]] double along(const Position& p) const {
        const double x = (p.x - box_.low.x) / (box_.high.x - box_.low.x);
        const double y = (p.y - box_.low.y) / (box_.high.y - box_.low.y);
        if (p.x == box_.high.x && p.y != box_.low.y) return 1 + y;
        if (p.y == box_.high.y) return 3 - x;
        if (p.x == box_.low.x && p.y != box_.low.y) return 4 - y;
        return x;
    }

    Box box_;
    Position from_;
};

Position place(const Border& border, const ViewPoint& p) {
    return p.at_infinity ? border.exit(p.coordinates) : detail::position(p.coordinates);
}

/// The area seen, and its boundary without the pieces along the border.
struct BoundedView {
    Polygon area;
    std::vector<Polyline> boundary;
};

BoundedView bounded(const Border& border, std::span<const ViewPoint> ring) {
    BoundedView result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const ViewPoint& next = ring[(i + 1) % ring.size()];
        const Position here = place(border, ring[i]);
        const Position there = place(border, next);
        result.area.outer.push_back(here);
        if (ring[i].at_infinity && next.at_infinity) {
            const auto corners = border.corners_between(here, there);
            result.area.outer.insert(result.area.outer.end(), corners.begin(), corners.end());
        } else if (!result.boundary.empty() && result.boundary.back().points.back() == here) {
            result.boundary.back().points.push_back(there);
        } else {
            result.boundary.push_back({{here, there}, 0});
        }
    }
    return result;
}

}  // namespace

void add_view(DrawList& list, const RationalPoint2& from, std::span<const ViewPoint> ring,
              std::span<const NeedlePoints> needles) {
    const Position eye = detail::position(from);
    Box box = list.view.is_empty() ? bounds(list) : list.view;
    for (const RationalPoint2& p : detail::places_of(from, ring)) box.add(detail::position(p));
    if (list.view.is_empty()) list.view = box = window_around(box);
    const Border border(box, eye);
    BoundedView seen = bounded(border, ring);
    list.add({.name = "view",
              .legend = "seen from the viewpoint",
              .order = PaintOrder::views,
              .style = {.width = 0, .fill = Palette::yellow, .fill_opacity = 0.5},
              .polygons = {std::move(seen.area)}});
    list.add({.name = "view boundary",
              .order = PaintOrder::views,
              .style = {.colour = {150, 120, 0}, .width = 1},
              .polylines = std::move(seen.boundary)});
    if (!needles.empty()) {
        Layer layer{.name = "needles",
                    .legend = "needles",
                    .count = needles.size(),
                    .order = PaintOrder::paths,
                    .style = {.colour = Palette::vermilion, .width = 2}};
        for (const auto& [near, far] : needles) {
            layer.segments.push_back(place(border, near));
            layer.segments.push_back(place(border, far));
        }
        list.add(std::move(layer));
    }
    list.add(
        {.name = "viewpoint",
         .legend = "viewpoint",
         .order = PaintOrder::marks,
         .style = {.colour = Palette::black, .width = 0, .marker = Marker::disc, .marker_size = 9},
         .points = {eye}});
}

}  // namespace sightline::viz
