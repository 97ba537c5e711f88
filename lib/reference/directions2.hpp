// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sightline/arith/surd.hpp"

namespace sightline::reference::detail {

using Direction = std::array<Surd, 2>;

/// The directions from `from` counter-clockwise to `to`, both included; less than a full turn.
struct Sector {
    Direction from;
    Direction to;
};

/// Whether, counter-clockwise from `start`, a comes strictly before b; `start` itself comes first.
[[nodiscard]] bool comes_before(const Direction& start, const Direction& a, const Direction& b);

/// Whether all directions lie in sectors.
[[nodiscard]] bool covers_circle(const std::vector<Sector>& sectors);

}  // namespace sightline::reference::detail
