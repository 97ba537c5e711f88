// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sightline/event/transversals.hpp"

namespace sightline::reference {

/// The same as sightline::transversals(), by trying: every place where elements' lines, ends and
/// planes meet may be the centre of a pencil or a bundle, every plane of two of them may hold one;
/// each family is walked from one critical line to the next, and a line belongs when it meets all
/// elements. Thousands of rational operations.
[[nodiscard]] Transversals transversals(std::span<const TransversalElement> elements);

}  // namespace sightline::reference
