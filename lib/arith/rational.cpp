// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/arith/rational.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace sightline {

namespace {

struct Integer {
    mpz_t z;
    Integer() { mpz_init(z); }
    ~Integer() { mpz_clear(z); }
    Integer(const Integer&) = delete;
    Integer& operator=(const Integer&) = delete;
};

std::string digits_of(mpz_srcptr z) {
    std::string text(mpz_sizeinbase(z, 10) + 2, '\0');
    mpz_get_str(text.data(), 10, z);
    text.resize(std::strlen(text.c_str()));
    return text;
}

std::uint64_t mix(std::uint64_t h, std::uint64_t word) {
    h = (h ^ word) * 0x9e3779b97f4a7c15U;
    return h ^ (h >> 32);
}

std::uint64_t mix(std::uint64_t h, mpz_srcptr z) {
    for (std::size_t i = 0; i < mpz_size(z); ++i) {
        h = mix(h, mpz_getlimbn(z, static_cast<mp_size_t>(i)));
    }
    return h;
}

// The double nearest to (quotient + sticky·ε)·2^-shift, ties to even, for 2^62 <= quotient < 2^64.
double round_to_double(std::uint64_t quotient, bool sticky, long shift) {
    constexpr long lowest_exponent = -1074;
    const long top =
        static_cast<long>(std::bit_width(quotient)) - 1 - shift;  // exponent of the leading bit
    const long unit = std::max(top - 52, lowest_exponent);  // exponent of the result's last bit
    const long dropped = unit + shift;                      // bits of the quotient below it, >= 10
    if (dropped > 64) return 0;
    const std::uint64_t kept = dropped == 64 ? 0 : quotient >> dropped;
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    const std::uint64_t rest = dropped == 64 ? quotient : quotient & ((half << 1) - 1);
    const bool up = rest > half || (rest == half && (sticky || (kept & 1) != 0));
    if (top > 1023) return std::numeric_limits<double>::infinity();
    return std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), static_cast<int>(unit));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Takes the longest prefix of digits off the text.
std::string_view take_digits(std::string_view& text) {
    const auto end = std::ranges::find_if_not(text, is_digit);
    const std::string_view digits(text.begin(), end);
    text.remove_prefix(digits.size());
    return digits;
}

// Takes "+" or "-" off the text; true for a minus.
bool take_sign(std::string_view& text) {
    if (text.empty() || (text.front() != '+' && text.front() != '-')) return false;
    const bool minus = text.front() == '-';
    text.remove_prefix(1);
    return minus;
}

// Takes "e-12" off the text; empty on a syntax error or when too large, 0 when there is none.
std::optional<long> take_exponent(std::string_view& text) {
    if (text.empty() || (text.front() != 'e' && text.front() != 'E')) return 0;
    text.remove_prefix(1);
    const bool minus = take_sign(text);
    const std::string_view digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    long value = 0;
    for (const char c : digits) {
        value = value * 10 + (c - '0');
        if (value > Rational::max_exponent) return std::nullopt;
    }
    return minus ? -value : value;
}

void set_digits(mpz_ptr z, const std::string& digits) { mpz_set_str(z, digits.c_str(), 10); }

}  // namespace

mpq_srcptr Rational::zero() noexcept {
    static mp_limb_t one = 1;
    static const __mpq_struct value{{0, 0, &one}, {1, 1, &one}};
    return &value;
}

void Rational::set(long value) {
    mpq_init(&q_);
    mpz_set_si(mpq_numref(&q_), value);
}

void Rational::set(unsigned long value) {
    mpq_init(&q_);
    mpz_set_ui(mpq_numref(&q_), value);
}

Rational::Rational(double value) {
    if (!std::isfinite(value)) {
        throw std::domain_error("Rational: NaN and infinity are not rational numbers");
    }
    if (value == 0) return;
    mpq_init(&q_);
    mpq_set_d(&q_, value);
}

Rational::Rational(const Rational& numerator, const Rational& denominator) {
    if (denominator.sign() == Sign::zero) throw std::domain_error("Rational: division by zero");
    if (numerator.sign() == Sign::zero) return;
    mpq_init(&q_);
    mpq_div(&q_, numerator.mpq(), denominator.mpq());
}

Rational::Rational(const Rational& other) {
    if (other.is_hollow()) return;
    mpq_init(&q_);
    mpq_set(&q_, &other.q_);
}

Rational& Rational::operator=(const Rational& other) {
    if (this != &other) *this = Rational(other);
    return *this;
}

Rational Rational::apply(void (*operation)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Rational& a,
                         const Rational& b) {
    Rational result;
    mpq_init(&result.q_);
    operation(&result.q_, a.mpq(), b.mpq());
    return result;
}

