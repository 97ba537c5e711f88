// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "sightline/scene/result.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline {

struct SkeletonCheckOptions {
    std::uint64_t seed = 1;
    /// How many paths are walked. One in two crosses an arc of the skeleton on purpose, the next one in an order
    /// drawn by chance; so twice the number of arcs tests every arc.
    std::size_t families = 200;
    /// Random samples on each path, beside those between neighbouring crossings.
    std::size_t samples = 8;
};

/// What a check found.
struct SkeletonCheck {
    std::size_t families = 0;    ///< paths walked
    std::size_t shots = 0;       ///< lines cut
    std::size_t crossings = 0;   ///< found by shooting, and listed
    std::size_t missing = 0;     ///< found by shooting, but no arc of the skeleton is there
    std::size_t false_arcs = 0;  ///< crossings of arcs that shooting does not find
    /// The first of the mismatches, a line each.
    std::vector<std::string> mismatches;

    [[nodiscard]] bool passes() const noexcept { return missing == 0 && false_arcs == 0; }
    /// "200 families, 1234 crossings matched, 0 missing, 0 false".
    friend std::ostream& operator<<(std::ostream& out, const SkeletonCheck& check);
};

/// Compares a skeleton with exact shooting, without a second skeleton.
///
/// Walks random paths of lines in random two-parameter families: all lines through a vertex, or all lines that
/// meet two given skew edges in one free segment. Along a path, support and ends of the segment that touches the
/// generators may change only where the path crosses an arc of the skeleton. Where a line of the path meets
/// another edge inside, and between these lines and at random ones, the segment is cut out exactly.
/// - A line whose label differs from those on both sides is a crossing: exactly one arc must have that
///   label and this line strictly between its nodes' lines, else an arc is missing.
/// - An arc that has such a line strictly between its nodes' lines must be found so, else it is false.
/// - A label that changes without a crossing between is isolated by bisection; an arc is missing there.
///
/// Sides of sheets are not compared at ends where several faces meet. Tells nothing about nodes but that they bound the arcs. Errors: limit_reached and cancelled.
/// Cost: O(n) exact polynomials and some ten shots a path.
[[nodiscard]] Result<SkeletonCheck> check_skeleton(const Scene3& scene,
                                                   const VisibilitySkeleton& skeleton,
                                                   const SkeletonCheckOptions& options = {},
                                                   const Limits& limits = {});

}  // namespace sightline
