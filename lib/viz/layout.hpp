// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sightline/viz/draw_list.hpp"

/// Where everything goes in a picture, in pixels with y downwards; the same for every writer.
namespace sightline::viz::detail {

struct Pixel {
    double x = 0;
    double y = 0;
};

struct Rectangle {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    [[nodiscard]] bool contains(const Rectangle& other) const noexcept;
    [[nodiscard]] bool meets(const Rectangle& other) const noexcept;
};

/// A line of text; `at` is the left end of its base line.
struct PlacedText {
    std::string text{};
    Pixel at{};
    double size = 0;
    bool bold = false;
    Colour colour{};
    Pixel anchor{};           ///< of a label: the place that it names
    double anchor_depth = 0;  ///< of that place, see Layout::depth
};

struct LegendRow {
    LegendSample sample = LegendSample::area;
    Style style{};
    Rectangle box{};  ///< of the sample
};

struct ScaleBar {
    Pixel left{};
    Pixel right{};
};

struct Layout {
    double width = 0;
    double height = 0;
    Rectangle data{};  ///< the drawing itself; it shows exactly `view`
    Box view{};
    std::vector<LegendRow> legend{};
    std::vector<PlacedText> texts{};   ///< title, legend and scale
    std::vector<PlacedText> labels{};  ///< inside `data`
    std::optional<ScaleBar> scale_bar;

    /// Where a position of the scene falls; finite for finite positions.
    [[nodiscard]] Pixel to_pixel(const Position& p) const noexcept;
    /// How many pixels a position of a projected list is nearer to the eye than the view's middle.
    [[nodiscard]] double depth(const Position& p) const noexcept;
};

struct LayoutOptions {
    double width = 0;
    double height = 0;  ///< 0: what the drawing's shape asks for
    double font_size = 14;
    bool legend = true;
    double magnification = 1;          ///< of the drawing in a window, for the scale bar
    std::vector<std::string> notes{};  ///< of the writer, after those of the list
};

[[nodiscard]] Layout make_layout(const DrawList& list, const LayoutOptions& options);

/// About how wide a text will be in a sans-serif font; UTF-8.
[[nodiscard]] double estimated_width(const std::string& text, double size) noexcept;

}  // namespace sightline::viz::detail
