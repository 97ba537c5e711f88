// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string_view>

#include "sightline/scene/scene_io.hpp"

namespace sightline {

/// Reads well-known text: POLYGON and MULTIPOLYGON (bodies), LINESTRING and MULTILINESTRING
/// (walls), POINT, MULTIPOINT, GEOMETRYCOLLECTION; any number of geometries, separated by white
/// space. A leading `SRID=…;` is skipped, EMPTY gives nothing, a ring's repeated closing vertex is
/// dropped, coordinates are the nearest doubles. Nothing is checked beyond the syntax.
///
/// Errors (`file:line:column: …`): syntax; unsupported for Z, M and curved kinds;
/// coordinate_too_large for numbers beyond the doubles; limit_reached for collections nested too
/// deep. Cost: one pass; memory 16 bytes a vertex.
[[nodiscard]] Result<SceneInput2> read_wkt(std::string_view text, const ReadOptions& options = {});
/// The same from a stream, which is read to its end first.
[[nodiscard]] Result<SceneInput2> read_wkt(std::istream& in, const ReadOptions& options = {});

/// Writes one geometry a line with the shortest decimals that read back to the same doubles. WKT
/// has no place for `world`: whoever reads the text gives it.
void write_wkt(std::ostream& out, const SceneInput2& input);

}  // namespace sightline
