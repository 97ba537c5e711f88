// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sightline/scene/result.hpp"
#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

struct RenderOptions {
    /// Width of the picture in pixels; fonts and line widths stay as they are. At most 8000.
    unsigned width = 1200;
    /// 0: as high as the drawing's shape asks for. At most 8000.
    unsigned height = 0;
    /// Each pixel is the mean of so many squared; makes lines smooth, and lines thinner than a
    /// pixel pale.
    unsigned supersampling = 3;
    /// Whether the column with the legend is drawn.
    bool legend = true;
};

struct ShowOptions {
    unsigned width = 1200;
    unsigned height = 900;
};

/// Whether render_png and show can work: whether the library was built with VTK.
[[nodiscard]] bool has_rendering() noexcept;

/// Draws the list with VTK into a PNG file. Needs no screen: without a usable DISPLAY an Xvfb of
/// our own runs as long as the call does. The file is there complete or not at all.
///
/// Fails with `unsupported` without VTK, or with neither a display nor Xvfb; `bad_parameter` for
/// sizes; `cannot_write`. The same list gives the same bytes with the same VTK and Mesa.
[[nodiscard]] Result<void> render_png(const DrawList& list, const std::string& path,
                                      const RenderOptions& options = {});

/// Opens a window and returns when it is closed or q is pressed. Drag to move, turn the wheel to
/// zoom, r to see everything again. Fails with `unsupported` without VTK or without a display.
[[nodiscard]] Result<void> show(const DrawList& list, const ShowOptions& options = {});

}  // namespace sightline::viz
