// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sightline/viz/draw_list.hpp"

class vtkRenderer;

/// Pictures of space: depth decides what hides what, and translucent things are mixed in the order
/// of depth.
namespace sightline::viz::detail {

struct SpaceOptions {
    double scale = 1;       ///< pixels of the window for one of the layout
    bool zoomable = false;  ///< the camera will move: lines keep their width and face it
};

/// Adds what a projected list shows, at the places that `to_world` gives (pixels; z towards the
/// eye). Returns how far the farthest thing is before or behind z = 0.
double add_space(vtkRenderer* renderer, const DrawList& list,
                 const std::function<Position(const Position&)>& to_world,
                 const SpaceOptions& options);

/// How bright a face with this normal is, from 0 to 1, for an eye in direction z; light comes from
/// above, a little from the left.
[[nodiscard]] double brightness(const Position& normal);

}  // namespace sightline::viz::detail
