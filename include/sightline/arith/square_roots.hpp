// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sightline/arith/interval.hpp"
#include "sightline/arith/rational.hpp"
#include "sightline/arith/sign.hpp"

/// Sums of square roots of rational numbers: lengths of polygonal paths.
///
/// Radicands must not be negative, or std::domain_error is thrown.

namespace sightline {

/// An interval that contains √s₁ + √s₂ + …, computed with so many bits (at least 2) and rounded
/// outward to doubles. With 64 bits or more its ends are neighbouring doubles or nearly so, unless
/// the sum is very long. Cost: proportional to squares.size().
[[nodiscard]] Interval sum_of_square_roots(std::span<const Rational> squares,
                                           unsigned precision_bits = 64);

/// The sign of (√a₁ + √a₂ + …) - (√b₁ + √b₂ + …).
///
/// 64-bit intervals settle most cases (decided_by interval). Otherwise roots whose ratio is rational
/// are merged: the sums are equal exactly when all merged coefficients vanish, since square roots
/// of different square classes are linearly independent over the rationals. Unequal sums are then
/// separated by doubling the precision (decided_by exact). Only when max_bits do not suffice for
/// that is the answer {zero, undecided}; equal sums are always recognised.
///
/// Laws
///  (1) exchanging a and b flips the sign
///  (2) appending the same radicand to both sides changes nothing
///  (3) replacing a radicand 4x by x, x changes nothing
///
/// Cost: one pass if intervals decide, else quadratic in the number of square classes.
/// \cite besicovitch_1940
[[nodiscard]] CertifiedSign compare_sums_of_square_roots(std::span<const Rational> a,
                                                         std::span<const Rational> b,
                                                         unsigned max_bits = 1U << 16);

}  // namespace sightline
