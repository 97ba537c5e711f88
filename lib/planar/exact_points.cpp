// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/planar/exact_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "planar/exact_points.hpp"

namespace sightline {
namespace {

using Integer = ExactPoints::Integer;
using Fraction = ExactPoints::Fraction;

Rational to_rational(Integer value) {
    const bool negative = value < 0;
    __extension__ using Unsigned = unsigned __int128;
    const Unsigned size = negative ? -static_cast<Unsigned>(value) : static_cast<Unsigned>(value);
    constexpr double two_32 = 0x1p32;
    Rational result(0);
    for (int part = 3; part >= 0; --part)
        result = result * Rational(two_32) +
                 Rational(static_cast<double>(static_cast<std::uint32_t>(size >> (32 * part))));
    return negative ? -result : result;
}

// Integer coordinates on the scene's grid, from its origin; fewer than 27 bits each.
struct GridPoint {
    Integer x, y;
};

Integer cross(const GridPoint& a, const GridPoint& b) { return a.x * b.y - a.y * b.x; }

class GridPoints {
public:
    GridPoints(const Scene2& scene, const Point2& origin, const Point2& high, double step)
        : scene_(scene),
          origin_(origin),
          step_(step),
          inverse_step_(1 / step),
          bits_(1 + std::ilogb(std::max(high.x - origin.x, high.y - origin.y) / step)) {}

    /// Places the viewpoint; false when it does not fit.
    bool stand_at(const RationalPoint2& from);
    [[nodiscard]] Fraction operator()(const ViewVertex& v) const;

private:
    [[nodiscard]] GridPoint at(VertexId v) const {
        const Point2& p = scene_[v];
        return {static_cast<std::int64_t>((p.x - origin_.x) * inverse_step_),
                static_cast<std::int64_t>((p.y - origin_.y) * inverse_step_)};
    }
    /// The line through two grid points: direction, and moment (point × direction).
    struct Line {
        GridPoint direction;
        Integer moment;
    };
    [[nodiscard]] Line line(EdgeId e) const {
        const GridPoint a = at(scene_[e].source);
        const GridPoint b = at(scene_[e].target);
        return {{b.x - a.x, b.y - a.y}, cross(a, b)};
    }
    [[nodiscard]] static Fraction meet(const Line& k, const Line& l) {
        const Integer w = cross(k.direction, l.direction);
        return {l.moment * k.direction.x - k.moment * l.direction.x,
                l.moment * k.direction.y - k.moment * l.direction.y, w};
    }
    /// From the viewpoint q / 2^shift to a vertex, the direction scaled by 2^shift: the moment is q × p.
    [[nodiscard]] Line sight(VertexId v) const {
        const GridPoint p = at(v);
        return {{p.x * scale_ - q_.x, p.y * scale_ - q_.y}, cross(q_, p)};
    }

    const Scene2& scene_;
    Point2 origin_;
    double step_;
    double inverse_step_;  // exact: a power of two
    int bits_;
    GridPoint q_{};
    Integer scale_ = 1;
};

// A finite double as mantissa · 2^exponent, the mantissa odd (or 0).
struct Binary {
    std::int64_t mantissa;
    int exponent;
};

Binary binary(double value) {
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    if (mantissa == 0) return {0, 0};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa >> zeros, exponent - 53 + zeros};
}

// The grid is refined by 2^shift until the viewpoint lies on it. With s bits for the scene on its grid,
// every product below stays under 3 s + shift + 3 bits.
bool GridPoints::stand_at(const RationalPoint2& from) {
    const double x = from.x.approx_double();
    const double y = from.y.approx_double();
    if (Rational(x) != from.x || Rational(y) != from.y) return false;
    const int step = std::ilogb(step_);
    const Binary bx = binary(x);
    const Binary by = binary(y);
    const int shift = std::max({0, step - bx.exponent, step - by.exponent});
    if (3 * bits_ + shift + 3 > 126) return false;
    const auto on_grid = [&](const Binary& b, double low) -> Integer {
        // Below 2^bits after the subtraction, so that the shifts fit.
        const auto origin = static_cast<Integer>(low / step_);
        return (Integer{b.mantissa} << (b.mantissa == 0 ? 0 : b.exponent - step + shift)) -
               (origin << shift);
    };
    if (!(std::fabs(x / step_) < 0x1p60) || !(std::fabs(origin_.x / step_) < 0x1p60) ||
        !(std::fabs(y / step_) < 0x1p60) || !(std::fabs(origin_.y / step_) < 0x1p60))
        return false;
    scale_ = Integer{1} << shift;
    q_ = {on_grid(bx, origin_.x), on_grid(by, origin_.y)};
    return true;
}

Fraction GridPoints::operator()(const ViewVertex& v) const {
    using Kind = ViewVertex::Kind;
    switch (v.kind) {
        case Kind::vertex: {
            const GridPoint p = at(v.vertex);
            return {p.x, p.y, 1};
        }
        case Kind::on_edge:
            return meet(sight(v.vertex), line(v.edge));
        case Kind::crossing:
            return meet(line(v.edge), line(v.other));
        case Kind::infinity: {
            const GridPoint d = sight(v.vertex).direction;
            return {d.x, d.y, 0};
        }
        case Kind::direction:
            return {Integer{v.axis == 0} - Integer{v.axis == 2},
                    Integer{v.axis == 1} - Integer{v.axis == 3}, 0};
        case Kind::from:
            break;
    }
    return {q_.x, q_.y, scale_};
}

}  // namespace

ViewPoint ExactPoints::operator[](std::size_t i) const {
    if (!is_fractions()) return rationals_[i];
    const Fraction& f = fractions_[i];
    const Rational x = to_rational(f.x);
    const Rational y = to_rational(f.y);
    if (f.w == 0) {
        const Rational size = std::max(abs(x), abs(y));
        return {{x / size, y / size}, true};
    }
    const Rational scale = Rational(step_) / to_rational(f.w);
    return {{Rational(origin_.x) + x * scale, Rational(origin_.y) + y * scale}, false};
}

namespace detail {

ExactPoints exact_points(const Scene2& scene, const Triangulation& t,
                         const VisibilityPolygon& polygon) {
    if (t.is_on_exact_grid()) {
        GridPoints grid(scene, t.position(0), t.position(2), t.grid_step());
        if (grid.stand_at(polygon.from)) {
            std::vector<Fraction> points;
            points.reserve(polygon.ring.size());
            for (const ViewVertex& v : polygon.ring) points.push_back(grid(v));
            return {t.position(0), t.grid_step(), std::move(points)};
        }
    }
    std::vector<ViewPoint> points;
    points.reserve(polygon.ring.size());
    for (const ViewVertex& v : polygon.ring) points.push_back(exact_point(scene, polygon.from, v));
    return ExactPoints(std::move(points));
}

}  // namespace detail
}  // namespace sightline
