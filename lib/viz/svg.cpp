// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>
#include <span>
#include <string>

#include <fmt/format.h>

#include "sightline/scene/result.hpp"
#include "viz/layout.hpp"
#include "viz/text.hpp"
#include "viz/trails.hpp"

namespace sightline::viz {
namespace {

using detail::GridPoint;
using detail::Layout;
using detail::Pixel;
using detail::PlacedText;

/// The drawing's coordinates are whole tenths of a pixel.
constexpr double grid = 10;
/// A path paints each pixel once; so many segments make a path, that crowded places come out
/// darker.
constexpr std::size_t segments_a_path = 400;
constexpr std::size_t most_paths = 64;

std::string hex(const Colour& c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

std::string stroke(const Style& s, double scale) {
    if (s.width == 0) return " stroke=\"none\"";
    std::string text =
        fmt::format(" stroke=\"{}\" stroke-width=\"{:.4g}\"", hex(s.colour), s.width * scale);
    if (s.opacity < 1) text += fmt::format(" stroke-opacity=\"{:.4g}\"", s.opacity);
    return text;
}

std::string fill(const Style& s) {
    if (s.fill_opacity == 0) return " fill=\"none\"";
    std::string text = fmt::format(" fill=\"{}\"", hex(s.fill));
    if (s.fill_opacity < 1) text += fmt::format(" fill-opacity=\"{:.4g}\"", s.fill_opacity);
    return text;
}

/// Path data: absolute starts, then relative steps, with no separator that is not needed.
class PathData {
public:
    void chain(std::span<const GridPoint> points, bool closed) {
        if (points.empty()) return;
        start(points[0]);
        for (const GridPoint& p : points.subspan(1)) step(p);
        if (points.size() == 1) text_ += "h0";
        if (closed) text_ += 'z';
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    void start(const GridPoint& p) {
        text_ += 'M';
        number(p.x);
        spaced(p.y);
        text_ += 'l';
        fresh_ = true;
        last_ = p;
    }
    void step(const GridPoint& p) {
        if (fresh_)
            number(p.x - last_.x);
        else
            spaced(p.x - last_.x);
        spaced(p.y - last_.y);
        fresh_ = false;
        last_ = p;
    }
    void number(std::int32_t n) { fmt::format_to(std::back_inserter(text_), "{}", n); }
    void spaced(std::int32_t n) {
        if (n >= 0) text_ += ' ';
        number(n);
    }

    std::string text_;
    GridPoint last_;
    bool fresh_ = false;
};

/// One picture on its way to a stream.
class Writer {
public:
    Writer(const DrawList& list, std::ostream& out, const SvgOptions& options, Layout layout)
        : list_(list), out_(out), options_(options), layout_(std::move(layout)) {}

    void write() {
        head();
        for (const Layer& layer : list_.layers) lines_and_areas(layer);
        out_ << "</g>\n";
        for (const Layer& layer : list_.layers) markers(layer);
        out_ << "</g>\n";
        frame();
        for (const PlacedText& label : layout_.labels) text(label, true);
        for (const detail::LegendRow& row : layout_.legend) sample(row);
        for (const PlacedText& words : layout_.texts) text(words, false);
        out_ << "</svg>\n";
    }

private:
    void head() {
        const auto& d = layout_.data;
        out_ << fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6g}\" height=\"{1:.6g}\" "
            "viewBox=\"0 0 {0:.6g} {1:.6g}\" font-family=\"Helvetica, Arial, sans-serif\">\n",
            layout_.width, layout_.height);
        if (!list_.title.empty())
            out_ << "<title>" << detail::xml_text(list_.title) << "</title>\n";
        out_ << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
        out_ << fmt::format(
            "<clipPath id=\"window\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
            "height=\"{:.2f}\"/></clipPath>\n",
            d.x, d.y, d.width, d.height);
        out_ << "<g clip-path=\"url(#window)\">\n<g transform=\"scale(0.1)\" "
                "stroke-linejoin=\"round\" "
                "stroke-linecap=\"round\">\n";
    }

    [[nodiscard]] GridPoint on_grid(const Position& p) const {
        const Pixel at = layout_.to_pixel(p);
        const auto rounded = [](double x) {
            return static_cast<std::int32_t>(std::lround(std::clamp(x * grid, -5e8, 5e8)));
        };
        return {rounded(at.x), rounded(at.y)};
    }

    [[nodiscard]] std::vector<GridPoint> on_grid(std::span<const Position> points) const {
        std::vector<GridPoint> result;
        for (const Position& p : points) {
            const GridPoint at = on_grid(p);
            if (result.empty() || result.back() != at) result.push_back(at);
        }
        return result;
    }

    void lines_and_areas(const Layer& layer) {
        if (layer.polygons.empty() && layer.polylines.empty() && layer.segments.empty()) return;
        const std::string filled = layer.polygons.empty() ? " fill=\"none\"" : fill(layer.style);
        out_ << "<g id=\"" << detail::xml_text(layer.name) << "\"" << filled
             << " fill-rule=\"evenodd\"" << stroke(layer.style, grid) << ">\n";
        for (const Polygon& polygon : layer.polygons) {
            PathData data;
            data.chain(on_grid(polygon.outer), true);
            for (const auto& hole : polygon.holes) data.chain(on_grid(hole), true);
            path(data, "");
        }
        for (const Polyline& line : layer.polylines) {
            PathData data;
            data.chain(on_grid(line.points), false);
            path(data, layer.polygons.empty() ? "" : " fill=\"none\"");
        }
        segments(layer);
        out_ << "</g>\n";
    }

    void segments(const Layer& layer) {
        const std::size_t all = layer.segments.size() / 2;
        const std::size_t drawn = std::min(all, options_.max_segments);
        std::vector<detail::GridSegment> chosen;
        chosen.reserve(drawn);
        for (std::size_t k = 0; k < drawn; ++k) {
            const std::size_t i = drawn == all ? k : k * all / drawn;
            chosen.emplace_back(on_grid(layer.segments[2 * i]), on_grid(layer.segments[2 * i + 1]));
        }
        const auto chains = detail::trails(std::move(chosen));
        std::vector<PathData> paths(
            std::clamp<std::size_t>(drawn / segments_a_path, 1, most_paths));
        for (std::size_t i = 0; i < chains.size(); ++i) {
            // Long chains are cut up, so that each path gets its share.
            const std::span<const GridPoint> chain = chains[i];
            for (std::size_t from = 0, turn = i; from == 0 || from + 1 < chain.size();
                 from += segments_a_path / 8, ++turn) {
                const std::size_t length = std::min(segments_a_path / 8 + 1, chain.size() - from);
                paths[turn % paths.size()].chain(chain.subspan(from, length), false);
            }
        }
        for (const PathData& data : paths)
            path(data, layer.polygons.empty() ? "" : " fill=\"none\"");
    }

    void path(const PathData& data, const char* attributes) {
        if (!data.text().empty())
            out_ << "<path" << attributes << " d=\"" << data.text() << "\"/>\n";
    }

    void markers(const Layer& layer) {
        const Style& s = layer.style;
        if (layer.points.empty() || s.marker == Marker::none) return;
        out_ << "<g" << marker_style(s) << ">\n";
        // One path a layer: thousands of vertices are common.
        std::string data;
        for (const Position& p : layer.points) data += marker_path(s, layout_.to_pixel(p));
        out_ << "<path d=\"" << data << "\"/>\n</g>\n";
    }

    static std::string marker_style(const Style& s) {
        const std::string opacity =
            s.opacity < 1 ? fmt::format(" opacity=\"{:.4g}\"", s.opacity) : "";
        if (s.marker == Marker::ring || s.marker == Marker::cross) {
            return fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\"{}",
                               hex(s.colour), std::max(1.0, s.marker_size / 5), opacity);
        }
        return fmt::format(" fill=\"{}\"{}", hex(s.colour), opacity);
    }

