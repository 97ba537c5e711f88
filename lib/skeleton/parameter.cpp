// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton/parameter.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::detail {

namespace {

Real enclosure_of(const Integer& numerator, const Integer& denominator) {
    const mpq_class value(numerator, denominator);
    mpq_class reduced = value;
    reduced.canonicalize();
    const double middle = reduced.get_d();
    return {middle, std::abs(middle) * 0x1p-51 + 0x1p-1000};
}

/// Turns p + s√D into a rational number when D is a square.
void fold(ExactParameter& t) {
    if (sgn(t.D) == 0 || mpz_perfect_square_p(t.D.get_mpz_t()) == 0) return;
    Integer root;
    mpz_sqrt(root.get_mpz_t(), t.D.get_mpz_t());
    t.p += t.s * root;
    t.D = 0;
}

ExactParameter solve(const Quadratic<Integer>& q, int branch) {
    ExactParameter t;
    if (sgn(q.q2) == 0) {
        t.p = -q.q0;
        t.r = q.q1;
    } else {
        t.p = -q.q1;
        t.r = 2 * q.q2;
        t.D = branch == 0 ? Integer(0) : Integer(q.q1 * q.q1 - 4 * q.q0 * q.q2);
        t.s = branch;
    }
    if (sgn(t.r) < 0) {
        t.p = -t.p;
        t.r = -t.r;
        t.s = -t.s;
    }
    if (t.s == 0) t.s = 1;
    fold(t);
    return t;
}

}  // namespace

Parameter Parameter::dyadic(double t) {
    Parameter result;
    result.real_ = Real(t);
    return result;
}

Parameter Parameter::rational(const Integer& numerator, const Integer& denominator) {
    Parameter result;
    result.real_ = enclosure_of(numerator, denominator);
    auto exact = std::make_shared<ExactParameter>();
    exact->p = numerator;
    exact->r = denominator;
    result.exact_ = std::move(exact);
    return result;
}

Parameter Parameter::root(const Curve& curve, const EventForm& form, int branch,
                          const Real& enclosure) {
    Parameter result;
    result.real_ = enclosure;
    result.curve_ = &curve;
    result.form_ = form;
    result.branch_ = branch;
    return result;
}

const ExactParameter& Parameter::exact() const {
    if (exact_) return *exact_;
    auto exact = std::make_shared<ExactParameter>();
    if (curve_ != nullptr) *exact = solve(curve_->evaluate<Integer>(form_), branch_);
    // Where plain doubles took a vanishing coefficient for another number there is no such root.
    const bool has_root = curve_ != nullptr && sgn(exact->r) != 0 && sgn(exact->D) >= 0;
    if (!has_root) {
        const mpq_class value(std::isfinite(real_.value()) ? real_.value() : 0.0);
        *exact = {value.get_num(), 0, value.get_den(), 1};
    }
    exact_ = std::move(exact);
    return *exact_;
}

std::vector<Parameter> roots(const Curve& curve, const EventForm& form, const Quadratic<Real>& q) {
    const Policy& policy = curve.policy();
    std::optional<Quadratic<Integer>> exact;
    const auto exactly = [&]() -> const Quadratic<Integer>& {
        if (!exact) exact = curve.evaluate<Integer>(form);
        return *exact;
    };
    const bool is_linear = curve.degree() == 1 || form.kind == EventForm::Kind::vertex_plane ||
                           policy.sign(Predicate::curve_parameter3, q.q2,
                                       [&] { return sign_of_integer(exactly().q2); }) == Sign::zero;
    if (is_linear) {
        const Sign slope = policy.sign(Predicate::curve_parameter3, q.q1,
                                       [&] { return sign_of_integer(exactly().q1); });
        if (slope == Sign::zero) return {};
        return {Parameter::root(curve, form, 0, -(q.q0 / q.q1))};
    }
    const Real discriminant = q.q1 * q.q1 - Real(4.0) * q.q0 * q.q2;
    const Sign sign = policy.sign(Predicate::curve_parameter3, discriminant, [&] {
        const auto& e = exactly();
        return sign_of_integer(e.q1 * e.q1 - 4 * e.q0 * e.q2);
    });
    if (sign == Sign::negative) return {};
    if (sign == Sign::zero) {
        auto t = Parameter::root(curve, form, 0, -(q.q1 / (Real(2.0) * q.q2)));
        t.is_double_ = true;
        return {t};
    }
    // −(q₁ ± √D)/2 without cancellation, then its two quotients.
    const Real root = square_root(discriminant);
    const bool plus = q.q1.value() >= 0;
    const Real half = Real(-0.5) * (plus ? q.q1 + root : q.q1 - root);
    const Real far = half / q.q2;
    const Real near = q.q0 / half;
    // far is the branch −√D when q₁ ≥ 0.
    return {Parameter::root(curve, form, plus ? -1 : 1, far),
            Parameter::root(curve, form, plus ? 1 : -1, near)};
}

