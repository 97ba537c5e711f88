// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <span>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace sightline::viz {
namespace {

/// Differences and sums of two coordinates within this limit are finite.
constexpr double largest_drawn = 0x1p1020;
constexpr double margin = 0.05;
constexpr double largest_aspect = 3;

void add_all(Box& box, std::span<const Position> points) {
    for (const Position& p : points) box.add(p);
}

LegendSample sample_of(const Layer& layer) {
    if (!layer.polygons.empty()) return LegendSample::area;
    if (!layer.segments.empty() || !layer.polylines.empty()) return LegendSample::line;
    return layer.style.marker == Marker::none ? LegendSample::line : LegendSample::marker;
}

/// Centre and half of the extent along one axis.
struct Extent {
    double centre;
    double half;
};

Extent extent_of(double low, double high) {
    low = std::clamp(low, -largest_drawn, largest_drawn);
    high = std::clamp(high, -largest_drawn, largest_drawn);
    return {low / 2 + high / 2, high / 2 - low / 2};
}

std::string print(std::span<const Position> points) {
    std::string text;
    for (const Position& p : points) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", p.x, p.y);
        if (p.z != 0) text += fmt::format(" {}", p.z);
    }
    return text;
}

std::string print(const Colour& c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

void print(std::ostream& out, const Layer& layer) {
    const Style& s = layer.style;
    fmt::print(out, "layer {} order {} count {} legend \"{}\"\n", layer.name, layer.order,
               layer.count, layer.legend);
    fmt::print(out, "  style colour {} width {} opacity {} fill {} {} marker {} {}\n",
               print(s.colour), s.width, s.opacity, print(s.fill), s.fill_opacity,
               name_of(s.marker), s.marker_size);
    for (const Polygon& p : layer.polygons) {
        fmt::print(out, "  polygon {}: {}\n", p.id, print(p.outer));
        for (const auto& hole : p.holes) fmt::print(out, "  hole: {}\n", print(hole));
    }
    for (const Polyline& p : layer.polylines)
        fmt::print(out, "  polyline {}: {}\n", p.id, print(p.points));
    for (std::size_t i = 0; i + 1 < layer.segments.size(); i += 2) {
        fmt::print(out, "  segment {}: {}\n", i / 2,
                   print(std::span(layer.segments).subspan(i, 2)));
    }
    for (std::size_t i = 0; i < layer.points.size(); ++i) {
        fmt::print(out, "  point {}: {}\n", i, print(std::span(layer.points).subspan(i, 1)));
    }
    for (const Label& l : layer.labels) {
        fmt::print(out, "  label {}: {}\n", print(std::span(&l.at, 1)), l.text);
    }
}

}  // namespace

const char* name_of(Marker marker) noexcept {
    switch (marker) {
        case Marker::none:
            return "none";
        case Marker::disc:
            return "disc";
        case Marker::ring:
            return "ring";
        case Marker::square:
            return "square";
        case Marker::diamond:
            return "diamond";
        case Marker::cross:
            return "cross";
    }
    return "?";
}

void Box::add(const Position& p) noexcept {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void DrawList::add(Layer layer) {
    const auto behind = std::ranges::upper_bound(layers, layer.order, {}, &Layer::order);
    layers.insert(behind, std::move(layer));
}

const Layer* DrawList::find(const std::string& name) const noexcept {
    const auto found = std::ranges::find(layers, name, &Layer::name);
    return found == layers.end() ? nullptr : &*found;
}

Box bounds(const DrawList& list) {
    Box box;
    for (const Layer& layer : list.layers) {
        for (const Polygon& p : layer.polygons) add_all(box, p.outer);
        for (const Polyline& p : layer.polylines) add_all(box, p.points);
        add_all(box, layer.segments);
        add_all(box, layer.points);
        for (const Label& l : layer.labels) box.add(l.at);
    }
    return box;
}

Box window_around(const Box& box) {
    if (box.is_empty()) return {{0, 0, 0}, {1, 1, 0}};
    const auto [x, half_x] = extent_of(box.low.x, box.high.x);
    const auto [y, half_y] = extent_of(box.low.y, box.high.y);
    double larger = std::max(half_x, half_y);
    if (larger == 0) larger = std::max({std::abs(x), std::abs(y), 1.0}) / 1024;
    const double least = larger / largest_aspect;
    const double grown_x = std::max(half_x, least) + larger * 2 * margin;
    const double grown_y = std::max(half_y, least) + larger * 2 * margin;
    return {{x - grown_x, y - grown_y, box.low.z}, {x + grown_x, y + grown_y, box.high.z}};
}

std::vector<LegendEntry> legend(const DrawList& list) {
    std::vector<LegendEntry> entries;
    for (const Layer& layer : list.layers) {
        if (layer.legend.empty()) continue;
        std::string text = layer.legend;
        if (layer.count > 0) text += " (" + with_thousands(layer.count) + ")";
        entries.push_back({std::move(text), sample_of(layer), layer.style});
    }
    return entries;
}

std::string with_thousands(std::size_t n) {
    std::string digits = std::to_string(n);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
    return digits;
}

std::ostream& operator<<(std::ostream& out, const DrawList& list) {
    fmt::print(out, "title \"{}\"\n", list.title);
    if (!list.view.is_empty()) {
        fmt::print(out, "view {}, {}\n", print(std::span(&list.view.low, 1)),
                   print(std::span(&list.view.high, 1)));
    }
    if (list.camera) {
        fmt::print(out, "camera from {} up {}\n", print(std::span(&list.camera->from, 1)),
                   print(std::span(&list.camera->up, 1)));
    }
    for (const Layer& layer : list.layers) print(out, layer);
    for (const std::string& note : list.notes) fmt::print(out, "note {}\n", note);
    return out;
}

}  // namespace sightline::viz