    static std::string marker_path(const Style& s, Pixel at) {
        const double r = s.marker_size / 2;
        switch (s.marker) {
            case Marker::square:
                return fmt::format("M{:.2f} {:.2f}h{:.4g}v{:.4g}h{:.4g}z", at.x - r, at.y - r,
                                   2 * r, 2 * r, -2 * r);
            case Marker::diamond:
                return fmt::format("M{:.2f} {:.2f}l{:.4g} {:.4g} {:.4g} {:.4g} {:.4g} {:.4g}z",
                                   at.x - r, at.y, r, -r, r, r, -r, r);
            case Marker::cross:
                return fmt::format("M{:.2f} {:.2f}l{:.4g} {:.4g}m0 {:.4g}l{:.4g} {:.4g}", at.x - r,
                                   at.y - r, 2 * r, 2 * r, -2 * r, -2 * r, 2 * r);
            default:
                return fmt::format(
                    "M{:.2f} {:.2f}a{:.4g} {:.4g} 0 1 0 {:.4g} 0a{:.4g} {:.4g} 0 1 0 {:.4g} 0z",
                    at.x - r, at.y, r, r, 2 * r, r, r, -2 * r);
        }
    }

    void frame() {
        const auto& d = layout_.data;
        out_ << fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" "
            "stroke=\"#999999\"/>\n",
            d.x, d.y, d.width, d.height);
        if (!layout_.scale_bar) return;
        const auto [left, right] = *layout_.scale_bar;
        out_ << fmt::format(
            "<path d=\"M{:.2f} {:.2f}v8m0 -4H{:.2f}m0 -4v8\" fill=\"none\" "
            "stroke=\"#282828\" stroke-width=\"1.5\"/>\n",
            left.x, left.y - 4, right.x);
    }