Sign compare(const Policy& policy, const Parameter& a, const Parameter& b) {
    return policy.sign(Predicate::curve_parameter3, a.real() - b.real(), [&] {
        const ExactParameter& x = a.exact();
        const ExactParameter& y = b.exact();
        return sign_of_surds(Integer(x.p * y.r - y.p * x.r), Integer(x.s * y.r), x.D,
                             Integer(-y.s * x.r), y.D);
    });
}

namespace {

/// (p + s√D) / r as multiples of 2^-bits, rounded down.
Integer scaled_floor(const ExactParameter& t, unsigned bits) {
    // floor((p + s√D)·2^bits / r); √D with the same number of bits, rounded towards −∞ after the sign.
    Integer scaled_square = t.D;
    mpz_mul_2exp(scaled_square.get_mpz_t(), scaled_square.get_mpz_t(), 2 * bits);
    Integer root;
    mpz_sqrt(root.get_mpz_t(), scaled_square.get_mpz_t());
    Integer numerator = t.p;
    mpz_mul_2exp(numerator.get_mpz_t(), numerator.get_mpz_t(), bits);
    if (t.s > 0) {
        numerator += root;
    } else if (sgn(t.D) != 0) {
        numerator -= root + 1;
    }
    Integer result;
    mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), t.r.get_mpz_t());
    return result;
}

/// Where in the gap the attempt's number lies, as a share of 64: not the middle, which scenes like to hold
/// something at.
unsigned share_of(unsigned attempt) { return 8 + (23 + 19 * attempt) % 48; }

Parameter between_exactly(const Parameter& a, const Parameter& b, unsigned attempt) {
    // Ends for a < b; a wrong order, from inexact arithmetic, must not keep it going.
    for (unsigned bits = 64; bits <= 1U << 16U; bits *= 2) {
        // Each floor is less than 2 below its number.
        const Integer low = scaled_floor(a.exact(), bits) + 2;
        const Integer high = scaled_floor(b.exact(), bits);
        if (high <= low + 64) continue;
        Integer denominator = 1;
        mpz_mul_2exp(denominator.get_mpz_t(), denominator.get_mpz_t(), bits);
        const Integer numerator = low + (high - low) / 64 * share_of(attempt);
        return Parameter::rational(numerator, denominator);
    }
    const double middle = a.real().value() / 2 + b.real().value() / 2;
    return Parameter::dyadic(std::isfinite(middle) ? middle : 0.5);
}

}  // namespace

Parameter between(const Parameter& a, const Parameter& b, unsigned attempt) {
    const double low = a.upper();
    const double high = b.lower();
    if (low < high && std::isfinite(low) && std::isfinite(high)) {
        // A multiple of a power of two of the gap's size: few digits, so exact lines stay short.
        const double wanted = low + (high - low) * (share_of(attempt) / 64.0);
        const double step = std::ldexp(1.0, std::max(std::ilogb(high - low) - 5, -1000));
        const double t = std::round(wanted / step) * step;
        if (low < t && t < high) return Parameter::dyadic(t);
        if (low < wanted && wanted < high) return Parameter::dyadic(wanted);
    }
    return between_exactly(a, b, attempt);
}

PluckerOf<Real> CurvePoint::real_line() const {
    const auto& l = curve_->coefficients<Real>();
    const Real& t = t_->real();
    if (curve_->degree() == 1) return l[0] + t * l[1];
    return l[0] + t * (l[1] + t * l[2]);
}

ExactLine CurvePoint::exact_line() const {
    const auto& l = curve_->coefficients<Integer>();
    const ExactParameter& t = t_->exact();
    ExactLine line;
    line.c = t.D;
    if (curve_->degree() == 1) {
        line.a = t.r * l[0] + t.p * l[1];
        if (!line.is_rational()) line.b = Integer(t.s) * l[1];
        return line;
    }
    const Integer rr = t.r * t.r;
    const Integer rp = t.r * t.p;
    const Integer square = t.p * t.p + t.D;
    line.a = rr * l[0] + rp * l[1] + square * l[2];
    if (!line.is_rational()) {
        const Integer twice = 2 * t.p;
        line.b = Integer(t.s) * (t.r * l[1] + twice * l[2]);
    }
    return line;
}

}  // namespace sightline::detail
