// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/image.hpp"

#include <algorithm>
#include <cstring>

#include "arith/interval_cgal.hpp"
#include "sightline/geom/predicates3.hpp"

namespace sightline::detail {
namespace {

constexpr double u = 0x1p-53;
// Vectors err by u of their size; a product of three of them, summed up, by less than 12 u of the
// sum of the sizes, which itself is rounded: 16 is enough.
constexpr double det_error = 16 * u;
constexpr double tiny = 0x1p-1000;

using IntervalVector = std::array<IntervalNumber, 3>;

// The power of two that makes all coordinates integers.
Rational integer_scale(const Scene3& scene) {
    int lowest = 0;
    for (const Point3& p : scene.vertices()) {
        for (const double x : {p.x, p.y, p.z}) {
            if (x == 0) continue;
            int exponent = 0;
            const auto digits =
                static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
            lowest = std::min(lowest, exponent - 53 + __builtin_ctzll(digits));
        }
    }
    Rational scale(1);
    while (lowest < 0) {
        const int step = std::min(-lowest, 1000);
        scale *= Rational(std::ldexp(1.0, step));
        lowest += step;
    }
    return scale;
}

Vector3 unit(std::size_t axis) { return {axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0}; }

}  // namespace

Image::Image(const PlacedScene& scene, const Viewpoint3& from,
             std::span<const RationalPoint3> corners, Arithmetic arithmetic, Tally* tally)
    : scene_(scene),
      from_(from),
      arithmetic_(arithmetic),
      tally_(tally),
      vertices_(static_cast<std::uint32_t>(scene.scene->vertices().size())),
      corners_(corners.begin(), corners.end()) {
    make_map();
    round_points(corners);
}

void Image::make_map() {
    const Vector3 c = vector_to(from_.coordinates);
    const Rational scale = integer_scale(*scene_.scene);
    if (from_.at_infinity) {
        const Vector3 d = denominator_of(c.x) * denominator_of(c.y) * denominator_of(c.z) * c;
        std::size_t axis = 0;  // one that d is not parallel to
        if (abs(d.x) >= abs(d.y) && abs(d.x) >= abs(d.z)) axis = 1;
        const Vector3 e1 = cross(d, unit(axis));
        map_ = {e1, cross(-d, e1), Vector3{0, 0, 0}};
        shift_ = {0, 0, -1};
        factor_ = scale;
    } else {
        map_ = {unit(0), unit(1), unit(2)};
        shift_ = -c;
        factor_ = scale * denominator_of(c.x) * denominator_of(c.y) * denominator_of(c.z);
    }
    const std::array<Rational, 3> shift{shift_.x, shift_.y, shift_.z};
    for (std::size_t i = 0; i < 3; ++i) {
        enclosed_[i] = {enclosure(map_[i].x), enclosure(map_[i].y), enclosure(map_[i].z),
                        enclosure(shift[i])};
    }
}

namespace {

struct IntervalMap {
    const std::array<std::array<Interval, 4>, 3>& rows;
    bool is_shift;

    [[nodiscard]] IntervalNumber coefficient(std::size_t i, std::size_t k) const {
        return {rows[i][k].lower, rows[i][k].upper};
    }
    [[nodiscard]] IntervalVector operator()(const Point3& p) const {
        const IntervalNumber x(p.x);
        const IntervalNumber y(p.y);
        const IntervalNumber z(p.z);
        if (is_shift) return {x + coefficient(0, 3), y + coefficient(1, 3), z + coefficient(2, 3)};
        IntervalVector r;
        for (std::size_t i = 0; i < 3; ++i) {
            r[i] = coefficient(i, 0) * x + coefficient(i, 1) * y + coefficient(i, 2) * z +
                   coefficient(i, 3);
        }
        return r;
    }
};

[[gnu::noinline]] void enclose(const IntervalMap& map, std::span<const Point3> points,
                               std::vector<std::array<Interval, 3>>& out) {
    const RoundingUp scope;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const IntervalVector r = map(points[i]);
        for (std::size_t k = 0; k < 3; ++k) out[i][k] = {r[k].inf(), r[k].sup()};
    }
}

[[gnu::noinline]] std::optional<Sign> interval_determinant(const IntervalMap& map, const Point3& a,
                                                           const Point3& b, const Point3& c) {
    const RoundingUp scope;
    const IntervalVector p = map(a);
    const IntervalVector q = map(b);
    const IntervalVector r = map(c);
    const IntervalNumber det = (q[1] * p[2] - q[2] * p[1]) * r[0] +
                               (q[2] * p[0] - q[0] * p[2]) * r[1] +
                               (q[0] * p[1] - q[1] * p[0]) * r[2];
    return certain_sign(det);
}

// The middle of an interval, and what its error is relative to.
void round(const Interval& x, double& value, double& size) {
    value = x.lower == x.upper ? x.lower : x.lower / 2 + x.upper / 2;
    const double error = std::max(x.upper - value, value - x.lower);
    // Twice: the error is itself rounded, and infinite where the interval is.
    size = std::max(std::abs(value), 2 * error / u);
}

}  // namespace

