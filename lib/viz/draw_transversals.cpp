// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_transversals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "sightline/viz/draw.hpp"

namespace sightline::viz {

namespace {

using Elements = std::vector<TransversalElement>;

constexpr double overhang = 0.08;  // beyond the outermost points, as a part of their distance

Position position(const RationalPoint3& p) {
    const Point3 q = approx_point(p);
    return {q.x, q.y, q.z};
}

Position position(const SurdVector3& p) {
    return {p.x.approx_double(), p.y.approx_double(), p.z.approx_double()};
}

// The piece of a line between the outermost places where it meets elements, and a little more.
void add_line(Layer& layer, const SurdLine3& line, const Elements& elements) {
    const Position d = position(line.d);
    const auto along = [&](const Position& p) { return p.x * d.x + p.y * d.y + p.z * d.z; };
    std::vector<Position> places;
    for (const TransversalElement& e : elements) {
        if (meets(line, e)) places.push_back(position(witness(line, e)));
    }
    if (places.empty()) return;
    const auto [first, last] = std::ranges::minmax(places, {}, along);
    const auto beyond = [](const Position& from, const Position& to) {
        return Position{to.x + overhang * (to.x - from.x), to.y + overhang * (to.y - from.y),
                        to.z + overhang * (to.z - from.z)};
    };
    layer.segments.push_back(beyond(last, first));
    layer.segments.push_back(beyond(first, last));
    ++layer.count;
}

constexpr int steps = 8;  // lines of a range are drawn at its ends and between

// Lines of a pencil between two ends: mixtures of their directions.
void add_pencil(Layer& layer, const TransversalComponent& c, const TransversalRange& r,
                const Elements& elements) {
    const bool is_sum = scaled(line_along(*c.point, r.from.d + r.to.d)) == r.through;
    for (int i = 0; i <= steps; ++i) {
        const Rational t = Rational(i) / steps;
        const Vector3 d = (1 - t) * r.from.d + (is_sum ? t : -t) * r.to.d;
        if (!d.is_zero()) add_line(layer, to_surd(line_along(*c.point, d)), elements);
    }
}

// Lines of a regulus from places on its first generator, when the range does not pass infinity.
bool add_regulus(Layer& layer, const TransversalComponent& c, const TransversalRange& r,
                 const Elements& elements) {
    const auto place = [&](const RationalLine3& l) { return meeting_point(l, c.generators[0]); };
    const auto from = place(r.from), through = place(r.through), to = place(r.to);
    if (!from.is_finite() || !through.is_finite() || !to.is_finite()) return false;
    const Vector3 a = from.divided(), b = through.divided(), e = to.divided();
    if (dot(b - a, e - b).sign() == Sign::negative) return false;
    for (int i = 0; i <= steps; ++i) {
        const Vector3 p = a + Rational(i) / steps * (e - a);
        const RationalLine3 line =
            line_through(RationalPoint3{p.x, p.y, p.z}, c.generators[1], c.generators[2]);
        if (line.is_line()) add_line(layer, to_surd(line), elements);
    }
    return true;
}

void add_family(Layer& layer, const TransversalComponent& c, const Elements& elements) {
    for (const TransversalRange& r : c.ranges) {
        if (c.kind == TransversalComponent::Kind::pencil) {
            add_pencil(layer, c, r, elements);
        } else if (!add_regulus(layer, c, r, elements)) {
            for (const RationalLine3& line : {r.from, r.through, r.to}) {
                if (line.is_line()) add_line(layer, to_surd(line), elements);
            }
        }
    }
    for (const RationalLine3& line : c.extremal) add_line(layer, to_surd(line), elements);
}

Layer lines_layer() {
    return {.name = "lines",
            .legend = "lines",
            .order = PaintOrder::paths,
            .style = {.colour = Palette::vermilion, .width = 1.5}};
}

Layer families_layer() {
    return {.name = "families",
            .legend = "lines of families",
            .order = PaintOrder::graphs,
            .style = {.colour = Palette::blue, .width = 1.5}};
}

DrawList begin(const DrawTransversalsOptions& options) {
    DrawList list;
    list.title = options.title;
    list.scale_bar = false;
    list.camera = options.camera;
    return list;
}

void finish(DrawList& list, Layer lines, Layer families, std::size_t line_count) {
    if (lines.count < line_count) {
        list.notes.push_back(fmt::format("{} of {} lines are drawn", with_thousands(lines.count),
                                         with_thousands(line_count)));
    }
    if (families.count > 0) list.add(std::move(families));
    if (lines.count > 0) list.add(std::move(lines));
}

}  // namespace

DrawList draw(std::span<const RationalSegment3> segments, const SegmentTransversals& found,
              const DrawTransversalsOptions& options) {
    DrawList list = begin(options);
    Layer all{.name = "segments",
              .legend = "segments",
              .count = segments.size(),
              .order = PaintOrder::walls,
              .style = {.colour = Palette::outline, .width = 4}};
    for (const RationalSegment3& s : segments) {
        all.segments.push_back(position(s.source));
        all.segments.push_back(position(s.target));
    }
    list.add(std::move(all));
    const auto elements = [&](const SegmentSupport& support) {
        Elements four;
        for (const auto i : support) four.push_back(TransversalElement::segment(segments[i]));
        return four;
    };
    Layer lines = lines_layer(), families = families_layer();
    for (const auto& line : found.lines) {
        if (lines.count >= options.most_lines) break;
        add_line(lines, exact_line(segments, line), elements(line.support));
    }
    for (const auto& c : found.components) {
        if (families.count >= options.most_lines) break;
        add_family(families, c.component, elements(c.support));
    }
    finish(list, std::move(lines), std::move(families), found.lines.size());
    return list;
}

DrawList draw(const std::array<RationalTriangle3, 4>& triangles, const TriangleTangents& found,
              const DrawTransversalsOptions& options) {
    DrawList list = begin(options);
    Layer all{.name = "triangles",
              .legend = "triangles",
              .count = triangles.size(),
              .order = PaintOrder::bodies,
              .style = {.colour = Palette::outline,
                        .width = 1.5,
                        .fill = Palette::sky_blue,
                        .fill_opacity = 0.5}};
    Elements edges;
    for (const RationalTriangle3& t : triangles) {
        all.polygons.push_back({{position(t[0]), position(t[1]), position(t[2])}, {}, 0});
        for (std::size_t i = 0; i < 3; ++i) {
            edges.push_back(TransversalElement::segment(edge_of(t, i)));
        }
    }
    list.add(std::move(all));
    Layer lines = lines_layer(), families = families_layer();
    for (const auto& line : found.lines) {
        if (lines.count < options.most_lines) add_line(lines, line.line, edges);
    }
    for (const auto& c : found.components) add_family(families, c, edges);
    finish(list, std::move(lines), std::move(families), found.lines.size());
    return list;
}

}  // namespace sightline::viz
