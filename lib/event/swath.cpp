// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/swath.hpp"

#include <algorithm>
#include <ostream>

#include "sightline/scene/result.hpp"

namespace sightline {
namespace {

using Row = std::array<Rational, 6>;

RationalLine3 to_line(const Row& r) { return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}}; }

bool is_zero(const Rational& x) { return x.sign() == Sign::zero; }

/// Brings rows into reduced echelon form; rows of zeros go.
void reduce(std::vector<Row>& rows) {
    std::size_t done = 0;
    for (std::size_t column = 0; column < 6 && done < rows.size(); ++column) {
        const auto pivot =
            std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(done), rows.end(),
                         [&](const Row& row) { return !is_zero(row[column]); });
        if (pivot == rows.end()) continue;
        std::swap(rows[done], *pivot);
        const Rational by = rows[done][column];
        for (Rational& x : rows[done]) x /= by;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (i == done || is_zero(rows[i][column])) continue;
            const Rational factor = rows[i][column];
            for (std::size_t k = 0; k < 6; ++k) rows[i][k] -= factor * rows[done][k];
        }
        ++done;
    }
    rows.resize(done);
}

/// Whether a vector is a combination of rows in reduced echelon form.
template <typename Number>
bool is_spanned(const std::vector<Row>& rows, std::array<Number, 6> v) {
    for (const Row& row : rows) {
        const auto pivot = static_cast<std::size_t>(
            std::ranges::find_if(row, [](const Rational& x) { return !is_zero(x); }) - row.begin());
        const Number factor = v[pivot];
        for (std::size_t k = 0; k < 6; ++k) v[k] -= factor * Number(row[k]);
    }
    return std::ranges::all_of(v, [](const Number& x) { return sign_of(x) == Sign::zero; });
}

/// The line through two points; of two at infinity none.
RationalLine3 join(const ProjectivePoint3& p, const ProjectivePoint3& q) {
    return {p.w * q.p - q.w * p.p, cross(p.p, q.p)};
}

ProjectivePoint3 scaled_point(const ProjectivePoint3& p) {
    SIGHTLINE_EXPECT(p.is_finite() || !p.p.is_zero());
    if (p.is_finite()) return {p.divided(), 1};
    const Rational by = !is_zero(p.p.x) ? p.p.x : !is_zero(p.p.y) ? p.p.y : p.p.z;
    return {{p.p.x / by, p.p.y / by, p.p.z / by}, 0};
}

Plane3 scaled_plane(const Plane3& plane) {
    const Vector3& n = plane.normal;
    const Rational by = !is_zero(n.x) ? n.x : !is_zero(n.y) ? n.y : n.z;
    return {{n.x / by, n.y / by, n.z / by}, plane.offset / by};
}

/// a·b of two polynomials of degree 1 in t, the products taken by `times`.
template <typename A, typename B, typename Times>
auto product(const std::array<A, 2>& a, const std::array<B, 2>& b, Times times) {
    const auto cross_term = times(a[0], b[1]) + times(a[1], b[0]);
    return std::array{times(a[0], b[0]), cross_term, times(a[1], b[1])};
}

/// The line through p + t u that meets b and c.
LineCurve3 curve_over(const RationalPoint3& p, const Vector3& u, const RationalLine3& b,
                      const RationalLine3& c) {
    using Vectors = std::array<Vector3, 2>;
    using Numbers = std::array<Rational, 2>;
    const Vector3 at = vector_to(p);
    const auto normal = [&](const RationalLine3& l) {
        return Vectors{l.m - cross(at, l.d), -cross(u, l.d)};
    };
    const auto offset = [&](const RationalLine3& l) { return Numbers{dot(at, l.m), dot(u, l.m)}; };
    const auto d = product(normal(b), normal(c),
                           [](const Vector3& v, const Vector3& w) { return cross(v, w); });
    const auto times = [](const Rational& k, const Vector3& v) { return k * v; };
    const auto plus = product(offset(c), normal(b), times);
    const auto minus = product(offset(b), normal(c), times);
    LineCurve3 curve;
    for (std::size_t i = 0; i < 3; ++i) curve.coefficients[i] = {d[i], plus[i] - minus[i]};
    return curve;
}

}  // namespace

bool QuadraticForm3::is_zero() const {
    return std::ranges::all_of(std::array{&xx, &yy, &zz, &yz, &zx, &xy},
                               [](const Rational* c) { return c->sign() == Sign::zero; });
}

std::ostream& operator<<(std::ostream& out, const QuadraticForm3& q) {
    return out << q.xx << " xx + " << q.yy << " yy + " << q.zz << " zz + " << q.yz << " yz + "
               << q.zx << " zx + " << q.xy << " xy";
}

bool Quadric3::is_zero() const {
    return quadratic.is_zero() && linear.is_zero() && constant.sign() == Sign::zero;
}

std::ostream& operator<<(std::ostream& out, const Quadric3& q) {
    return out << q.quadratic << " + " << q.linear << " . x + " << q.constant;
}