void Image::round_points(std::span<const RationalPoint3> corners) {
    const auto points = scene_.scene->vertices();
    const std::size_t n = points.size() + corners.size();
    std::vector<std::array<Interval, 3>> intervals(n);
    enclose(IntervalMap{enclosed_, !from_.at_infinity}, points, intervals);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector3 v = vector_to(corners[i]);
        const std::array<Rational, 3> shift{shift_.x, shift_.y, shift_.z};
        for (std::size_t k = 0; k < 3; ++k) {
            intervals[points.size() + i][k] = enclosure(dot(map_[k], v) + shift[k]);
        }
    }
    r_.resize(n);
    size_.resize(n);
    exact_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < 3; ++k) round(intervals[i][k], r_[i][k], size_[i][k]);
    }
}

SightPlane Image::plane(std::uint32_t a, std::uint32_t b) const {
    const auto& p = r_[a];
    const auto& q = r_[b];
    const auto& s = size_[a];
    const auto& t = size_[b];
    return {{q[1] * p[2] - q[2] * p[1], q[2] * p[0] - q[0] * p[2], q[0] * p[1] - q[1] * p[0]},
            {t[1] * s[2] + t[2] * s[1], t[2] * s[0] + t[0] * s[2], t[0] * s[1] + t[1] * s[0]},
            a,
            b};
}

Near Image::near_side(const SightPlane& plane, std::uint32_t c) const {
    const auto& r = r_[c];
    const auto& s = size_[c];
    return {
        plane.normal[0] * r[0] + plane.normal[1] * r[1] + plane.normal[2] * r[2],
        det_error * (plane.size[0] * s[0] + plane.size[1] * s[1] + plane.size[2] * s[2]) + tiny};
}

Sign Image::side(const SightPlane& plane, std::uint32_t c) {
    if (arithmetic_ == Arithmetic::filtered) {
        const Near x = near_side(plane, c);
        if (x.value > x.error || x.value < -x.error) {
            count(Predicate::image_orientation3, Tier::filter);
            return x.value > 0 ? Sign::positive : Sign::negative;
        }
    }
    return undecided_side(plane.a, plane.b, c);
}

std::optional<Sign> Image::interval_side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (std::max({a, b, c}) >= vertices_) return std::nullopt;
    return interval_determinant(IntervalMap{enclosed_, !from_.at_infinity}, scene_.point(a),
                                scene_.point(b), scene_.point(c));
}

namespace {

// x - y, when that is a double.
std::optional<double> exact_difference(double x, double y) {
    const double d = x - y;
    if (d + y != x || x - d != y) return std::nullopt;
    return d;
}

// Whether a b == c d, decided in doubles; false where they cannot tell.
bool certainly_equal_products(double a, double b, double c, double d) {
    const double p = a * b;
    const double q = c * d;
    if (p != q) return false;
    if (p == 0) return (a == 0 || b == 0) && (c == 0 || d == 0);
    if (!(std::abs(p) > 0x1p-800 && std::abs(p) < 0x1p1000)) return false;
    return std::fma(a, b, -p) == std::fma(c, d, -q);
}

bool on_one_line(const Point3& a, const Point3& b, const Point3& c) {
    const std::array<std::optional<double>, 3> d{
        exact_difference(b.x, a.x), exact_difference(b.y, a.y), exact_difference(b.z, a.z)};
    const std::array<std::optional<double>, 3> e{
        exact_difference(c.x, a.x), exact_difference(c.y, a.y), exact_difference(c.z, a.z)};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!d[k] || !e[k]) return false;
    }
    return certainly_equal_products(*d[0], *e[1], *d[1], *e[0]) &&
           certainly_equal_products(*d[1], *e[2], *d[2], *e[1]) &&
           certainly_equal_products(*d[2], *e[0], *d[0], *e[2]);
}

}  // namespace

bool Image::certainly_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return arithmetic_ == Arithmetic::filtered && std::max({a, b, c}) < vertices_ &&
           on_one_line(scene_.point(a), scene_.point(b), scene_.point(c));
}

bool Image::certainly_equal(std::uint32_t a, std::uint32_t b) const {
    return arithmetic_ == Arithmetic::filtered && std::max(a, b) < vertices_ &&
           scene_.point(a) == scene_.point(b);
}

Sign Image::undecided_side(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    constexpr auto predicate = Predicate::image_orientation3;
    if (a == b || b == c || a == c) return Sign::zero;
    if (arithmetic_ == Arithmetic::double_) {
        count(predicate, Tier::filter);
        return sign_of(near_side(plane(a, b), c).value);
    }
    if (certainly_collinear(a, b, c)) {
        count(predicate, Tier::filter);
        return Sign::zero;
    }
    if (arithmetic_ != Arithmetic::exact) {
        if (const auto sign = interval_side(a, b, c)) {
            count(predicate, Tier::interval);
            return *sign;
        }
        if (arithmetic_ == Arithmetic::interval) {
            count(predicate, Tier::undecided);
            return Sign::zero;
        }
    }
    count(predicate, Tier::exact);
    return exact_side(a, b, c).sign();
}

