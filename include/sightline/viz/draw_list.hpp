// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Pictures as plain data. Builders (draw.hpp) turn scenes and results into a `DrawList`; writers
/// (svg.hpp, vtk_file.hpp, render.hpp) turn a `DrawList` into files. Between the two a test can
/// read what is drawn.
///
/// Everything here is rounded: drawing is the one place where approximate coordinates are wanted.
namespace sightline::viz {

/// Where something is drawn, in the coordinates of the scene, y upwards. z is 0 in the plane.
struct Position {
    double x = 0;
    double y = 0;
    double z = 0;

    friend bool operator==(const Position&, const Position&) = default;
};

/// A colour with 8 bits a channel.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend bool operator==(const Colour&, const Colour&) = default;
};

/// Colours that remain apart for the common kinds of colour blindness (Okabe and Ito, "Color
/// Universal Design", 2008), and the greys of solid things.
struct Palette {
    static constexpr Colour black{0, 0, 0};
    static constexpr Colour orange{230, 159, 0};
    static constexpr Colour sky_blue{86, 180, 233};
    static constexpr Colour green{0, 158, 115};
    static constexpr Colour yellow{240, 228, 66};
    static constexpr Colour blue{0, 114, 178};
    static constexpr Colour vermilion{213, 94, 0};
    static constexpr Colour purple{204, 121, 167};
    static constexpr Colour solid{196, 200, 206};
    static constexpr Colour outline{72, 79, 89};
};

/// How a point is shown.
enum class Marker : std::uint8_t { none, disc, ring, square, diamond, cross };

/// Name of a marker as it is printed: `disc`.
[[nodiscard]] const char* name_of(Marker marker) noexcept;

/// How the things of one layer look. Lengths are in pixels of the picture, opacities between 0
/// and 1.
struct Style {
    Colour colour{};          ///< of lines, outlines, markers and labels
    double width = 1;         ///< of lines and outlines; 0 draws none
    double opacity = 1;       ///< of lines, outlines and markers
    Colour fill{};            ///< of the inside of polygons
    double fill_opacity = 0;  ///< 0 leaves polygons empty
    Marker marker = Marker::none;
    double marker_size = 6;  ///< from side to side

    friend bool operator==(const Style&, const Style&) = default;
};

/// An area: a point is inside when a ray from it crosses the rings an odd number of times. Rings
/// may touch in points and run in either direction; their last edge is implied.
struct Polygon {
    std::vector<Position> outer{};
    std::vector<std::vector<Position>> holes{};
    std::uint32_t id = 0;  ///< of the thing shown, e.g. the body

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// An open chain.
struct Polyline {
    std::vector<Position> points{};
    std::uint32_t id = 0;

    friend bool operator==(const Polyline&, const Polyline&) = default;
};

/// A word next to a position.
struct Label {
    Position at{};
    std::string text{};

    friend bool operator==(const Label&, const Label&) = default;
};

/// Things of one kind, with one look and at most one line in the legend.
struct Layer {
    std::string name{};    ///< for programs, unique in the list: "bodies"
    std::string legend{};  ///< for people; empty keeps the layer out of the legend
    std::size_t count =
        0;          ///< how many things of the scene or result it stands for; 0 is not shown
    int order = 0;  ///< layers of lower order are painted first
    Style style{};
    std::vector<Polygon> polygons{};
    std::vector<Polyline> polylines{};
    /// Ends of many separate segments: 2i and 2i + 1 belong to segment i, whose id is i.
    std::vector<Position> segments{};
    /// Places of markers; the id of a point is its place in the vector.
    std::vector<Position> points{};
    std::vector<Label> labels{};

    friend bool operator==(const Layer&, const Layer&) = default;
};

/// An axis-parallel box; empty by default.
struct Box {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Position low{infinity, infinity, infinity};
    Position high{-infinity, -infinity, -infinity};

    [[nodiscard]] bool is_empty() const noexcept { return !(low.x <= high.x); }
    /// Grows to contain p.
    void add(const Position& p) noexcept;
    friend bool operator==(const Box&, const Box&) = default;
};

/// What the legend shows next to its text.
enum class LegendSample : std::uint8_t { area, line, marker };

/// One line of the legend.
struct LegendEntry {
    std::string text{};  ///< with the count: "bodies (12)"
    LegendSample sample = LegendSample::area;
    Style style{};

    friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// From where a picture of space is looked at: from infinitely far away, so that parallels stay
/// parallel. The default is isometric.
struct Camera {
    Position from{1, -1, 1};  ///< the direction towards the eye; not zero
    Position up{0, 0, 1};     ///< what shall point upwards; taken anew when it is along `from`

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// A picture: title, layers from back to front, the part of the plane to show, and notes under the
/// legend.
///
/// With a camera it is a picture of space: nearer things hide what is behind them, whatever their
/// layers; polygons are flat, convex and without holes, and shaded; markers are balls.
struct DrawList {
    std::string title{};
    std::vector<Layer> layers{};
    Box view{};  ///< what the picture shows; empty: everything, with a margin
    std::vector<std::string> notes{};
    bool scale_bar = true;
    std::optional<Camera> camera{};

    /// Adds a layer behind the first one of higher order.
    void add(Layer layer);
    /// The layer of that name, or null.
    [[nodiscard]] const Layer* find(const std::string& name) const noexcept;

    friend bool operator==(const DrawList&, const DrawList&) = default;
};

/// The smallest box around everything in the list.
[[nodiscard]] Box bounds(const DrawList& list);

/// A window around `box` that makes a good picture: a margin on all sides, neither side more than
/// three times the other, and never of zero size.
[[nodiscard]] Box window_around(const Box& box);

/// The list as the camera sees it: x to the right, y upwards, z towards the eye, lengths unchanged;
/// its view is empty or the window around what the view contains. A list without a camera is
/// returned as it is.
[[nodiscard]] DrawList projected(const DrawList& list);

/// The legend, derived from the layers that have a legend text, in the order in which they are
/// painted.
[[nodiscard]] std::vector<LegendEntry> legend(const DrawList& list);

/// A count as people read it: 12,345.
[[nodiscard]] std::string with_thousands(std::size_t n);

/// One element a line; for tests and for reading.
std::ostream& operator<<(std::ostream& out, const DrawList& list);

}  // namespace sightline::viz
