// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Exact positions on a curve: rational numbers and roots of quadratics, with enclosures. Private.

#include <memory>
#include <optional>
#include <vector>

#include "skeleton/curve.hpp"

namespace sightline::detail {

/// (p + s·√D) / r with integers, r > 0, s = ±1; D = 0 for rational numbers.
struct ExactParameter {
    Integer p, D, r;
    int s = 1;
};

class Parameter {
public:
    /// The number itself.
    [[nodiscard]] static Parameter dyadic(double t);
    [[nodiscard]] static Parameter rational(const Integer& numerator, const Integer& denominator);
    /// The root of a form on a curve: −1 and 1 for (−q₁ ∓ √(q₁² − 4q₀q₂)) / 2q₂, 0 for the root of a
    /// linear form or a double root.
    [[nodiscard]] static Parameter root(const Curve& curve, const EventForm& form, int branch,
                                        const Real& enclosure);

    [[nodiscard]] const Real& real() const { return real_; }
    [[nodiscard]] double lower() const { return real_.lower(); }
    [[nodiscard]] double upper() const { return real_.upper(); }
    [[nodiscard]] const ExactParameter& exact() const;
    /// Whether it is a double root.
    [[nodiscard]] bool is_double() const { return is_double_; }
    [[nodiscard]] int branch() const { return branch_; }
    [[nodiscard]] const EventForm& form() const { return form_; }

    friend std::vector<Parameter> roots(const Curve& curve, const EventForm& form,
                                        const Quadratic<Real>& q);

private:
    Real real_;
    const Curve* curve_ = nullptr;
    EventForm form_;
    int branch_ = 0;
    bool is_double_ = false;
    mutable std::shared_ptr<const ExactParameter> exact_;
};

/// The real roots of a form that does not vanish on the curve.
[[nodiscard]] std::vector<Parameter> roots(const Curve& curve, const EventForm& form,
                                           const Quadratic<Real>& q);

/// Order of two parameters of one curve.
[[nodiscard]] Sign compare(const Policy& policy, const Parameter& a, const Parameter& b);

/// A rational number strictly between a < b, of few digits; another one for each attempt.
[[nodiscard]] Parameter between(const Parameter& a, const Parameter& b, unsigned attempt = 0);

/// The line of a curve at a parameter; both must outlive it.
class CurvePoint final : public LineSource {
public:
    CurvePoint(const Curve& curve, const Parameter& t) : curve_(&curve), t_(&t) {}
    [[nodiscard]] PluckerOf<Real> real_line() const;
    [[nodiscard]] ExactLine exact_line() const override;

private:
    const Curve* curve_;
    const Parameter* t_;
};

}  // namespace sightline::detail
