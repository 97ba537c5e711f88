// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sightline/arith/sign.hpp"

namespace sightline {

/// An exact rational number: a regular value, always in lowest terms with a positive denominator.
///
/// Moves neither allocate nor fail, and leave zero behind. Every operation is exact; only
/// approx_double() rounds. Distinct objects may be used from different threads.
class Rational {
public:
    /// Decimal exponents beyond ±max_exponent are refused by parse(): a short text must not be
    /// able to ask for a large number. Every finite double is far inside.
    static constexpr int max_exponent = 1100;

    /// Zero; does not allocate.
    Rational() noexcept = default;
    /// The integer itself.
    template <std::integral Integer>
    Rational(Integer value) {  // NOLINT(google-explicit-constructor): integers are rational numbers
        if (value == 0) return;
        if constexpr (std::unsigned_integral<Integer>) {
            set(static_cast<unsigned long>(value));
        } else {
            set(static_cast<long>(value));
        }
    }
    /// The number that the double is, denormals included. Throws std::domain_error for NaN and
    /// infinity.
    explicit Rational(double value);
    /// numerator / denominator, reduced. Throws std::domain_error when the denominator is zero.
    Rational(const Rational& numerator, const Rational& denominator);

    Rational(const Rational& other);
    Rational(Rational&& other) noexcept : q_(std::exchange(other.q_, {})) {}
    Rational& operator=(const Rational& other);
    Rational& operator=(Rational&& other) noexcept {
        std::swap(q_, other.q_);
        return *this;
    }
    ~Rational() {
        if (!is_hollow()) mpq_clear(&q_);
    }

    /// Reads "3", "-7/2", "1.25", "+1e-3", ".5": a sign, decimal digits with an optional point and
    /// exponent, or a fraction of two integers. Nothing else may stand in the text. Empty when the
    /// text is not of this form, when a denominator is zero, or when an exponent exceeds
    /// max_exponent. Memory is proportional to text.size() + max_exponent.
    [[nodiscard]] static std::optional<Rational> parse(std::string_view text);

    [[nodiscard]] Sign sign() const noexcept { return static_cast<Sign>(mpq_sgn(mpq())); }
    [[nodiscard]] bool is_integer() const noexcept;

    /// The nearest double, ties to even; ±infinity when the nearest double does not exist.
    [[nodiscard]] double approx_double() const;

    /// "3" or "-7/2": what parse() reads back.
    [[nodiscard]] std::string to_string() const;
    /// Decimal digits of the numerator, with its sign.
    [[nodiscard]] std::string numerator() const;
    /// Decimal digits of the denominator; "1" for integers.
    [[nodiscard]] std::string denominator() const;
    /// Equal numbers have equal hashes.
    [[nodiscard]] std::size_t hash() const noexcept;

    /// The number as GMP sees it, for reading; valid while this object is unchanged.
    [[nodiscard]] mpq_srcptr mpq() const noexcept { return is_hollow() ? zero() : &q_; }

    [[nodiscard]] Rational operator-() const;
    [[nodiscard]] friend Rational operator+(const Rational& a, const Rational& b) {
        return apply(mpq_add, a, b);
    }
    [[nodiscard]] friend Rational operator-(const Rational& a, const Rational& b) {
        return apply(mpq_sub, a, b);
    }
    [[nodiscard]] friend Rational operator*(const Rational& a, const Rational& b) {
        return apply(mpq_mul, a, b);
    }
    /// Throws std::domain_error when b is zero.
    [[nodiscard]] friend Rational operator/(const Rational& a, const Rational& b) {
        return Rational(a, b);
    }
    Rational& operator+=(const Rational& b) { return *this = *this + b; }
    Rational& operator-=(const Rational& b) { return *this = *this - b; }
    Rational& operator*=(const Rational& b) { return *this = *this * b; }
    Rational& operator/=(const Rational& b) { return *this = *this / b; }

    [[nodiscard]] friend bool operator==(const Rational& a, const Rational& b) noexcept {
        return mpq_equal(a.mpq(), b.mpq()) != 0;
    }
    [[nodiscard]] friend std::strong_ordering operator<=>(const Rational& a,
                                                          const Rational& b) noexcept {
        return mpq_cmp(a.mpq(), b.mpq()) <=> 0;
    }
    friend std::ostream& operator<<(std::ostream& out, const Rational& x);
    friend Rational numerator_of(const Rational& x);
    friend Rational denominator_of(const Rational& x);
    friend std::optional<Rational> rational_square_root(const Rational& x);

private:
    void set(long value);
    void set(unsigned long value);
    static Rational apply(void (*operation)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Rational& a,
                          const Rational& b);
    [[nodiscard]] static mpq_srcptr zero() noexcept;
    // A hollow object owns nothing and means zero: GMP gives every live denominator a limb.
    [[nodiscard]] bool is_hollow() const noexcept { return q_._mp_den._mp_d == nullptr; }

    __mpq_struct q_{};
};

/// The numerator of x in lowest terms, with its sign.
[[nodiscard]] Rational numerator_of(const Rational& x);
/// The denominator of x in lowest terms; positive.
[[nodiscard]] Rational denominator_of(const Rational& x);

/// √x when that is a rational number, else empty; empty for negative x.
[[nodiscard]] std::optional<Rational> rational_square_root(const Rational& x);

/// |x|.
[[nodiscard]] inline Rational abs(const Rational& x) { return x.sign() == Sign::negative ? -x : x; }

/// Sign of a rational number.
[[nodiscard]] inline Sign sign_of(const Rational& x) noexcept { return x.sign(); }

}  // namespace sightline

template <>
struct std::hash<sightline::Rational> {
    std::size_t operator()(const sightline::Rational& x) const noexcept { return x.hash(); }
};