    void text(const PlacedText& t, bool halo) {
        out_ << fmt::format(
                    "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.4g}\" fill=\"{}\"{}{}>", t.at.x,
                    t.at.y, t.size, hex(t.colour), t.bold ? " font-weight=\"bold\"" : "",
                    halo ? " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" "
                           "paint-order=\"stroke\""
                         : "")
             << detail::xml_text(t.text) << "</text>\n";
    }

    void sample(const detail::LegendRow& row) {
        const auto& b = row.box;
        const double middle = b.y + b.height / 2;
        // A nearly invisible line would explain nothing.
        Style s = row.style;
        if (row.sample == LegendSample::line) {
            s.opacity = std::max(s.opacity, 0.7);
            s.width = std::max(s.width, 1.0);
            out_ << fmt::format("<path d=\"M{:.2f} {:.2f}h{:.2f}\" fill=\"none\"{}/>\n", b.x,
                                middle, b.width, stroke(s, 1));
        } else if (row.sample == LegendSample::area) {
            out_ << fmt::format(
                "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"{}{}/>\n", b.x,
                b.y, b.width, b.height, fill(s), stroke(s, 1));
        }
        if (s.marker != Marker::none) {
            out_ << "<path" << marker_style(s) << " d=\""
                 << marker_path(s, {b.x + b.width / 2, middle}) << "\"/>\n";
        }
    }

    const DrawList& list_;
    std::ostream& out_;
    const SvgOptions& options_;
    const Layout layout_;
};

}  // namespace

void write_svg(const DrawList& list, std::ostream& out, const SvgOptions& options) {
    SIGHTLINE_EXPECT(!list.camera);
    detail::LayoutOptions layout{.width = static_cast<double>(options.width),
                                 .height = static_cast<double>(options.height),
                                 .legend = options.legend};
    for (const Layer& layer : list.layers) {
        const std::size_t all = layer.segments.size() / 2;
        if (all <= options.max_segments) continue;
        layout.notes.push_back(
            fmt::format("Drawn: {} of the {} {}.", with_thousands(options.max_segments),
                        with_thousands(all), layer.legend.empty() ? layer.name : layer.legend));
    }
    Writer(list, out, options, detail::make_layout(list, layout)).write();
}

}  // namespace sightline::viz
