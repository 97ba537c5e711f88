// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/surd.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace sightline {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::string_view root_word = "sqrt(";

// The sign of p + q when sign(p) and sign(q) are known, and that of p² - q² on demand.
template <typename SignOfDifferenceOfSquares>
Sign sign_of_two(Sign p, Sign q, const SignOfDifferenceOfSquares& squares) {
    if (p == Sign::zero) return q;
    if (q == Sign::zero || p == q) return p;
    return p * squares();
}

// sign of a + b√c, c >= 0.
Sign sign_by_squares(const Rational& a, const Rational& b, const Rational& c) {
    const Sign root = c.sign() == Sign::zero ? Sign::zero : b.sign();
    return sign_of_two(a.sign(), root, [&] { return (a * a - b * b * c).sign(); });
}

void require_not_negative(const Rational& radicand) {
    if (radicand.sign() == Sign::negative) {
        throw std::domain_error("Surd: square root of a negative number");
    }
}

// k with √of = k·√by, for two numbers that are not squares.
Rational ratio_of_roots(const Rational& of, const Rational& by) {
    if (of == by) return 1;
    const auto ratio = rational_square_root(of / by);
    if (!ratio) throw std::domain_error("Surd: operands of two different quadratic fields");
    return *ratio;
}

// An MPFR number, owned.
class Float {
public:
    explicit Float(mpfr_prec_t bits) { mpfr_init2(x_, bits); }
    ~Float() { mpfr_clear(x_); }
    Float(const Float&) = delete;
    Float& operator=(const Float&) = delete;
    [[nodiscard]] mpfr_ptr get() { return x_; }

private:
    mpfr_t x_;
};

// a ± √r with so many bits, rounded down or up as a whole.
double rounded(const Surd& x, const Rational& r, mpfr_prec_t bits, mpfr_rnd_t round) {
    const bool minus = x.root_sign() == Sign::negative;
    const mpfr_rnd_t opposite = round == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
    Float root(bits);
    mpfr_set_q(root.get(), r.mpq(), minus ? opposite : round);
    mpfr_sqrt(root.get(), root.get(), minus ? opposite : round);
    if (minus) mpfr_neg(root.get(), root.get(), MPFR_RNDN);
    mpfr_add_q(root.get(), root.get(), x.rational_part().mpq(), round);
    return mpfr_get_d(root.get(), round);
}

}  // namespace

Surd::Surd(Rational a, Rational b, Rational c) : a_(std::move(a)) {
    require_not_negative(c);
    if (b.sign() == Sign::zero || c.sign() == Sign::zero) return;
    if (const auto root = rational_square_root(c)) {
        a_ += b * *root;
        return;
    }
    b_ = std::move(b);
    c_ = std::move(c);
}

Surd::Surd(Valid, Rational a, Rational b, Rational c)
    : a_(std::move(a)), b_(std::move(b)), c_(std::move(c)) {
    if (b_.sign() == Sign::zero) c_ = Rational();
}

Sign Surd::sign() const { return sign_by_squares(a_, b_, c_); }

Surd operator+(const Surd& x, const Surd& y) {
    if (y.is_rational()) return {Surd::Valid{}, x.a_ + y.a_, x.b_, x.c_};
    if (x.is_rational()) return {Surd::Valid{}, x.a_ + y.a_, y.b_, y.c_};
    return {Surd::Valid{}, x.a_ + y.a_, x.b_ + y.b_ * ratio_of_roots(y.c_, x.c_), x.c_};
}

Surd operator*(const Surd& x, const Surd& y) {
    if (y.is_rational()) return {Surd::Valid{}, x.a_ * y.a_, x.b_ * y.a_, x.c_};
    if (x.is_rational()) return {Surd::Valid{}, x.a_ * y.a_, y.b_ * x.a_, y.c_};
    const Rational b = y.b_ * ratio_of_roots(y.c_, x.c_);
    return {Surd::Valid{}, x.a_ * y.a_ + x.b_ * b * x.c_, x.a_ * b + x.b_ * y.a_, x.c_};
}

