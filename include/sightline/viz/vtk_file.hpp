// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

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

/// The list as a VTK multi-block file (`.vtm`), one block a layer. The format only names its
/// blocks' files: `write_vtm` writes the index, and `write_vtm_part` block i, whose file beside the
/// index must be called `vtm_parts(list, stem)[i]`: `skeleton_0_faces.vtp` for the stem `skeleton`.
[[nodiscard]] std::vector<std::string> vtm_parts(const DrawList& list, const std::string& stem);
void write_vtm(const DrawList& list, const std::string& stem, std::ostream& out);
void write_vtm_part(const DrawList& list, std::size_t part, std::ostream& out);

}  // namespace sightline::viz
