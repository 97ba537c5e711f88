// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sightline {

/// How the sign of a predicate's polynomial is computed; chosen at run time for every predicate.
///
/// - `filtered`: doubles with a derived error bound, then intervals, then exact numbers. Always
///   right.
/// - `exact`: exact numbers at once. Always right; the yardstick.
/// - `interval`: intervals only; an undecided sign is taken as zero and counted. May be wrong.
/// - `double_`: plain doubles, the sign of whatever comes out. May be wrong.
enum class Arithmetic : std::uint8_t { filtered, exact, interval, double_ };

}  // namespace sightline
