// SPDX-License-Identifier: GPL-3.0-or-later
#include "viz/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace sightline::viz::detail {
namespace {

constexpr double pad = 16;
constexpr double sample_width = 26;
constexpr double sample_gap = 8;
constexpr double line_spacing = 1.3;
constexpr double largest_legend_share = 0.34;
constexpr double largest_height_share = 1.2;

/// (x - low) / (high - low) without overflow; one half when the range is empty.
double fraction(double x, double low, double high) {
    const double range = high / 2 - low / 2;
    if (!(range > 0)) return 0.5;
    const double part = (x / 2 - low / 2) / range;
    return std::clamp(part, -1e6, 1e6);  // far outside the picture is as good as anywhere outside
}

std::vector<std::string> wrapped(const std::string& text, double size, double width) {
    std::vector<std::string> lines;
    std::istringstream words(text);
    std::string word;
    while (words >> word) {
        if (!lines.empty() && estimated_width(lines.back() + " " + word, size) <= width) {
            lines.back() += " " + word;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

/// A legend entry or a note, broken into lines.
struct Block {
    const LegendEntry* entry = nullptr;
    std::vector<std::string> lines{};
};

/// The column to the right of the drawing.
struct Column {
    double width = 0;
    double height = 0;
    double font_size = 0;
    std::vector<Block> blocks{};
};

Column make_column(const std::vector<LegendEntry>& entries, const std::vector<std::string>& notes,
                   double font_size, double largest_width) {
    Column column{.font_size = font_size};
    double widest = 0;
    double rows = 0;
    const auto add = [&](const LegendEntry* entry, const std::string& text) {
        const double size = entry != nullptr ? font_size : font_size * 0.9;
        const double indent = entry != nullptr ? sample_width + sample_gap : 0;
        Block block{entry, wrapped(text, size, largest_width - indent)};
        for (const std::string& line : block.lines) {
            widest = std::max(widest, indent + estimated_width(line, size));
        }
        rows += static_cast<double>(block.lines.size()) + 0.45;
        column.blocks.push_back(std::move(block));
    };
    for (const LegendEntry& entry : entries) add(&entry, entry.text);
    for (const std::string& note : notes) add(nullptr, note);
    column.width = std::min(widest, largest_width);
    column.height = rows * font_size * line_spacing;
    return column;
}

void place_column(const Column& column, Pixel top_left, Layout& layout) {
    const double step = column.font_size * line_spacing;
    double y = top_left.y;
    for (const Block& block : column.blocks) {
        double x = top_left.x;
        double size = column.font_size * 0.9;
        if (block.entry != nullptr) {
            const double height = column.font_size;
            layout.legend.push_back({block.entry->sample,
                                     block.entry->style,
                                     {x, y + (step - height) / 2, sample_width, height}});
            x += sample_width + sample_gap;
            size = column.font_size;
        }
        for (const std::string& line : block.lines) {
            layout.texts.push_back(
                {line, {x, y + step / 2 + size * 0.35}, size, false, {40, 40, 40}, {}});
            y += step;
        }
        y += 0.45 * step;
    }
}

/// The largest of 1, 2, 5 times a power of ten that is at most `limit`.
double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= limit) return factor * power;
    }
    return power;
}

void place_scale_bar(Layout& layout, double font_size, double magnification) {
    const double shown = (layout.view.high.x / 2 - layout.view.low.x / 2) / magnification;
    if (!(shown > 0) || !std::isnormal(shown / 4)) return;
    const double length = round_length(shown / 2.5);
    const double pixels = length / 2 / shown * layout.data.width;
    const double y = layout.data.y + layout.data.height + font_size;
    layout.scale_bar = ScaleBar{{layout.data.x, y}, {layout.data.x + pixels, y}};
    layout.texts.push_back({fmt::format("{:g}", length),
                            {layout.data.x + pixels + 8, y + font_size * 0.33},
                            font_size * 0.9,
                            false,
                            {40, 40, 40}});
}

/// Left ends of base lines round p, the best first.
std::vector<Pixel> places_round(Pixel p, double away, double width, double size) {
    std::vector<Pixel> places;
    for (const double extra : {0.0, 1.3 * size, 2.6 * size}) {
        const double above = p.y - away - extra;
        const double below = p.y + away + 0.75 * size + extra;
        for (const double y : {above, below}) {
            places.insert(places.end(),
                          {{p.x + away, y}, {p.x - away - width, y}, {p.x - width / 2, y}});
        }
    }
    return places;
}

/// Gives each label the first place round its position that is inside the drawing and free.
void place_labels(const DrawList& list, double size, Layout& layout) {
    std::vector<Rectangle> taken;
    for (const Layer& layer : list.layers) {
        for (const Label& label : layer.labels) {
            const double width = estimated_width(label.text, size);
            const double away = layer.style.marker_size / 2 + 4;
            const Pixel p = layout.to_pixel(label.at);
            if (!layout.data.contains({p.x, p.y, 0, 0})) continue;
            const auto places = places_round(p, away, width, size);
            const auto box = [&](Pixel at) {
                return Rectangle{at.x - 2, at.y - size, width + 4, 1.25 * size};
            };
            const auto is_free = [&](Pixel at) {
                return layout.data.contains(box(at)) &&
                       std::ranges::none_of(taken,
                                            [&](const Rectangle& r) { return r.meets(box(at)); });
            };
            const auto found = std::ranges::find_if(places, is_free);
            const Pixel at = found != places.end() ? *found : places[0];
            taken.push_back(box(at));
            layout.labels.push_back(
                {label.text, at, size, true, layer.style.colour, p, layout.depth(label.at)});
        }
    }
}

/// The rectangle of the shape of `view` within the given space, at its upper left corner.
Rectangle fitted(const Box& view, double x, double y, double width, double height) {
    const double half_x = view.high.x / 2 - view.low.x / 2;
    const double half_y = view.high.y / 2 - view.low.y / 2;
    const double aspect = half_x > 0 && half_y > 0 ? half_x / half_y : 1;
    const double used = std::min(width, height * aspect);
    return {x, y, used, used / aspect};
}

}  // namespace

