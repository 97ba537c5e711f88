// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "sightline/event/segment_transversals.hpp"
#include "sightline/event/triangle_tangents.hpp"
#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

struct DrawTransversalsOptions {
    std::string title{};
    Camera camera{};
    /// Of more lines the first ones are drawn, and a note says so.
    std::size_t most_lines = 2000;
};

/// Segments, the lines through four of them, and of families some lines of each range and those
/// that bound a plane's. Each line is drawn from the first to the
/// last of the points where it meets its segments (a little longer).
[[nodiscard]] DrawList draw(std::span<const RationalSegment3> segments,
                            const SegmentTransversals& found,
                            const DrawTransversalsOptions& options = {});

/// The same for the tangents of four triangles.
[[nodiscard]] DrawList draw(const std::array<RationalTriangle3, 4>& triangles,
                            const TriangleTangents& found,
                            const DrawTransversalsOptions& options = {});

}  // namespace sightline::viz
