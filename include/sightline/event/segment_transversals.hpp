// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/event/transversals.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

/// Numbers of four segments, ascending.
using SegmentSupport = std::array<std::uint32_t, 4>;

/// The lines through four of many segments.
struct SegmentTransversals {
    struct Line {
        SegmentSupport support;
        std::uint8_t root = 0;  ///< rule (5) of transversals.hpp
        friend auto operator<=>(const Line&, const Line&) = default;
    };
    struct Component {
        SegmentSupport support;
        TransversalComponent component;
        friend bool operator==(const Component&, const Component&) = default;
    };
    std::vector<Line> lines;            ///< ascending
    std::vector<Component> components;  ///< ascending by support

    friend bool operator==(const SegmentTransversals&, const SegmentTransversals&) = default;
};

struct TransversalOptions {
    /// `interval` leaves out the quadruples that it cannot decide; `double_` knows no degenerate
    /// case, and takes two segments for skew unless its determinant is zero. Both may be wrong.
    Arithmetic arithmetic = Arithmetic::filtered;
    /// Counts each quadruple under transversals3 by the tier that decided it.
    Tally* tally = nullptr;
    /// `max_elements` bounds lines and components together.
    Limits limits;
};

/// For every four of the segments, what transversals() says: isolated lines, and components. A line
/// that meets five of them is listed for each four of these.
/// Errors: limit_reached, cancelled.
/// Cost: one look at each of the n⁴/24 quadruples, a fraction of a microsecond where no two of the
/// four are coplanar; exact numbers only where doubles with a certified bound don't decide.
[[nodiscard]] Result<SegmentTransversals> transversals(std::span<const RationalSegment3> segments,
                                                       const TransversalOptions& options = {});

/// The exact line; scaled. Contract: transversals() lists it for these segments.
[[nodiscard]] SurdLine3 exact_line(std::span<const RationalSegment3> segments,
                                   const SegmentTransversals::Line& line);

}  // namespace sightline
