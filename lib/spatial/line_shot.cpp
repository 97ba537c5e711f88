// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial/line_shot.hpp"

#include <cmath>
#include <limits>

#include "sightline/scene/result.hpp"

namespace sightline::detail {
namespace {

/// x/w, y/w, z/w in the scene's integer coordinates, w > 0.
struct WholePoint {
    Vec3<Integer> p;
    Integer w;
};

WholePoint whole_point(const RationalPoint3& point, int scale_exponent) {
    const std::array<const Rational*, 3> x{&point.x, &point.y, &point.z};
    WholePoint result;
    result.w = 1;
    for (const Rational* r : x) {
        mpz_lcm(result.w.get_mpz_t(), result.w.get_mpz_t(), mpq_denref(r->mpq()));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        mpz_ptr to = result.p[i].get_mpz_t();
        mpz_divexact(to, result.w.get_mpz_t(), mpq_denref(x[i]->mpq()));
        mpz_mul(to, to, mpq_numref(x[i]->mpq()));
        if (scale_exponent > 0) result.p[i] <<= static_cast<unsigned long>(scale_exponent);
    }
    if (scale_exponent < 0) result.w <<= static_cast<unsigned long>(-scale_exponent);
    return result;
}

/// The line through two rational points.
class TwoPoints final : public LineSource {
public:
    TwoPoints(const RationalPoint3& p, const RationalPoint3& q, int scale_exponent)
        : p_(p), q_(q), scale_exponent_(scale_exponent) {}

    [[nodiscard]] ExactLine exact_line() const override {
        const WholePoint p = whole_point(p_, scale_exponent_);
        const WholePoint q = whole_point(q_, scale_exponent_);
        ExactLine line;
        line.a.d = p.w * q.p - q.w * p.p;
        line.a.m = cross(p.p, q.p);
        return line;
    }

private:
    const RationalPoint3& p_;
    const RationalPoint3& q_;
    int scale_exponent_;
};

Real real_of(const Rational& x) {
    const double value = x.approx_double();
    if (!std::isfinite(value)) return {0, std::numeric_limits<double>::infinity()};
    // Twice half an ulp; the second term is for what underflows.
    const double error = std::abs(value) * 0x1p-52 + std::numeric_limits<double>::min();
    return Rational(value) == x ? Real(value) : Real(value, error);
}

Vec3<Real> real_of(const RationalPoint3& p) { return {real_of(p.x), real_of(p.y), real_of(p.z)}; }

}  // namespace

LineShot::LineShot(const SceneForms& forms) : forms_(&forms), cut_(forms) {
    for (const Body3& b : forms.scene().bodies()) has_world_ = has_world_ || b.is_world;
}

/// A line p + t d, cut; parameters of its places.
class LineShot::Cutter {
public:
    Cutter(LineShot& shot, const RationalPoint3& p, const RationalPoint3& q, const Policy& policy)
        : scene_(shot.forms_->scene()),
          cut_(shot.cut_),
          p_(p),
          d_(q - p),
          real_p_(real_of(p)),
          real_q_(real_of(q)),
          source_(p, q, shot.forms_->scale_exponent()),
          line_(line_through(real_p_, real_q_), source_, policy) {
        cut_.cut(line_);
        contacts_.resize(cut_.place_count());
        for (const Contact& c : cut_.contacts()) contacts_[c.place] = &c;
    }

    static constexpr std::uint32_t none = Run::none;