Rational Rational::operator-() const {
    Rational result(*this);
    if (!result.is_hollow()) mpq_neg(&result.q_, &result.q_);
    return result;
}

bool Rational::is_integer() const noexcept { return mpz_cmp_ui(mpq_denref(mpq()), 1) == 0; }

double Rational::approx_double() const {
    if (sign() == Sign::zero) return 0;
    Integer n;
    Integer d;
    mpz_abs(n.z, mpq_numref(mpq()));
    mpz_set(d.z, mpq_denref(mpq()));
    // n/d lies strictly between 2^(e-1) and 2^(e+1), so that 2^62 <= n·2^shift / d < 2^64.
    const long e =
        static_cast<long>(mpz_sizeinbase(n.z, 2)) - static_cast<long>(mpz_sizeinbase(d.z, 2));
    const long shift = 63 - e;
    if (shift >= 0) {
        mpz_mul_2exp(n.z, n.z, static_cast<mp_bitcnt_t>(shift));
    } else {
        mpz_mul_2exp(d.z, d.z, static_cast<mp_bitcnt_t>(-shift));
    }
    mpz_tdiv_qr(n.z, d.z, n.z, d.z);
    const double magnitude = round_to_double(mpz_get_ui(n.z), mpz_sgn(d.z) != 0, shift);
    return sign() == Sign::negative ? -magnitude : magnitude;
}

std::string Rational::to_string() const {
    return is_integer() ? numerator() : numerator() + "/" + denominator();
}

std::string Rational::numerator() const { return digits_of(mpq_numref(mpq())); }

std::string Rational::denominator() const { return digits_of(mpq_denref(mpq())); }

std::size_t Rational::hash() const noexcept {
    std::uint64_t h = sign() == Sign::negative ? 0x94d049bb133111ebU : 0;
    h = mix(h, mpq_numref(mpq()));
    return mix(mix(h, std::uint64_t{'/'}), mpq_denref(mpq()));
}

std::ostream& operator<<(std::ostream& out, const Rational& x) { return out << x.to_string(); }

Rational numerator_of(const Rational& x) {
    Rational result;
    mpq_init(&result.q_);
    mpz_set(mpq_numref(&result.q_), mpq_numref(x.mpq()));
    return result;
}

Rational denominator_of(const Rational& x) {
    Rational result;
    mpq_init(&result.q_);
    mpz_set(mpq_numref(&result.q_), mpq_denref(x.mpq()));
    return result;
}

std::optional<Rational> rational_square_root(const Rational& x) {
    const mpz_srcptr n = mpq_numref(x.mpq());
    const mpz_srcptr d = mpq_denref(x.mpq());
    if (mpz_perfect_square_p(n) == 0 || mpz_perfect_square_p(d) == 0) return std::nullopt;
    Rational result;
    mpq_init(&result.q_);
    mpz_sqrt(mpq_numref(&result.q_), n);
    mpz_sqrt(mpq_denref(&result.q_), d);
    return result;
}

std::optional<Rational> Rational::parse(std::string_view text) {
    const bool minus = take_sign(text);
    std::string digits(take_digits(text));
    std::string divisor = "1";
    long scale = 0;  // the number is digits / divisor · 10^scale
    if (!digits.empty() && text.starts_with('/')) {
        text.remove_prefix(1);
        divisor = take_digits(text);
    } else {
        if (text.starts_with('.')) {
            text.remove_prefix(1);
            const std::string_view fraction = take_digits(text);
            digits += fraction;
            scale = -static_cast<long>(fraction.size());
        }
        const auto exponent = take_exponent(text);
        if (!exponent) return std::nullopt;
        scale += *exponent;
    }
    if (!text.empty() || digits.empty() || divisor.empty()) return std::nullopt;
    Rational result;
    mpq_init(&result.q_);
    set_digits(mpq_numref(&result.q_), digits);
    set_digits(mpq_denref(&result.q_), divisor);
    if (mpz_sgn(mpq_denref(&result.q_)) == 0) return std::nullopt;
    if (scale != 0 && mpz_sgn(mpq_numref(&result.q_)) != 0) {
        Integer power;
        mpz_ui_pow_ui(power.z, 10, static_cast<unsigned long>(std::abs(scale)));
        const mpz_ptr scaled = scale > 0 ? mpq_numref(&result.q_) : mpq_denref(&result.q_);
        mpz_mul(scaled, scaled, power.z);
    }
    if (minus) mpz_neg(mpq_numref(&result.q_), mpq_numref(&result.q_));
    mpq_canonicalize(&result.q_);
    return result;
}

}  // namespace sightline
