// SPDX-License-Identifier: GPL-3.0-or-later
#include "event/scaled_segments.hpp"

#include <gmp.h>

#include <cmath>
#include <limits>

namespace sightline::detail {

namespace {

constexpr std::size_t longest_scale_bits = 4096;

// The least common multiple of all denominators; 1 when it would be very long.
Rational common_denominator(std::span<const RationalSegment3> segments) {
    mpz_t lcm;
    mpz_init_set_ui(lcm, 1);
    for (const RationalSegment3& s : segments) {
        for (const RationalPoint3* p : {&s.source, &s.target}) {
            for (const Rational* x : {&p->x, &p->y, &p->z}) {
                if (mpz_sizeinbase(lcm, 2) > longest_scale_bits) continue;
                mpz_lcm(lcm, lcm, mpq_denref(x->mpq()));
            }
        }
    }
    const bool is_short = mpz_sizeinbase(lcm, 2) <= longest_scale_bits;
    std::string digits(mpz_sizeinbase(lcm, 10) + 2, '\0');
    mpz_get_str(digits.data(), 10, lcm);
    mpz_clear(lcm);
    if (!is_short) return 1;
    return *Rational::parse(std::string_view(digits.c_str()));
}

ErrorBounded bounded(const Rational& x) {
    const double v = x.approx_double();
    if (!std::isfinite(v)) return {v, std::numeric_limits<double>::infinity()};
    if (Rational(v) == x) return ErrorBounded(v);
    return {v, std::abs(v) * 0x1p-52 + std::numeric_limits<double>::denorm_min()};
}

template <typename Number, typename Function>
Ends<Number> mapped(const Ends<Rational>& ends, const Function& f) {
    return {{f(ends.source.x), f(ends.source.y), f(ends.source.z)},
            {f(ends.target.x), f(ends.target.y), f(ends.target.z)}};
}

}  // namespace

ScaledSegments::ScaledSegments(std::span<const RationalSegment3> segments) {
    const Rational scale = common_denominator(segments);
    for (const RationalSegment3& s : segments) {
        exact.push_back({scale * vector_to(s.source), scale * vector_to(s.target)});
        const Ends<Rational>& ends = exact.back();
        bounded.push_back(mapped<ErrorBounded>(ends, detail::bounded));
        rounded.push_back(
            mapped<double>(ends, [](const Rational& x) { return x.approx_double(); }));
        enclosed.push_back(mapped<Interval>(ends, [](const Rational& x) { return enclosure(x); }));
    }
}

}  // namespace sightline::detail