    [[nodiscard]] const LineCut& cut() const { return cut_; }
    [[nodiscard]] std::uint32_t place_count() const {
        return static_cast<std::uint32_t>(contacts_.size());
    }
    /// How many places lie before p (or q), or at it if `closed`.
    [[nodiscard]] std::uint32_t places_before_p(bool closed) const {
        return places_before(real_p_, Rational(0), closed);
    }
    [[nodiscard]] std::uint32_t places_before_q(bool closed) const {
        return places_before(real_q_, Rational(1), closed);
    }
    [[nodiscard]] bool is_at_p(std::uint32_t place) const {
        return order(place, real_p_, Rational(0)) == Sign::zero;
    }
    [[nodiscard]] Rational parameter(std::uint32_t place) const {
        const Contact& c = *contacts_[place];
        const Vector3 p = vector_to(p_);
        if (c.feature == Feature::vertex) {
            return dot(vertex(VertexId{c.id}) - p, d_) / dot(d_, d_);
        }
        if (c.feature == Feature::face) {
            const Face3& face = scene_[FaceId{c.id}];
            const Vector3 a = vertex(face.plane[0]);
            const Vector3 n = cross(vertex(face.plane[1]) - a, vertex(face.plane[2]) - a);
            return dot(n, a - p) / dot(n, d_);
        }
        const Edge3& edge = scene_[EdgeId{c.id}];
        const Vector3 a = vertex(edge.source);
        const Vector3 e = vertex(edge.target) - a;
        const Vector3 across = cross(d_, e);
        return determinant(a - p, e, across) / dot(across, across);
    }

private:
    // The sign of a place's parameter minus t, the parameter of `end`.
    [[nodiscard]] Sign order(std::uint32_t place, const Vec3<Real>& end, const Rational& t) const {
        const auto axis = static_cast<std::size_t>(cut_.axis());
        if (const auto sign = (contacts_[place]->position - end[axis]).sign()) {
            return *sign * cut_.axis_sign();
        }
        return (parameter(place) - t).sign();
    }
    [[nodiscard]] std::uint32_t places_before(const Vec3<Real>& end, const Rational& t,
                                              bool closed) const {
        std::uint32_t low = 0;
        std::uint32_t high = place_count();
        while (low < high) {
            const std::uint32_t middle = low + (high - low) / 2;
            const Sign sign = order(middle, end, t);
            if (sign == Sign::negative || (closed && sign == Sign::zero)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
    [[nodiscard]] Vector3 vertex(VertexId v) const { return vector_to(to_rational(scene_[v])); }

    const Scene3& scene_;
    LineCut& cut_;
    const RationalPoint3& p_;
    Vector3 d_;
    Vec3<Real> real_p_;
    Vec3<Real> real_q_;
    TwoPoints source_;
    Line line_;
    std::vector<const Contact*> contacts_;
};

bool LineShot::is_free(const RationalPoint3& p, const RationalPoint3& q, const Policy& policy) {
    const Cutter cutter(*this, p, q, policy);
    if (cutter.place_count() == 0) return !has_world_;
    const std::uint32_t up_to_p = cutter.places_before_p(true);
    const std::uint32_t before_q = cutter.places_before_q(false);
    for (const Run& run : cut_.runs()) {
        const bool from_p = run.first == Run::none || run.first < up_to_p;
        const bool to_q = run.last == Run::none || run.last >= before_q;
        if (from_p && to_q) return true;
    }
    return false;
}

FreeEnd3 LineShot::first_hit(const RationalPoint3& p, const Vector3& d, bool wants_point,
                             const Policy& policy) {
    const RationalPoint3 q = p + d;
    const Cutter cutter(*this, p, q, policy);
    const std::uint32_t up_to_p = cutter.places_before_p(true);
    // Runs overlap on sheets; from there one may leave on either side: the last run goes farthest.
    const Run* farthest = nullptr;
    for (const Run& run : cut_.runs()) {
        const bool from_p = run.first == Run::none || run.first < up_to_p;
        if (from_p && (run.last == Run::none || run.last >= up_to_p)) farthest = &run;
    }
    std::uint32_t last;
    if (farthest != nullptr) {
        last = farthest->last;
    } else {
        const bool is_place = up_to_p > 0 && cutter.is_at_p(up_to_p - 1);
        if (!is_place) {
            // In the interior of B, unless signs are wrong.
            SIGHTLINE_EXPECT(policy.arithmetic == Arithmetic::double_ ||
                             policy.arithmetic == Arithmetic::interval);
            return {};
        }
        last = up_to_p - 1;
    }
    if (last == Run::none) return {};
    FreeEnd3 end{std::nullopt, cut_.end_at(last, last + 1, Heading::forward)};
    if (wants_point) end.point = p + cutter.parameter(last) * d;
    return end;
}

}  // namespace sightline::detail