QuadraticForm3 directions_of(const RationalLine3& first, const RationalLine3& second,
                             const RationalLine3& third) {
    QuadraticForm3 form;
    const auto add = [&form](const Vector3& m, const Vector3& n) {  // (d·m) (d·n)
        form.xx += m.x * n.x;
        form.yy += m.y * n.y;
        form.zz += m.z * n.z;
        form.yz += m.y * n.z + m.z * n.y;
        form.zx += m.z * n.x + m.x * n.z;
        form.xy += m.x * n.y + m.y * n.x;
    };
    add(first.m, cross(second.d, third.d));
    add(second.m, cross(third.d, first.d));
    add(third.m, cross(first.d, second.d));
    return form;
}

Quadric3 surface_of(const RationalLine3& first, const RationalLine3& second,
                    const RationalLine3& third) {
    const Vector3 linear = cross(first.d, cross(second.m, third.m)) +
                           cross(second.d, cross(third.m, first.m)) +
                           cross(third.d, cross(first.m, second.m));
    return {directions_of(first, second, third), -linear, determinant(first.m, second.m, third.m)};
}

std::vector<Surd> zeros_of(const std::array<Rational, 3>& c) {
    if (is_zero(c[2])) {
        if (!is_zero(c[1])) return {Surd(-c[0] / c[1])};
        SIGHTLINE_EXPECT(!is_zero(c[0]));
        return {};
    }
    const Rational middle = -c[1] / (2 * c[2]);
    const Rational radicand = middle * middle - c[0] / c[2];
    if (radicand.sign() == Sign::negative) return {};
    if (radicand.sign() == Sign::zero) return {Surd(middle)};
    return {Surd(middle, -1, radicand), Surd(middle, 1, radicand)};
}

RationalLine3 LineCurve3::at(const Rational& t) const {
    const auto& [a, b, c] = coefficients;
    return {a.d + t * (b.d + t * c.d), a.m + t * (b.m + t * c.m)};
}

SurdLine3 LineCurve3::at(const Surd& t) const {
    const SurdLine3 a = to_surd(coefficients[0]);
    const SurdLine3 b = to_surd(coefficients[1]);
    const SurdLine3 c = to_surd(coefficients[2]);
    return {a.d + t * (b.d + t * c.d), a.m + t * (b.m + t * c.m)};
}

int LineCurve3::degree() const {
    for (const int i : {2, 1}) {
        const RationalLine3& c = coefficients[static_cast<std::size_t>(i)];
        if (!c.d.is_zero() || !c.m.is_zero()) return i;
    }
    return 0;
}

const RationalLine3& LineCurve3::at_infinity() const {
    return coefficients[static_cast<std::size_t>(degree())];
}

std::array<Rational, 3> LineCurve3::side(const RationalLine3& l) const {
    const auto& [a, b, c] = coefficients;
    return {sightline::side(a, l), sightline::side(b, l), sightline::side(c, l)};
}

std::array<Rational, 3> LineCurve3::rise(const Vector3& normal) const {
    const auto& [a, b, c] = coefficients;
    return {dot(normal, a.d), dot(normal, b.d), dot(normal, c.d)};
}

bool is_on(const RationalLine3& l, const ProjectivePoint3& p) {
    return cross(p.p, l.d) == p.w * l.m;
}

bool is_on(const SurdLine3& l, const ProjectivePoint3& p) {
    return cross(to_surd(p.p), l.d) == Surd(p.w) * l.m;
}

std::string_view name_of(SwathKind kind) noexcept {
    constexpr std::array names{"pencil", "parallel", "regulus"};
    return names[static_cast<std::size_t>(kind)];
}

std::ostream& operator<<(std::ostream& out, SwathKind kind) { return out << name_of(kind); }

Swath Swath::pencil(const ProjectivePoint3& p, const RationalLine3& l) {
    SIGHTLINE_EXPECT(l.is_line() && !is_on(l, p));
    // plane_through(p / w, l), times w; parallels are in a plane through any point of l.
    const Vector3 normal = p.w * l.m - cross(p.p, l.d);
    const Rational offset =
        p.is_finite() ? dot(p.p, l.m) : dot(normal, vector_to(foot_of_origin(l)));
    return pencil(p, Plane3{normal, offset});
}

Swath Swath::pencil(const ProjectivePoint3& p, const Plane3& plane) {
    SIGHTLINE_EXPECT(!plane.is_degenerate() && dot(plane.normal, p.p) == plane.offset * p.w);
    Swath swath;
    swath.kind_ = p.is_finite() ? SwathKind::pencil : SwathKind::parallel;
    swath.centre_ = scaled_point(p);
    swath.plane_ = scaled_plane(plane);
    // Joins with the points at infinity of the plane; for parallels, with two points of it.
    const Vector3& n = swath.plane_.normal;
    std::vector<ProjectivePoint3> others;
    for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
        others.push_back({cross(n, axis), 0});
    }
    others.push_back({swath.plane_.offset * n, dot(n, n)});
    std::vector<Row> rows;
    for (const ProjectivePoint3& q : others) {
        rows.push_back(join(swath.centre_, q).coordinates());
    }
    swath.set_span(std::move(rows));
    SIGHTLINE_EXPECT(swath.span_.size() == 2);
    return swath;
}

