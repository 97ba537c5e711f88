// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iosfwd>

#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

struct SvgOptions {
    /// Width of the picture in pixels; fonts and line widths stay as they are.
    unsigned width = 1000;
    /// 0: as high as the drawing's shape asks for.
    unsigned height = 0;
    /// Whether the column with the legend is drawn.
    bool legend = true;
    /// Of a layer with more segments than this, an even selection of so many is drawn, and the
    /// legend says so.
    std::size_t max_segments = 400'000;
};

/// Writes the list as one self-contained SVG 1.1 file. Coordinates are rounded to a tenth of a
/// pixel; segments that fall together there are drawn once, and segments with common ends are
/// joined to long paths, so that a graph takes about eight bytes an edge. The same list gives the
/// same bytes.
///
/// Errors are those of the stream, for the caller to test. Cost O(n log n) for n segments.
/// Contract: the list has no camera; SVG knows no depth.
void write_svg(const DrawList& list, std::ostream& out, const SvgOptions& options = {});

}  // namespace sightline::viz
