// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/event/transversals.hpp"
#include "sightline/scene/result.hpp"

namespace sightline {

/// Three points that are not collinear.
using RationalTriangle3 = std::array<RationalPoint3, 3>;

/// Reads segments: six numbers each, decimal or p/q, taken exactly; white space and line breaks are
/// free, `#` begins a comment. `name` stands for the text in errors, which name line and segment.
/// Segments of length zero are allowed: they are points.
/// Errors: syntax (no number; numbers left over), empty_scene.
[[nodiscard]] Result<std::vector<RationalSegment3>> read_segments(std::string_view text,
                                                                  const std::string& name);

/// Reads triangles: nine numbers each, otherwise the same.
/// Errors: also zero_length for three collinear points.
[[nodiscard]] Result<std::vector<RationalTriangle3>> read_triangles(std::string_view text,
                                                                    const std::string& name);

}  // namespace sightline
