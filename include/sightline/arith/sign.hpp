// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>

namespace sightline {

/// The three-way answer of every predicate.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

[[nodiscard]] constexpr Sign operator-(Sign s) noexcept {
    return static_cast<Sign>(-static_cast<int>(s));
}

[[nodiscard]] constexpr Sign operator*(Sign a, Sign b) noexcept {
    return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

/// Sign of a number that compares with an int; NaN has no sign and gives zero.
template <typename Number>
[[nodiscard]] constexpr Sign sign_of(const Number& x) noexcept(noexcept(x > 0)) {
    return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

/// Which arithmetic settled a sign: doubles (under the policy `double_` without a bound),
/// intervals, exact numbers, or none of them (the policy `interval` may leave a sign undecided).
enum class Tier : std::uint8_t { filter, interval, exact, undecided };

/// A sign together with the tier that decided it.
struct CertifiedSign {
    Sign sign = Sign::zero;
    Tier decided_by = Tier::undecided;

    friend constexpr bool operator==(const CertifiedSign&, const CertifiedSign&) = default;
};

std::ostream& operator<<(std::ostream& out, Sign sign);
std::ostream& operator<<(std::ostream& out, Tier tier);
std::ostream& operator<<(std::ostream& out, const CertifiedSign& sign);

}  // namespace sightline
