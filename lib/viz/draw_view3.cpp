// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/viz/draw_view3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace sightline::viz {
namespace {

using Vec = std::array<double, 3>;

Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec times(double k, const Vec& a) { return {k * a[0], k * a[1], k * a[2]}; }
double inner(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec outer(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& a) {
    const double size = std::sqrt(inner(a, a));
    return size > 0 ? times(1 / size, a) : Vec{1, 0, 0};
}

// The radius of the stereographic picture; what lies farther from the middle is cut off.
constexpr double radius = 2;

/// From points on lines of sight to the picture.
class Projection {
public:
    Projection(const View3& view, const std::vector<Vec>& nodes)
        : infinity_(view.from.at_infinity) {
        const Point3 from = approx_point(view.from.coordinates);
        from_ = {from.x, from.y, from.z};
        Vec middle{};
        for (const Vec& x : nodes) {
            const Vec d = direction(x);
            for (std::size_t k = 0; k < 3; ++k) middle[k] += d[k];
        }
        ahead_ = unit(infinity_ ? from_ : middle);
        const Vec up = std::abs(ahead_[2]) < 0.99 ? Vec{0, 0, 1} : Vec{0, 1, 0};
        right_ = unit(outer(ahead_, up));
        up_ = outer(right_, ahead_);
        double least = 1;
        for (const Vec& x : nodes) least = std::min(least, inner(ahead_, direction(x)));
        is_flat_ = infinity_ || least > 0.4;
    }

    /// A vector along the line of sight.
    [[nodiscard]] Vec direction(const Vec& x) const {
        return infinity_ ? x : unit(minus(x, from_));
    }
    [[nodiscard]] bool is_flat() const noexcept { return is_flat_; }
    [[nodiscard]] bool is_parallel() const noexcept { return infinity_; }

    [[nodiscard]] Position operator()(const Vec& d) const {
        const double x = inner(right_, d);
        const double y = inner(up_, d);
        if (infinity_) return {x, y, 0};
        const double z = inner(ahead_, d);
        if (is_flat_) return {x / z, y / z, 0};
        const double size = std::sqrt(inner(d, d));
        return {2 * x / (size + z), 2 * y / (size + z), 0};
    }
    /// The arc between two directions, without its first point.
    void add_arc(const Vec& a, const Vec& b, std::vector<Position>& out) const {
        const int steps = is_flat_ ? 1 : 24;
        for (int i = 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            Vec d{};
            for (std::size_t k = 0; k < 3; ++k) d[k] = (1 - t) * a[k] + t * b[k];
            out.push_back((*this)(is_flat_ ? d : unit(d)));
        }
    }

private:
    bool infinity_;
    bool is_flat_ = true;
    Vec from_{};
    Vec ahead_{};
    Vec right_{};
    Vec up_{};
};

double area(const std::vector<Position>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Position& a = ring[i];
        const Position& b = ring[(i + 1) % ring.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

Colour blend(const Colour& a, const Colour& b, double t) {
    const auto mix = [t](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround((1 - t) * x + t * y));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

// By body, lighter the more the face looks to a lamp at the upper left.
Colour colour_of(const Scene3& scene, const FaceSide& side) {
    constexpr std::array<Colour, 6> colours{Palette::sky_blue, Palette::orange, Palette::green,
                                            Palette::yellow,   Palette::purple, Palette::blue};
    const Face3& face = scene[side.face];
    const auto at = [&](std::size_t k) {
        const Point3& p = scene[face.plane[k]];
        return Vec{p.x, p.y, p.z};
    };
    const Vec normal = unit(outer(minus(at(1), at(0)), minus(at(2), at(0))));
    const double light = (1 + inner(side.back ? times(-1, normal) : normal, unit({-1, -2, 3}))) / 2;
    const double shade = std::round(light * 8) / 8;
    const Colour own =
        scene[face.body].is_world ? Palette::solid : colours[face.body.index() % colours.size()];
    return blend(blend(own, Palette::black, 0.35), {255, 255, 255}, 0.75 * shade);
}

class Painter {
public:
    Painter(const Scene3& scene, const View3& view)
        : scene_(scene), view_(view), nodes_(points()), projection_(view, nodes_) {
        for (Vec& x : nodes_) x = projection_.direction(x);
    }

    DrawList paint(const DrawOptions& options) {
        DrawList list;
        list.title = options.title;
        list.scale_bar = false;
        for (Layer& layer : faces()) list.add(std::move(layer));
        list.add(arcs());
        list.add(junctions());
        list.view = options.view;
        if (list.view.is_empty() && !projection_.is_flat()) {
            list.view.add({-radius, -radius, 0});
            list.view.add({radius, radius, 0});
        }
        return list;
    }

private:
    std::vector<Vec> points() const {
        std::vector<Vec> points;
        for (std::uint32_t i = 0; i < view_.map.nodes.size(); ++i) {
            const Point3 p = approx_point(exact_point(scene_, view_, i));
            points.push_back({p.x, p.y, p.z});
        }
        return points;
    }

    std::vector<Layer> faces() const {
        std::map<std::tuple<int, int, int>, Layer> layers;
        std::size_t count = 0;
        for (const ViewRegion& region : view_.map.regions) {
            if (region.kind != ViewRegion::Kind::face) continue;
            ++count;
            const Colour c = colour_of(scene_, region.faces.front());
            Layer& layer = layers[{c.red, c.green, c.blue}];
            layer.style.fill = c;
            layer.style.fill_opacity = 1;
            layer.style.width = 0;
            layer.polygons.push_back(polygon(region));
        }
        std::vector<Layer> result;
        for (auto& [colour, layer] : layers) {
            layer.name = "faces" + std::to_string(result.size());
            layer.order = PaintOrder::bodies;
            if (result.empty()) {
                layer.legend = "visible regions of faces";
                layer.count = count;
            }
            result.push_back(std::move(layer));
        }
        return result;
    }

    Polygon polygon(const ViewRegion& region) const {
        Polygon polygon;
        polygon.id = region.faces.front().face.value;
        double whole = 0;
        std::vector<std::vector<Position>> rings;
        for (const auto& ring : region.rings) {
            std::vector<Position> points;
            for (const ViewHalfArc& h : ring) {
                const ViewArc& arc = view_.map.arcs[h.arc];
                projection_.add_arc(nodes_[h.reversed ? arc.target : arc.source],
                                    nodes_[h.reversed ? arc.source : arc.target], points);
            }
            whole += area(points);
            rings.push_back(std::move(points));
        }
        // The region that contains the direction opposite to the middle has its inside outside.
        if (whole < 0) {
            constexpr double far = 4 * radius;
            rings.insert(rings.begin(),
                         {{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}});
        }
        std::sort(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
            return std::abs(area(a)) > std::abs(area(b));
        });
        polygon.outer = std::move(rings.front());
        polygon.holes.assign(std::make_move_iterator(rings.begin() + 1),
                             std::make_move_iterator(rings.end()));
        return polygon;
    }

    Layer arcs() const {
        Layer layer;
        layer.name = "edges";
        layer.legend = "visible pieces of edges";
        layer.count = view_.map.pieces.size();
        layer.order = PaintOrder::graphs;
        layer.style.colour = Palette::outline;
        layer.style.width = 1.2;
        for (std::uint32_t i = 0; i < view_.map.arcs.size(); ++i) {
            const ViewArc& arc = view_.map.arcs[i];
            Polyline line;
            line.id = i;
            line.points.push_back(projection_(nodes_[arc.source]));
            projection_.add_arc(nodes_[arc.source], nodes_[arc.target], line.points);
            layer.polylines.push_back(std::move(line));
        }
        return layer;
    }

    Layer junctions() const {
        Layer layer;
        layer.name = "t_junctions";
        layer.legend = "T-junctions";
        layer.count = view_.map.t_junctions.size();
        layer.order = PaintOrder::marks;
        layer.style.colour = Palette::vermilion;
        layer.style.marker = Marker::disc;
        layer.style.marker_size = 6;
        for (const TJunction& t : view_.map.t_junctions) {
            layer.points.push_back(projection_(nodes_[t.node]));
        }
        return layer;
    }

    const Scene3& scene_;
    const View3& view_;
    std::vector<Vec> nodes_;
    Projection projection_;
};

}  // namespace

DrawList draw(const Scene3& scene, const View3& view, const DrawOptions& options) {
    return Painter(scene, view).paint(options);
}

}  // namespace sightline::viz
