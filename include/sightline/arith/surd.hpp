// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sightline/arith/interval.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/arith/sign.hpp"

namespace sightline {

/// An exact number a + b·√c with rational a, b and c >= 0: an element of the field Q(√c).
/// Lines that meet four lines have such coordinates.
///
/// A regular value. √c is folded into a when it is rational, so an irrational number has b ≠ 0 and
/// a c that is no square. Equality and order are by value, between any two numbers, whatever their
/// fields; they need no algebraic numbers, only squaring. Sums, products and quotients stay in one
/// field: of two irrational operands the ratio of the c's must be the square of a rational number,
/// or std::domain_error is thrown.
///
/// Laws
///  (1) a field: + and * are associative, commutative and distributive, x / y * y == x
///  (2) sign(x - y), where it can be computed, is the order of x and y
///  (3) the order is total, and agrees with that of Rational
///  (4) Surd(a, b * k, c) == Surd(a, b, k * k * c) for k >= 0
///
/// Cost: products of rationals; a square test when fields are entered or unified.
class Surd {
public:
    /// Zero.
    Surd() noexcept = default;
    /// The rational number itself.
    Surd(Rational a) : a_(std::move(a)) {}  // NOLINT(google-explicit-constructor): Q lies in Q(√c)
    template <std::integral Integer>
    Surd(Integer a) : a_(a) {}  // NOLINT(google-explicit-constructor)
    /// a + b·√c. Throws std::domain_error when c is negative.
    Surd(Rational a, Rational b, Rational c);

    /// √c; throws std::domain_error when c is negative.
    [[nodiscard]] static Surd square_root(Rational c) { return {0, 1, std::move(c)}; }
    /// Reads what to_string() writes. Empty for any other text.
    [[nodiscard]] static std::optional<Surd> parse(std::string_view text);

    [[nodiscard]] bool is_rational() const noexcept { return b_.sign() == Sign::zero; }
    /// a of the form a ± √c.
    [[nodiscard]] const Rational& rational_part() const noexcept { return a_; }
    /// The sign of √c in the form a ± √c; zero for rational numbers.
    [[nodiscard]] Sign root_sign() const noexcept { return b_.sign(); }
    /// c of the form a ± √c: positive and no square; 0 for rational numbers.
    [[nodiscard]] Rational radicand() const { return b_ * b_ * c_; }
    /// a ∓ √c: the other root of the polynomial.
    [[nodiscard]] Surd conjugate() const { return {Valid{}, a_, -b_, c_}; }

    [[nodiscard]] Sign sign() const;

    /// The nearest double, ties to even; ±infinity when the nearest double does not exist.
    [[nodiscard]] double approx_double() const;
    /// "3", "-7/2", "sqrt(2)", "1/2-sqrt(45)": rational part, and the root of the radicand.
    [[nodiscard]] std::string to_string() const;

    [[nodiscard]] Surd operator-() const { return {Valid{}, -a_, -b_, c_}; }
    friend Surd operator+(const Surd& x, const Surd& y);
    [[nodiscard]] friend Surd operator-(const Surd& x, const Surd& y) { return x + -y; }
    friend Surd operator*(const Surd& x, const Surd& y);
    /// Throws std::domain_error when y is zero.
    friend Surd operator/(const Surd& x, const Surd& y);
    Surd& operator+=(const Surd& y) { return *this = *this + y; }
    Surd& operator-=(const Surd& y) { return *this = *this - y; }
    Surd& operator*=(const Surd& y) { return *this = *this * y; }
    Surd& operator/=(const Surd& y) { return *this = *this / y; }

    friend bool operator==(const Surd& x, const Surd& y);
    friend std::strong_ordering operator<=>(const Surd& x, const Surd& y);
    friend std::ostream& operator<<(std::ostream& out, const Surd& x);
    friend Interval enclosure(const Surd& x);

private:
    struct Valid {};
    // c is known to be no square; b may have become zero.
    Surd(Valid, Rational a, Rational b, Rational c);

    Rational a_;
    Rational b_;  // zero exactly when c_ is
    Rational c_;
};

/// Sign of a + b·√c.
[[nodiscard]] inline Sign sign_of(const Surd& x) { return x.sign(); }

/// The sign of a + b·√c + e·√f, for numbers of two different fields; exact, by squaring twice.
/// Throws std::domain_error when c or f is negative.
[[nodiscard]] Sign sign_of_sum(const Rational& a, const Rational& b, const Rational& c,
                               const Rational& e, const Rational& f);

/// The smallest interval with double ends that contains x: one double, or two neighbours.
[[nodiscard]] Interval enclosure(const Surd& x);

}  // namespace sightline
