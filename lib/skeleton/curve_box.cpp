// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/curve_box.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {

namespace {

double spread(const Real& x) { return x.upper() - x.lower(); }

struct Centred {
    std::array<double, 3> middle, half, far;

    explicit Centred(const Box3& box) {
        for (std::size_t i = 0; i < 3; ++i) {
            middle[i] = box.low[i] / 2 + box.high[i] / 2;
            half[i] = (box.high[i] / 2 - box.low[i] / 2) * (1 + 0x1p-50);
            far[i] = std::abs(middle[i]) + half[i];
        }
    }
};

/// k of the plane n·x = k that contains the line, to which n is normal.
Real offset_of(const Vec3<Real>& n, const PluckerOf<Real>& line) {
    return dot(n, cross(line.d, line.m)) / dot(line.d, line.d);
}

}  // namespace

BoxForm::BoxForm(const Vec3<Real>& n, const Real& k) : k_(k.value()), k_error_(spread(k)) {
    for (std::size_t i = 0; i < 3; ++i) {
        n_[i] = n[i].value();
        error_[i] = spread(n[i]);
    }
}

int BoxForm::sign(const Box3& box) const {
    const Centred c(box);
    double value = -k_;
    double reach = 0;
    double slack = k_error_ + std::abs(k_) * 0x1p-47 + 0x1p-1000;
    for (std::size_t i = 0; i < 3; ++i) {
        value += n_[i] * c.middle[i];
        reach += std::abs(n_[i]) * c.half[i];
        slack += (error_[i] + std::abs(n_[i]) * 0x1p-47) * c.far[i];
    }
    const double bound = (reach + slack) * (1 + 0x1p-45);
    return value > bound ? 1 : -value > bound ? -1 : 0;
}

CurveBoxTest::CurveBoxTest(const Curve& curve, const StoppingFaces& stopping, double low,
                           double high)
    : curve_(&curve) {
    const SceneForms& forms = curve.forms();
    for (std::size_t end = 0; end < 2; ++end) {
        for (const FaceId f : stopping[end]) {
            const PlaneOf<Real>& plane = forms.plane<Real>(f);
            stops_[end].emplace_back(plane.n, plane.k);
        }
    }
    if (curve.kind() == CurveKind::regulus) {
        wedge_count_ = 2;
    } else {
        const auto& l = curve.coefficients<Real>();
        normal_ = cross(l[0].d, l[1].d);
        plane_ = BoxForm(normal_, offset_of(normal_, l[0]));
    }
    set_interval(low, high);
}

void CurveBoxTest::set_interval(double low, double high) {
    const SceneForms& forms = curve_->forms();
    std::size_t end = 0;
    for (const double t : {low, high}) {
        if (curve_->kind() == CurveKind::regulus) {
            const Vec3<Real>& a = forms.point<Real>(forms.scene()[curve_->base()].source);
            const Vec3<Real> p = a + Real(t) * forms.line<Real>(curve_->base().index()).d;
            for (std::size_t i = 0; i < 2; ++i) {
                const PluckerOf<Real>& g = forms.line<Real>(curve_->edges()[i + 1].index());
                wedges_[i][end] = BoxForm(normal_from(g, p), dot(g.m, p));
            }
        } else {
            const auto& l = curve_->coefficients<Real>();
            const PluckerOf<Real> line = l[0] + Real(t) * l[1];
            const Vec3<Real> n = cross(line.d, normal_);
            wedges_[0][end] = BoxForm(n, offset_of(n, line));
        }
        ++end;
    }
}

bool CurveBoxTest::operator()(const Box3& box) const {
    for (const auto& stops : stops_) {
        const auto is_behind = [&](const BoxForm& stop) { return stop.sign(box) < 0; };
        if (!stops.empty() && std::ranges::all_of(stops, is_behind)) return false;
    }
    if (curve_->kind() != CurveKind::regulus && plane_.sign(box) != 0) return false;
    for (std::size_t i = 0; i < wedge_count_; ++i) {
        const int at_low = wedges_[i][0].sign(box);
        if (at_low != 0 && at_low == wedges_[i][1].sign(box)) return false;
    }
    return curve_->kind() != CurveKind::regulus || may_meet_quadric(box);
}

bool CurveBoxTest::may_meet_quadric(const Box3& box) const {
    // det(n₁(x), n₂(x), n₃(x)), nᵢ(x) = mᵢ − x × uᵢ, is zero on the surface (mathematics: surface of a swath).
    // Between the middle and x, each factor changes by at most h × |uᵢ|, component by component; the
    // sum of absolute products bounds what that does, and bounds the rounding with a relative 2^-44.
    const Centred c(box);
    std::array<std::array<double, 3>, 3> value;
    std::array<std::array<double, 3>, 3> size;
    double relative = 0x1p-44;
    for (std::size_t i = 0; i < 3; ++i) {
        const PluckerOf<Real>& g = curve_->forms().line<Real>(curve_->edges()[i].index());
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t p = (k + 1) % 3;
            const std::size_t q = (k + 2) % 3;
            value[i][k] =
                g.m[k].value() - (c.middle[p] * g.d[q].value() - c.middle[q] * g.d[p].value());
            const double change =
                c.half[p] * std::abs(g.d[q].value()) + c.half[q] * std::abs(g.d[p].value());
            const double rounding =
                spread(g.m[k]) + c.far[p] * spread(g.d[q]) + c.far[q] * spread(g.d[p]) +
                relative * (std::abs(g.m[k].value()) + c.far[p] * std::abs(g.d[q].value()) +
                            c.far[q] * std::abs(g.d[p].value()));
            size[i][k] = std::abs(value[i][k]) + change + rounding;
        }
    }
    double determinant = 0;
    double at_middle = 0;
    double anywhere = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const double even = value[0][i] * value[1][j] * value[2][k];
        const double odd = value[0][i] * value[1][k] * value[2][j];
        determinant += even - odd;
        at_middle += std::abs(even) + std::abs(odd);
        anywhere += size[0][i] * size[1][j] * size[2][k] + size[0][i] * size[1][k] * size[2][j];
    }
    return !(std::abs(determinant) > anywhere - at_middle + anywhere * relative + 0x1p-1000);
}

}  // namespace sightline::detail
