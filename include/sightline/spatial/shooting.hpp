// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>

#include "sightline/geom/point.hpp"
#include "sightline/spatial/free_segment3.hpp"

namespace sightline {

/// Where a free ray ends.
struct FreeEnd3 {
    /// Empty at infinity.
    std::optional<RationalPoint3> point;
    /// What stops it there.
    SegmentEnd faces;

    friend bool operator==(const FreeEnd3&, const FreeEnd3&) = default;
    /// "(1, 2, 3) | f1 f2-", or "| inf".
    friend std::ostream& operator<<(std::ostream& out, const FreeEnd3& end);
};

}  // namespace sightline
