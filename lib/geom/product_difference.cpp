// SPDX-License-Identifier: GPL-3.0-or-later
#include "geom/product_difference.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "arith/interval_cgal.hpp"

namespace sightline::detail {

namespace {

// Error-free transformations (Dekker, Knuth): head + tail is the exact result.
// They need rounding to nearest, and the bounds checked in `expansion_sign`.
struct Pair {
    double head;
    double tail;
};

Pair two_sum(double a, double b) {
    const double x = a + b;
    const double b_virtual = x - a;
    const double a_virtual = x - b_virtual;
    return {x, (a - a_virtual) + (b - b_virtual)};
}

Pair two_difference(double a, double b) {
    const double x = a - b;
    const double b_virtual = a - x;
    const double a_virtual = x + b_virtual;
    return {x, (a - a_virtual) + (b_virtual - b)};
}

Pair two_product(double a, double b) {
    const double x = a * b;
    return {x, std::fma(a, b, -x)};
}

// A product whose tail is exact: one factor is zero, or the last bits of the factors multiply to
// something above the smallest denormal, for which a product of 2^-960 or more is enough.
bool is_safe_product(double a, double b, double product) {
    return std::abs(product) >= 0x1p-960 || a == 0 || b == 0;
}

// The sign of the exact sum of the terms, by repeated error-free summation: a pass keeps the sum
// and moves it towards the end. When a pass changes nothing, every term is at most half an ulp of
// the next non-zero one, so the last non-zero term has the sign. \cite ogita_rump_oishi_2005
template <std::size_t n>
std::optional<Sign> sum_sign(std::array<double, n> terms) {
    constexpr int max_passes = 64;
    for (int pass = 0; pass < max_passes; ++pass) {
        bool changed = false;
        double rest = 0;
        for (std::size_t i = 1; i < n; ++i) {
            const Pair s = two_sum(terms[i], terms[i - 1]);
            changed = changed || s.head != terms[i] || s.tail != terms[i - 1];
            terms[i] = s.head;
            terms[i - 1] = s.tail;
            rest += std::abs(s.tail);
        }
        // rest is the sum of n - 1 magnitudes, rounded: twice it is more than enough.
        if (std::abs(terms[n - 1]) > 2 * rest) return sign_of(terms[n - 1]);
        if (!changed)
            return sign_of(
                *std::find_if(terms.rbegin(), terms.rend() - 1, [](double t) { return t != 0; }));
    }
    return std::nullopt;
}

// Appends the exact product (x.head + x.tail)(y.head + y.tail)·sign; false when a tail could be
// inexact.
bool append_product(const Pair& x, const Pair& y, double sign, double* terms) {
    const std::array<std::array<double, 2>, 4> factors{
        {{x.tail, y.tail}, {x.tail, y.head}, {x.head, y.tail}, {x.head, y.head}}};
    for (const auto& [a, b] : factors) {
        const Pair product = two_product(a, b);
        if (!is_safe_product(a, b, product.head)) return false;
        *terms++ = sign * product.tail;
        *terms++ = sign * product.head;
    }
    return true;
}

// The same polynomial with all numbers multiplied by a power of two, which its sign does not notice,
// so that the largest is near 1; empty when a number does not survive this unchanged.
std::optional<ProductDifference<double>> normalised(const ProductDifference<double>& f) {
    std::array<double, 8> numbers{f.a, f.b, f.c, f.d, f.e, f.f, f.g, f.h};
    double largest = 0;
    for (const double x : numbers) largest = std::max(largest, std::abs(x));
    if (largest == 0) return f;
    const double scale = std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
    for (double& x : numbers) {
        const double scaled = x * scale;
        if (scaled / scale != x) return std::nullopt;
        x = scaled;
    }
    const auto& [a, b, c, d, e, g, h, k] = numbers;
    return ProductDifference<double>{a, b, c, d, e, g, h, k};
}

bool is_moderate(const ProductDifference<double>& f) {
    constexpr double limit = 0x1p500;
    return std::abs(f.a) <= limit && std::abs(f.b) <= limit && std::abs(f.c) <= limit &&
           std::abs(f.d) <= limit && std::abs(f.e) <= limit && std::abs(f.f) <= limit &&
           std::abs(f.g) <= limit && std::abs(f.h) <= limit;
}

// Exact sign by floating-point expansions; empty when something could overflow or underflow.
std::optional<Sign> expansion_sign(const ProductDifference<double>& f) {
    if (!is_moderate(f)) return std::nullopt;
    const Pair x1 = two_difference(f.a, f.b);
    const Pair y1 = two_difference(f.c, f.d);
    const Pair x2 = two_difference(f.e, f.f);
    const Pair y2 = two_difference(f.g, f.h);
    if (x1.tail == 0 && y1.tail == 0 && x2.tail == 0 && y2.tail == 0) {
        const Pair p = two_product(x1.head, y1.head);
        const Pair q = two_product(x2.head, y2.head);
        // Rounding is monotone: unequal rounded products are ordered like the exact ones.
        if (p.head != q.head) return sign_of(p.head - q.head);
        if (!is_safe_product(x1.head, y1.head, p.head)) return std::nullopt;
        if (!is_safe_product(x2.head, y2.head, q.head)) return std::nullopt;
        return sign_of(p.tail - q.tail);
    }
    std::array<double, 16> terms;
    if (!append_product(x1, y1, 1, terms.data())) return std::nullopt;
    if (!append_product(x2, y2, -1, terms.data() + 8)) return std::nullopt;
    return sum_sign(terms);
}

// GMP integers, kept by a thread: initialising them costs more than using them.
struct Workspace {
    std::array<mpz_t, 8> z;
    Workspace() {
        for (auto& x : z) mpz_init(x);
    }
    ~Workspace() {
        for (auto& x : z) mpz_clear(x);
    }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
};

// Exact sign by integers: all numbers are scaled by one power of two, which the sign of a
// homogeneous polynomial does not notice.
Sign integer_sign(const ProductDifference<double>& f) {
    const std::array<double, 8> numbers{f.a, f.b, f.c, f.d, f.e, f.f, f.g, f.h};
    int lowest = std::numeric_limits<int>::max();
    for (const double x : numbers) {
        int exponent = 0;
        if (std::frexp(x, &exponent) != 0) lowest = std::min(lowest, exponent);
    }
    static thread_local Workspace workspace;
    auto& z = workspace.z;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        int exponent = 0;
        const double fraction = std::frexp(numbers[i], &exponent);
        mpz_set_si(z[i], static_cast<std::int64_t>(std::ldexp(fraction, 53)));
        if (fraction != 0) mpz_mul_2exp(z[i], z[i], static_cast<mp_bitcnt_t>(exponent - lowest));
    }
    for (std::size_t i = 0; i < numbers.size(); i += 2) mpz_sub(z[i], z[i], z[i + 1]);
    mpz_mul(z[0], z[0], z[2]);
    mpz_submul(z[0], z[4], z[6]);
    return static_cast<Sign>(mpz_sgn(z[0]));
}

}  // namespace

// Not inlined, so that no double operation strays into the scope that rounds upward.
[[gnu::noinline]] std::optional<Sign> interval_sign(const ProductDifference<double>& f) {
    const RoundingUp scope;
    return certain_sign(
        ProductDifference<IntervalNumber>{f.a, f.b, f.c, f.d, f.e, f.f, f.g, f.h}.value());
}

[[gnu::noinline]] Sign exact_sign(const ProductDifference<double>& f) {
    if (const auto sign = expansion_sign(f)) return *sign;
    if (const auto near_one = normalised(f)) {
        if (const auto sign = expansion_sign(*near_one)) return *sign;
    }
    return integer_sign(f);
}

CertifiedSign sign_after_filter(const ProductDifference<double>& f) {
    if (const auto sign = interval_sign(f)) return {*sign, Tier::interval};
    return {exact_sign(f), Tier::exact};
}

}  // namespace sightline::detail
