// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A double together with a bound of its error: the filter for polynomials of higher degree.
/// Private.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sightline/arith/sign.hpp"

namespace sightline::detail {

/// The number type whose operations derive an error bound along with the polynomial's value.
///
/// Let u = 2^-53. A rounded operation with result v errs by at most u|v|, a product by 2^-1075
/// more when it underflows (sums and differences do not underflow inexactly). The errors of the
/// arguments propagate as usual. Computing the bound rounds as well: each of its operations loses a
/// relative u, of which a chain of k operations makes less than 2ku, and in products 2^-1075, which
/// the term 2^-1022 outweighs. sign() demands a margin of 2^-40, enough for k up to 4096.
/// Overflow makes the bound infinite or NaN, and then nothing is decided.
class ErrorBounded {
public:
    ErrorBounded() = default;  ///< zero
    explicit ErrorBounded(double exact) : value_(exact) {}
    /// A number known to lie within `error` of `value`.
    ErrorBounded(double value, double error) : value_(value), error_(error) {}

    [[nodiscard]] friend ErrorBounded operator+(const ErrorBounded& a, const ErrorBounded& b) {
        const double v = a.value_ + b.value_;
        return {v, a.error_ + b.error_ + u * std::abs(v)};
    }
    [[nodiscard]] friend ErrorBounded operator-(const ErrorBounded& a, const ErrorBounded& b) {
        const double v = a.value_ - b.value_;
        return {v, a.error_ + b.error_ + u * std::abs(v)};
    }
    [[nodiscard]] friend ErrorBounded operator*(const ErrorBounded& a, const ErrorBounded& b) {
        const double v = a.value_ * b.value_;
        const double propagated =
            std::abs(a.value_) * b.error_ + (std::abs(b.value_) + b.error_) * a.error_;
        return {v, propagated + u * std::abs(v) + std::numeric_limits<double>::min()};
    }

    /// a₀b₀ + a₁b₁ + a₂b₂ with one bound for all five operations, which err by less than 3u + O(u²) of the sum
    /// of the absolute products.
    [[nodiscard]] friend ErrorBounded sum_of_products(
        const ErrorBounded& a0, const ErrorBounded& b0, const ErrorBounded& a1,
        const ErrorBounded& b1, const ErrorBounded& a2, const ErrorBounded& b2) {
        const double p0 = a0.value_ * b0.value_;
        const double p1 = a1.value_ * b1.value_;
        const double p2 = a2.value_ * b2.value_;
        const double size = std::abs(p0) + std::abs(p1) + std::abs(p2);
        const double propagated =
            (std::abs(a0.value_) * b0.error_ + (std::abs(b0.value_) + b0.error_) * a0.error_) +
            (std::abs(a1.value_) * b1.error_ + (std::abs(b1.value_) + b1.error_) * a1.error_) +
            (std::abs(a2.value_) * b2.error_ + (std::abs(b2.value_) + b2.error_) * a2.error_);
        return {p0 + p1 + p2, propagated + 4 * u * size + std::numeric_limits<double>::min()};
    }

    /// Nothing is known of the quotient when b may be zero: the bound is infinite.
    [[nodiscard]] friend ErrorBounded operator/(const ErrorBounded& a, const ErrorBounded& b) {
        const double least = std::abs(b.value_) - b.error_ * (1 + 0x1p-40);
        const double v = a.value_ / b.value_;
        if (!(least > 0)) return {v, std::numeric_limits<double>::infinity()};
        const double propagated =
            (a.error_ + std::abs(v) * (b.error_ + u * std::abs(b.value_))) / least;
        return {v, propagated * (1 + 0x1p-40) + 2 * u * std::abs(v) +
                       std::numeric_limits<double>::min()};
    }
    [[nodiscard]] ErrorBounded operator-() const { return {-value_, error_}; }

    /// The root of a number that is not negative; a negative value counts as zero.
    [[nodiscard]] friend ErrorBounded square_root(const ErrorBounded& a) {
        const double v = std::sqrt(std::max(a.value_, 0.0));
        // |√x − √a| = |x − a| / (√x + √a), and ≤ √|x − a|.
        const double spread = a.error_ * (1 + 0x1p-40);
        const double propagated =
            spread < v * v ? spread / v : std::sqrt(spread + std::abs(a.value_));
        return {v, propagated * (1 + 0x1p-40) + 2 * u * v + 0x1p-511};
    }

    [[nodiscard]] double value() const { return value_; }
    /// Bounds of the exact number, with the margin that sign() demands.
    [[nodiscard]] double lower() const { return value_ - padded_error(); }
    [[nodiscard]] double upper() const { return value_ + padded_error(); }

    /// The sign of the exact value when it is certain, else empty.
    [[nodiscard]] std::optional<Sign> sign() const {
        const double bound = error_ * (1 + 0x1p-40);
        if (value_ > bound) return Sign::positive;
        if (-value_ > bound) return Sign::negative;
        if (value_ == 0 && error_ == 0) return Sign::zero;
        return std::nullopt;
    }

private:
    [[nodiscard]] double padded_error() const {
        return error_ == 0 ? 0 : error_ * (1 + 0x1p-40) + 2 * u * (std::abs(value_) + error_);
    }

    static constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    double value_ = 0;
    double error_ = 0;
};

}  // namespace sightline::detail
