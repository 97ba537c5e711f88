// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "sightline/viz/draw_list.hpp"

namespace sightline::viz {

/// Writes the list as VTK polydata (`.vtp`, XML with everything as text), which ParaView and VTK
/// read; needs no VTK. Coordinates are those of the list, written so that they read back as the
/// same doubles.
///
/// Points become vertices; segments, polylines and outlines lines; filled polygons triangles.
/// Cell data: `layer`, the place in the field data `layers` (their names), and `id`, the id of the
/// thing in the layer: all triangles of a polygon have its id. Positions that are equal are one
/// point. Labels, title and styles have no place in the format.
///
/// Errors are those of the stream, for the caller to test. Cost O(n log n).
void write_vtp(const DrawList& list, std::ostream& out);

}  // namespace sightline::viz
