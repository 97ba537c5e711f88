// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/check_path.hpp"

#include <algorithm>
#include <cmath>

#include "sightline/event/critical_line.hpp"

namespace sightline::detail {

namespace {

RationalPoint3 place(const Scene3& scene, VertexId v) { return to_rational(scene[v]); }

/// The join of a + t u and b + t w.
LineCurve3 join(const RationalPoint3& a, const Vector3& u, const RationalPoint3& b,
                const Vector3& w) {
    const Vector3 p = vector_to(a);
    const Vector3 q = vector_to(b);
    return {{RationalLine3{q - p, cross(p, q)}, RationalLine3{w - u, cross(p, w) + cross(u, q)},
             RationalLine3{{0, 0, 0}, cross(u, w)}}};
}

/// Where a line that meets an edge's line meets it: 0 at its source, 1 at its target.
Rational position(const RationalLine3& l, const RationalPoint3& source, const Vector3& along) {
    const auto x = meeting_point(l, line_along(source, along)).divided();
    return dot(x - vector_to(source), along) / dot(along, along);
}

}  // namespace

Rational CheckRandom::fraction() {
    constexpr std::uint64_t parts = 1U << 20U;
    return {Rational(1 + engine_() % (parts - 1)), Rational(parts)};
}

PathMaker::PathMaker(const Scene3& scene, CheckRandom& random) : scene_(&scene), random_(&random) {
    bool is_first = true;
    RationalPoint3 high;
    for (std::uint32_t v = 0; v < scene.vertices().size(); ++v) {
        if (!scene.is_feature(VertexId{v})) continue;
        const RationalPoint3 p = place(scene, VertexId{v});
        if (is_first) low_ = high = p;
        is_first = false;
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    size_ = high - low_;
}

RationalPoint3 PathMaker::random_point() {
    // Half as large again as the scene.
    const auto along = [&](const Rational& low, const Rational& size, const Rational& extra) {
        const Rational wide = size + extra;
        return low - wide / Rational(4) + random_->fraction() * wide * Rational(3, 2);
    };
    const Rational extra = (size_.x + size_.y + size_.z) / Rational(8);
    return {along(low_.x, size_.x, extra), along(low_.y, size_.y, extra),
            along(low_.z, size_.z, extra)};
}

LinePath PathMaker::through_vertex(VertexId v, const std::optional<RationalLine3>& through) {
    const RationalPoint3 p = place(*scene_, v);
    RationalPoint3 from = random_point();
    RationalPoint3 to = random_point();
    if (through) {
        // A short way about a point of the line as far from v as the scene is large.
        const Rational longest = std::max({size_.x, size_.y, size_.z});
        const Rational largest =
            std::max({abs(through->d.x), abs(through->d.y), abs(through->d.z)});
        const RationalPoint3 middle = p + (longest / largest) * through->d;
        const Rational step = longest * random_->fraction() / Rational(4);
        const Vector3 w{step * random_->signed_fraction(), step * random_->signed_fraction(),
                        step * random_->signed_fraction()};
        from = middle + -w;
        to = middle + w;
    }
    return {{v, std::nullopt}, join(p, {0, 0, 0}, from, to - from), {}};
}

LinePath PathMaker::over_edges(EdgeId e, EdgeId f, const std::optional<RationalLine3>& through) {
    const RationalPoint3 a = place(*scene_, (*scene_)[e].source);
    const RationalPoint3 b = place(*scene_, (*scene_)[f].source);
    const Vector3 u = place(*scene_, (*scene_)[e].target) - a;
    const Vector3 w = place(*scene_, (*scene_)[f].target) - b;
    const auto range = [&](const RationalPoint3& source,
                           const Vector3& along) -> std::pair<Rational, Rational> {
        if (!through) return {random_->fraction(), random_->fraction()};
        const Rational middle = position(*through, source, along);
        const Rational reach = std::min(middle, Rational(1) - middle) * random_->signed_fraction();
        return {middle - reach, middle + reach};
    };
    const auto [a0, a1] = range(a, u);
    const auto [b0, b1] = range(b, w);
    const RationalPoint3 from = a + a0 * u;
    const RationalPoint3 to = b + b0 * w;
    const Vector3 da = (a1 - a0) * u;
    const Vector3 db = (b1 - b0) * w;
    LinePath path{{std::nullopt, std::pair{e, f}}, join(from, da, to, db), {}};
    add_vertices_on(e, from, da, path);
    add_vertices_on(f, to, db, path);
    return path;
}

void PathMaker::add_vertices_on(EdgeId e, const RationalPoint3& a, const Vector3& u,
                                LinePath& path) const {
    if (!scene_->has_touching_bodies() || u.is_zero()) return;
    const RationalLine3 l = carrier(e, *scene_);
    for (std::uint32_t v = 0; v < scene_->vertices().size(); ++v) {
        if (!scene_->is_feature(VertexId{v})) continue;
        const RationalPoint3 p = place(*scene_, VertexId{v});
        if (is_on(l, p)) path.vertices.emplace_back(dot(p - a, u) / dot(u, u), VertexId{v});
    }
}

namespace {

Real real(const Rational& x) {
    const double v = x.approx_double();  // the nearest
    return {v, std::abs(v) * 0x1p-53 + 0x1p-1074};
}

/// The sign of q₀ + q₁t + q₂t² for all t from 0 to 1, when the filter knows that it has one: that of its
/// Bernstein coefficients.
std::optional<Sign> sign_throughout(const std::array<Real, 3>& q) {
    const auto first = q[0].sign();
    if (!first || *first == Sign::zero) return std::nullopt;
    for (const Real& b : {q[0] + Real(0.5) * q[1], q[0] + q[1] + q[2]}) {
        if (b.sign() != first) return std::nullopt;
    }
    return first;
}

}  // namespace

PathFilter::PathFilter(const LineCurve3& curve, const SceneForms& forms) : forms_(&forms) {
    const auto vector = [](const Vector3& v) {
        return Vec3<Real>{real(v.x), real(v.y), real(v.z)};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        curve_[i] = {vector(curve.coefficients[i].d), vector(curve.coefficients[i].m)};
    }
}

bool PathFilter::surely_never_meets(EdgeId e) const {
    const auto form = [&](const auto& of) {
        return sign_throughout({of(curve_[0]), of(curve_[1]), of(curve_[2])});
    };
    const PluckerOf<Real>& edge = forms_->line<Real>(e.index());
    if (form([&](const PluckerOf<Real>& l) { return detail::side(l, edge); })) return true;
    // Both ends on one side of all lines, seen along an axis.
    for (int axis = 0; axis < 3; ++axis) {
        const auto side_of = [&](VertexId v) {
            const Vec3<Real>& p = forms_->point<Real>(v);
            return form([&](const PluckerOf<Real>& l) { return normal_from(l, p, axis); });
        };
        const auto source = side_of(forms_->scene()[e].source);
        if (source && source == side_of(forms_->scene()[e].target)) return true;
    }
    return false;
}

std::optional<Rational> rational_between(const Surd& a, const Surd& b) {
    const double low = a.approx_double();
    const double high = b.approx_double();
    for (const double share : {0.5, 0.4375, 0.5625}) {
        const Rational t(low + share * (high - low));
        if (a < Surd(t) && Surd(t) < b) return t;
    }
    return std::nullopt;
}

}  // namespace sightline::detail
