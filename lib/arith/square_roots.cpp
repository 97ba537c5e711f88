// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/square_roots.hpp"

#include <mpfr.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace sightline {

namespace {

constexpr unsigned first_precision = 64;

// An MPFR number, owned.
class Float {
public:
    explicit Float(unsigned bits) {
        mpfr_init2(x_, static_cast<mpfr_prec_t>(bits));
        mpfr_set_zero(x_, 1);
    }
    ~Float() { mpfr_clear(x_); }
    Float(const Float&) = delete;
    Float& operator=(const Float&) = delete;
    [[nodiscard]] mpfr_ptr get() { return x_; }

private:
    mpfr_t x_;
};

// coefficient · √radicand.
struct Term {
    Rational coefficient;
    Rational radicand;
};

// Bounds of a growing sum of terms.
class BoundedSum {
public:
    explicit BoundedSum(unsigned bits) : lower_(bits), upper_(bits), term_(bits) {}

    void add(const Term& term) {
        const bool negative = term.coefficient.sign() == Sign::negative;
        add_rounded(lower_.get(), term, MPFR_RNDD, negative ? MPFR_RNDU : MPFR_RNDD);
        add_rounded(upper_.get(), term, MPFR_RNDU, negative ? MPFR_RNDD : MPFR_RNDU);
    }
    [[nodiscard]] Interval enclosure() {
        return {mpfr_get_d(lower_.get(), MPFR_RNDD), mpfr_get_d(upper_.get(), MPFR_RNDU)};
    }
    [[nodiscard]] std::optional<Sign> sign() {
        if (mpfr_sgn(lower_.get()) > 0) return Sign::positive;
        if (mpfr_sgn(upper_.get()) < 0) return Sign::negative;
        if (mpfr_zero_p(lower_.get()) != 0 && mpfr_zero_p(upper_.get()) != 0) return Sign::zero;
        return std::nullopt;
    }

private:
    void add_rounded(mpfr_ptr sum, const Term& term, mpfr_rnd_t round, mpfr_rnd_t round_root) {
        mpfr_set_q(term_.get(), term.radicand.mpq(), round_root);
        mpfr_sqrt(term_.get(), term_.get(), round_root);
        mpfr_mul_q(term_.get(), term_.get(), term.coefficient.mpq(), round);
        mpfr_add(sum, sum, term_.get(), round);
    }

    Float lower_;
    Float upper_;
    Float term_;
};

// The sign of a sum of terms; empty when so many bits do not show it.
std::optional<Sign> sign_of_sum(const std::vector<Term>& terms, unsigned bits) {
    BoundedSum sum(bits);
    for (const Term& term : terms) sum.add(term);
    return sum.sign();
}

void require_not_negative(const Rational& radicand) {
    if (radicand.sign() == Sign::negative) {
        throw std::domain_error("square root of a negative number");
    }
}

// The difference of the sums as terms: sorted, equal radicands counted once, zeros dropped.
std::vector<Term> difference(std::span<const Rational> a, std::span<const Rational> b) {
    std::vector<Term> terms;
    terms.reserve(a.size() + b.size());
    for (const Rational& radicand : a) terms.push_back({1, radicand});
    for (const Rational& radicand : b) terms.push_back({-1, radicand});
    for (const Term& term : terms) require_not_negative(term.radicand);
    std::ranges::sort(terms, {}, &Term::radicand);
    std::vector<Term> merged;
    for (Term& term : terms) {
        if (!merged.empty() && merged.back().radicand == term.radicand) {
            merged.back().coefficient += term.coefficient;
        } else {
            merged.push_back(std::move(term));
        }
    }
    std::erase_if(merged, [](const Term& term) {
        return term.coefficient.sign() == Sign::zero || term.radicand.sign() == Sign::zero;
    });
    return merged;
}

// Merges the terms whose roots have a rational ratio, and drops those that cancel.
std::vector<Term> merged_square_classes(const std::vector<Term>& terms) {
    std::vector<Term> classes;
    for (const Term& term : terms) {
        bool merged = false;
        for (Term& other : classes) {
            const auto ratio = rational_square_root(term.radicand / other.radicand);
            if (!ratio) continue;
            other.coefficient += term.coefficient * *ratio;
            merged = true;
            break;
        }
        if (!merged) classes.push_back(term);
    }
    std::erase_if(classes, [](const Term& term) { return term.coefficient.sign() == Sign::zero; });
    return classes;
}

}  // namespace

Interval sum_of_square_roots(std::span<const Rational> squares, unsigned precision_bits) {
    BoundedSum sum(std::max(precision_bits, 2U));
    for (const Rational& square : squares) {
        require_not_negative(square);
        sum.add({1, square});
    }
    return sum.enclosure();
}

CertifiedSign compare_sums_of_square_roots(std::span<const Rational> a, std::span<const Rational> b,
                                           unsigned max_bits) {
    const std::vector<Term> terms = difference(a, b);
    if (terms.empty()) return {Sign::zero, Tier::exact};
    if (const auto sign = sign_of_sum(terms, first_precision)) return {*sign, Tier::interval};
    const std::vector<Term> classes = merged_square_classes(terms);
    if (classes.empty()) return {Sign::zero, Tier::exact};
    for (unsigned bits = 2 * first_precision; bits <= max_bits; bits *= 2) {
        if (const auto sign = sign_of_sum(classes, bits)) return {*sign, Tier::exact};
    }
    return {};
}

}  // namespace sightline
