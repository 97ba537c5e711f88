// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A line of space known in two ways: to the filter at once, exactly when asked. Private.

#include <optional>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "spatial/plucker_forms.hpp"

namespace sightline::detail {

/// Plücker vector a + b·√c with integers; b is zero for rational lines.
struct ExactLine {
    PluckerOf<Integer> a;
    PluckerOf<Integer> b;
    Integer c;

    [[nodiscard]] bool is_rational() const { return sgn(c) == 0; }
};

/// Knows how to compute a line exactly.
class LineSource {
public:
    virtual ~LineSource() = default;
    [[nodiscard]] virtual ExactLine exact_line() const = 0;
};

/// How signs are decided, and where that is counted.
struct Policy {
    Arithmetic arithmetic = Arithmetic::filtered;
    Tally* tally = nullptr;

    /// The sign of a polynomial: `real` is its filtered value, `exact()` gives the exact sign.
    template <typename Exact>
    [[nodiscard]] Sign sign(Predicate predicate, const Real& real, const Exact& exact) const {
        if (arithmetic == Arithmetic::double_) {
            count(predicate, Tier::filter);
            return sign_of(real.value());
        }
        if (arithmetic != Arithmetic::exact) {
            if (const auto certain = real.sign()) {
                count(predicate, Tier::filter);
                return *certain;
            }
            if (arithmetic == Arithmetic::interval) {
                count(predicate, Tier::undecided);
                return Sign::zero;
            }
        }
        count(predicate, Tier::exact);
        return exact();
    }

private:
    void count(Predicate predicate, Tier tier) const {
        if (tally != nullptr) tally->add(predicate, tier);
    }
};

class Line {
public:
    /// `source` must outlive the line.
    Line(const PluckerOf<Real>& real, const LineSource& source, const Policy& policy)
        : real_(real), source_(&source), policy_(&policy) {}

    [[nodiscard]] const PluckerOf<Real>& real() const { return real_; }
    [[nodiscard]] const ExactLine& exact() const {
        if (!exact_) exact_ = source_->exact_line();
        return *exact_;
    }
    [[nodiscard]] const Policy& policy() const { return *policy_; }

    /// Sign of a linear form: `form(line)` for a PluckerOf<Real> and a PluckerOf<Integer>.
    template <typename Form>
    [[nodiscard]] Sign sign(Predicate predicate, const Form& form) const {
        return policy_->sign(predicate, form(real_), [&] {
            const ExactLine& e = exact();
            const Integer a = form(e.a);
            if (e.is_rational()) return sign_of_integer(a);
            const Integer b = form(e.b);
            return sign_of_surd(a, b, e.c);
        });
    }

private:
    PluckerOf<Real> real_;
    const LineSource* source_;
    const Policy* policy_;
    mutable std::optional<ExactLine> exact_;
};

}  // namespace sightline::detail
