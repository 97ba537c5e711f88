// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string_view>

#include "sightline/scene/scene_io.hpp"

namespace sightline {

/// Reads GeoJSON: a geometry (Polygon, MultiPolygon: bodies; LineString, MultiLineString: walls;
/// Point, MultiPoint; GeometryCollection), a Feature or a FeatureCollection. Streamed, no tree is
/// built. Other members are skipped, except `"world": true` of the outermost object, which says
/// what ReadOptions::world says. A ring's repeated closing vertex is dropped; coordinates are the
/// nearest doubles. Nothing is checked beyond the syntax.
///
/// Errors (`file:line:column: …`): syntax; unsupported for other types and for a third coordinate;
/// coordinate_too_large for numbers beyond the doubles; limit_reached for too deep nesting.
/// Cost: one pass; memory 16 bytes a vertex.
[[nodiscard]] Result<SceneInput2> read_geojson(std::string_view text,
                                               const ReadOptions& options = {});
/// The same from a stream, which is read to its end first.
[[nodiscard]] Result<SceneInput2> read_geojson(std::istream& in, const ReadOptions& options = {});

/// Writes a GeometryCollection, a geometry a line, with the shortest decimals that read back to the
/// same doubles, and `"world": true` when the input says so. Coordinates must be finite: JSON has
/// no others.
void write_geojson(std::ostream& out, const SceneInput2& input);

}  // namespace sightline