bool Rectangle::contains(const Rectangle& o) const noexcept {
    return x <= o.x && y <= o.y && o.x + o.width <= x + width && o.y + o.height <= y + height;
}

bool Rectangle::meets(const Rectangle& o) const noexcept {
    return x < o.x + o.width && o.x < x + width && y < o.y + o.height && o.y < y + height;
}

Pixel Layout::to_pixel(const Position& p) const noexcept {
    return {data.x + fraction(p.x, view.low.x, view.high.x) * data.width,
            data.y + (1 - fraction(p.y, view.low.y, view.high.y)) * data.height};
}

double Layout::depth(const Position& p) const noexcept {
    const double shown = view.high.x / 2 - view.low.x / 2;
    if (!(shown > 0) || !(view.low.z <= view.high.z)) return 0;
    const double off = p.z / 2 - (view.low.z / 4 + view.high.z / 4);
    return std::clamp(off / shown, -1e6, 1e6) * data.width;
}

double estimated_width(const std::string& text, double size) noexcept {
    double ems = 0;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // inside a character
        if (std::string_view(" ,.:;'|!ijlIft()[]").find(c) != std::string_view::npos)
            ems += 0.33;
        else if (c >= 'A' && c <= 'Z')
            ems += 0.72;
        else
            ems += c == 'm' || c == 'w' || c == '%' ? 0.87 : 0.58;
    }
    return ems * size;
}

Layout make_layout(const DrawList& list, const LayoutOptions& options) {
    Layout layout;
    layout.view = list.view.is_empty() ? window_around(bounds(list)) : list.view;
    layout.width = options.width;
    const double font_size = options.font_size;
    const std::vector<LegendEntry> entries =
        options.legend ? legend(list) : std::vector<LegendEntry>{};
    std::vector<std::string> notes = list.notes;
    notes.insert(notes.end(), options.notes.begin(), options.notes.end());
    const double largest_legend = options.width * largest_legend_share;
    Column column = make_column(entries, notes, font_size, largest_legend);

    const double top = list.title.empty() ? pad : pad + font_size * 2;
    const double bottom = pad + (list.scale_bar ? font_size * 1.6 : 0);
    const double beside = column.blocks.empty() ? 0 : column.width + pad;
    const double across = std::max(options.width - 2 * pad - beside, 1.0);
    double down = options.height - top - bottom;
    if (options.height == 0) {
        down = std::min(fitted(layout.view, 0, 0, across, 1e9).height,
                        options.width * largest_height_share);
        layout.height = std::ceil(top + std::max(down, column.height) + bottom);
    } else {
        layout.height = options.height;
        while (column.height > down && column.font_size > 7) {
            column = make_column(entries, notes, column.font_size * 0.9, largest_legend);
        }
    }
    layout.data = fitted(layout.view, pad, top, across, std::max(down, 1.0));
    if (!list.title.empty()) {
        layout.texts.push_back(
            {list.title, {pad, pad + font_size}, font_size * 1.25, true, {20, 20, 20}, {}});
    }
    place_column(column, {layout.data.x + layout.data.width + pad, layout.data.y}, layout);
    if (list.scale_bar) place_scale_bar(layout, font_size, options.magnification);
    place_labels(list, font_size, layout);
    return layout;
}

}  // namespace sightline::viz::detail
