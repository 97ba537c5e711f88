// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/exact3.hpp"
#include "reference/line_picture3.hpp"

namespace sightline::reference::detail {

/// (d, m), scaled so that the first nonzero coordinate of d is 1.
using PluckerVector = std::array<Surd, 6>;
[[nodiscard]] PluckerVector plucker_vector(const ExactLine& line);

/// The dimension of what the Plücker vectors of the edges span.
[[nodiscard]] std::size_t rank(const std::vector<const ExactEdge*>& edges);

/// The real lines that meet the lines of all the edges, which span four dimensions: at most two,
/// ascending. Of other edges none: then there are families, or at most one line.
[[nodiscard]] std::vector<PluckerVector> common_transversals(
    const std::vector<const ExactEdge*>& edges);

}  // namespace sightline::reference::detail