Swath Swath::regulus(const RationalLine3& a, const RationalLine3& b, const RationalLine3& c) {
    SIGHTLINE_EXPECT(!is_zero(side(a, b)) && !is_zero(side(b, c)) && !is_zero(side(c, a)));
    Swath swath;
    swath.kind_ = SwathKind::regulus;
    swath.generators_ = {a, b, c};
    std::vector<Row> rows;
    for (const RationalLine3& l : swath.curve().coefficients) rows.push_back(l.coordinates());
    swath.set_span(std::move(rows));
    return swath;
}

void Swath::set_span(std::vector<Row> rows) {
    reduce(rows);
    span_ = std::move(rows);
}

const ProjectivePoint3& Swath::centre() const {
    SIGHTLINE_EXPECT(!is_regulus());
    return centre_;
}

const Plane3& Swath::plane() const {
    SIGHTLINE_EXPECT(!is_regulus());
    return plane_;
}

const std::array<RationalLine3, 3>& Swath::generators() const {
    SIGHTLINE_EXPECT(is_regulus());
    return generators_;
}

bool Swath::contains(const RationalLine3& l) const {
    return l.is_line() && is_spanned(span_, l.coordinates());
}

bool Swath::contains(const SurdLine3& l) const {
    return l.is_line() && is_spanned(span_, l.coordinates());
}

bool Swath::all_meet(const RationalLine3& l) const {
    return std::ranges::all_of(span_, [&](const Row& r) { return is_zero(side(to_line(r), l)); });
}

bool Swath::all_pass(const RationalPoint3& p) const {
    return std::ranges::all_of(span_, [&](const Row& r) { return is_on(to_line(r), p); });
}

bool Swath::all_in(const Plane3& p) const {
    return std::ranges::all_of(span_, [&](const Row& r) {
        const auto meeting = meeting_point(to_line(r), p);
        return !meeting.is_finite() && meeting.p.is_zero();
    });
}

LineCurve3 Swath::curve() const {
    if (!is_regulus()) {
        return {{to_line(span_[0]), to_line(span_[1]), RationalLine3{}}};
    }
    const auto& [a, b, c] = generators_;
    return curve_over(foot_of_origin(a), a.d, b, c);
}

LineCurve3 Swath::along(const RationalPoint3& p, const RationalPoint3& q) const {
    const RationalLine3 over = sightline::line_through(p, q);
    SIGHTLINE_EXPECT(over.is_line() && all_meet(over) && !contains(over));
    if (!is_regulus()) {
        SIGHTLINE_EXPECT(!is_on(over, centre_));
        return {{join(centre_, {vector_to(p), 1}), join(centre_, {over.d, 0}), RationalLine3{}}};
    }
    std::vector<RationalLine3> others;
    for (const RationalLine3& l : generators_) {
        if (!is_zero(sightline::side(l, over))) others.push_back(l);
    }
    return curve_over(p, over.d, others.at(0), others.at(1));
}

Quadric3 Swath::surface() const {
    if (!is_regulus()) return {{}, plane_.normal, -plane_.offset};
    return surface_of(generators_[0], generators_[1], generators_[2]);
}

QuadraticForm3 Swath::directions() const {
    SIGHTLINE_EXPECT(is_regulus());
    return directions_of(generators_[0], generators_[1], generators_[2]);
}

std::optional<std::vector<SurdLine3>> Swath::lines_meeting(const RationalLine3& l) const {
    if (all_meet(l)) return std::nullopt;
    std::vector<SurdLine3> lines;
    const LineCurve3 all = curve();
    const std::array<Rational, 3> sides = all.side(l);
    if (is_zero(sides[static_cast<std::size_t>(all.degree())])) {
        lines.push_back(to_surd(all.at_infinity()));
    }
    for (const Surd& t : zeros_of(sides)) lines.push_back(all.at(t));
    std::erase_if(lines, [](const SurdLine3& line) { return line.d.is_zero(); });
    for (SurdLine3& line : lines) line = scaled(line);
    std::ranges::sort(lines);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

std::optional<RationalLine3> Swath::line_through(const RationalPoint3& p) const {
    SIGHTLINE_EXPECT(!all_pass(p));
    RationalLine3 line;
    if (is_regulus()) {
        // p is on at most one of the generators, and then that one fixes no plane.
        const auto& [a, b, c] = generators_;
        const bool on_a = is_on(a, p);
        const bool on_b = is_on(b, p);
        line = sightline::line_through(p, on_a ? c : a, on_b ? c : b);
    } else {
        line = join(centre_, {vector_to(p), 1});
    }
    if (!contains(line)) return std::nullopt;
    return scaled(line);
}

std::ostream& operator<<(std::ostream& out, const Swath& swath) {
    out << swath.kind_;
    if (swath.is_regulus()) {
        for (const RationalLine3& l : swath.generators_) out << ' ' << l;
        return out;
    }
    const ProjectivePoint3& p = swath.centre_;
    return out << (p.is_finite() ? " through " : " along ") << p.p << " in " << swath.plane_;
}

}  // namespace sightline