Surd operator/(const Surd& x, const Surd& y) {
    // The norm of a number other than zero is not zero, as its radicand is no square.
    const Rational norm = y.a_ * y.a_ - y.b_ * y.b_ * y.c_;
    if (norm.sign() == Sign::zero) throw std::domain_error("Surd: division by zero");
    return x * Surd(Surd::Valid{}, y.a_ / norm, -y.b_ / norm, y.c_);
}

// 1, √c and √f are linearly independent when neither c, f nor c/f is a square.
bool operator==(const Surd& x, const Surd& y) {
    if (x.a_ != y.a_ || x.b_.sign() != y.b_.sign()) return false;
    return x.c_ == y.c_ ? x.b_ == y.b_ : x.radicand() == y.radicand();
}

std::strong_ordering operator<=>(const Surd& x, const Surd& y) {
    if (x.is_rational() && y.is_rational()) return x.a_ <=> y.a_;
    const Sign sign = sign_of_sum(x.a_ - y.a_, x.b_, x.c_, -y.b_, y.c_);
    return static_cast<int>(sign) <=> 0;
}

Sign sign_of_sum(const Rational& a, const Rational& b, const Rational& c, const Rational& e,
                 const Rational& f) {
    require_not_negative(c);
    require_not_negative(f);
    if (c == f) return sign_by_squares(a, b + e, c);
    const Sign q = f.sign() == Sign::zero ? Sign::zero : e.sign();
    // (a + b√c)² - (e√f)² lies in Q(√c).
    return sign_of_two(sign_by_squares(a, b, c), q, [&] {
        return sign_by_squares(a * a + b * b * c - e * e * f, a * b * 2, c);
    });
}

Interval enclosure(const Surd& x) {
    if (x.is_rational()) return enclosure(x.rational_part());
    const Rational r = x.radicand();
    // x is irrational, so that some precision separates it from the doubles beside it.
    for (mpfr_prec_t bits = 128;; bits *= 2) {
        const Interval result{rounded(x, r, bits, MPFR_RNDD), rounded(x, r, bits, MPFR_RNDU)};
        if (std::nextafter(result.lower, infinity) == result.upper) return result;
    }
}

double Surd::approx_double() const {
    if (is_rational()) return a_.approx_double();
    const auto [lower, upper] = enclosure(*this);
    constexpr double largest = std::numeric_limits<double>::max();
    // Beyond the largest double a half of its last place decides, as for finite neighbours.
    const Rational half_place(0x1p970);
    if (std::isinf(upper)) return *this > Rational(largest) + half_place ? infinity : largest;
    if (std::isinf(lower)) return *this < -Rational(largest) - half_place ? -infinity : -largest;
    const Rational middle = (Rational(lower) + Rational(upper)) / 2;
    return *this > middle ? upper : lower;
}

std::string Surd::to_string() const {
    if (is_rational()) return a_.to_string();
    const char* sign = b_.sign() == Sign::negative ? "-" : a_.sign() == Sign::zero ? "" : "+";
    const std::string first = a_.sign() == Sign::zero ? "" : a_.to_string();
    return first + sign + std::string(root_word) + radicand().to_string() + ")";
}

std::optional<Surd> Surd::parse(std::string_view text) {
    const auto at = text.find(root_word);
    if (at == std::string_view::npos) {
        const auto a = Rational::parse(text);
        return a ? std::optional<Surd>(*a) : std::nullopt;
    }
    std::string_view first = text.substr(0, at);
    std::string_view inner = text.substr(at + root_word.size());
    if (!inner.ends_with(')')) return std::nullopt;
    inner.remove_suffix(1);
    Rational b = 1;
    if (first.ends_with('-') || first.ends_with('+')) {
        if (first.back() == '-') b = -1;
        first.remove_suffix(1);
    } else if (!first.empty()) {
        return std::nullopt;
    }
    const auto a = first.empty() ? std::optional<Rational>(0) : Rational::parse(first);
    const auto c = Rational::parse(inner);
    if (!a || !c || c->sign() == Sign::negative) return std::nullopt;
    return Surd(*a, b, *c);
}

std::ostream& operator<<(std::ostream& out, const Surd& x) { return out << x.to_string(); }

}  // namespace sightline