Near Image::near_height(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x) const {
    const Point3& o = scene_.point(a);
    const auto from_a = [&](std::uint32_t i) {
        const Point3& q = scene_.point(i);
        return std::array<double, 3>{q.x - o.x, q.y - o.y, q.z - o.z};
    };
    const auto p = from_a(b);
    const auto q = from_a(c);
    const auto r = from_a(x);
    const double n0 = p[1] * q[2] - p[2] * q[1];
    const double n1 = p[2] * q[0] - p[0] * q[2];
    const double n2 = p[0] * q[1] - p[1] * q[0];
    const double m0 = std::abs(p[1] * q[2]) + std::abs(p[2] * q[1]);
    const double m1 = std::abs(p[2] * q[0]) + std::abs(p[0] * q[2]);
    const double m2 = std::abs(p[0] * q[1]) + std::abs(p[1] * q[0]);
    return {n0 * r[0] + n1 * r[1] + n2 * r[2],
            det_error * (m0 * std::abs(r[0]) + m1 * std::abs(r[1]) + m2 * std::abs(r[2])) + tiny};
}

Sign Image::height(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x) {
    if (x == a || x == b || x == c) return Sign::zero;
    if (arithmetic_ == Arithmetic::filtered) {
        const Near h = near_height(a, b, c, x);
        if (h.value > h.error || h.value < -h.error) {
            count(Predicate::orientation3, Tier::filter);
            return h.value > 0 ? Sign::positive : Sign::negative;
        }
    }
    return Predicates3(arithmetic_, tally_)
        .orientation(scene_.point(a), scene_.point(b), scene_.point(c), scene_.point(x));
}

Rational Image::exact_height(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x) {
    const RationalPoint3 o = to_rational(scene_.point(a));
    return determinant(to_rational(scene_.point(b)) - o, to_rational(scene_.point(c)) - o,
                       to_rational(scene_.point(x)) - o);
}

Near Image::near_minor(std::uint32_t a, std::uint32_t b, std::size_t k) const {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    return {r_[a][i] * r_[b][j] - r_[a][j] * r_[b][i],
            det_error * (size_[a][i] * size_[b][j] + size_[a][j] * size_[b][i]) + tiny};
}

Rational Image::exact_minor(std::uint32_t a, std::uint32_t b, std::size_t k) {
    const auto part = [](const Vector3& v, std::size_t i) -> const Rational& {
        return i == 0 ? v.x : i == 1 ? v.y : v.z;
    };
    const Vector3& p = exact(a);
    const Vector3& q = exact(b);
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    return part(p, i) * part(q, j) - part(p, j) * part(q, i);
}

Sign Image::minor(std::uint32_t a, std::uint32_t b, std::size_t k) {
    constexpr auto predicate = Predicate::image_orientation3;
    if (a == b) return Sign::zero;
    const Near x = near_minor(a, b, k);
    if (arithmetic_ == Arithmetic::double_) {
        count(predicate, Tier::filter);
        return sign_of(x.value);
    }
    if (arithmetic_ != Arithmetic::exact && (x.value > x.error || x.value < -x.error)) {
        count(predicate, Tier::filter);
        return sign_of(x.value);
    }
    if (certainly_equal(a, b)) {
        count(predicate, Tier::filter);
        return Sign::zero;
    }
    if (arithmetic_ == Arithmetic::interval) {
        count(predicate, Tier::undecided);
        return Sign::zero;
    }
    count(predicate, Tier::exact);
    return exact_minor(a, b, k).sign();
}

std::optional<std::size_t> Image::main_axis(const SightPlane& plane) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (std::abs(plane.normal[k]) > std::abs(plane.normal[best])) best = k;
    }
    if (minor(plane.a, plane.b, best) != Sign::zero) return best;
    for (std::size_t k = 0; k < 3; ++k) {
        if (k != best && minor(plane.a, plane.b, k) != Sign::zero) return k;
    }
    return std::nullopt;
}

bool Image::is_here(std::uint32_t x) {
    if (from_.at_infinity) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(r_[x][k]) > 2 * u * size_[x][k]) return false;
    }
    return exact(x).is_zero();
}

Vector3 Image::exact_vector(const RationalPoint3& x) const {
    const Vector3 v = vector_to(x);
    if (!from_.at_infinity) return factor_ * (v + shift_);
    return factor_ * (Vector3{dot(map_[0], v), dot(map_[1], v), 0} + shift_);
}

const Vector3& Image::exact(std::uint32_t x) {
    auto& cached = exact_[x];
    if (!cached) {
        cached =
            exact_vector(x < vertices_ ? to_rational(scene_.point(x)) : corners_[x - vertices_]);
    }
    return *cached;
}

Rational Image::exact_weight(std::uint32_t x) const {
    if (!from_.at_infinity) return 1;
    return -dot(vector_to(from_.coordinates), vector_to(to_rational(scene_.point(x))));
}

}  // namespace sightline::detail
