// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "sightline/scene/scene_io.hpp"

namespace sightline {

/// Reads our own text, one ring, wall or point a line:
///
///     world                    the first polygon is the free world; before any polygon
///     polygon x y, x y, x y    a body, or the world
///     hole x y, x y, x y       a hole of the polygon in the lines just before
///     wall x y, x y            a chain of walls
///     point x y                a vertex without edges
///
/// `#` begins a comment. Nothing is checked beyond the syntax. Errors (`file:line:column: …`):
/// syntax; coordinate_too_large for numbers beyond the doubles. Cost: one pass; memory 16 bytes a
/// vertex.
[[nodiscard]] Result<SceneInput2> read_text(std::string_view text, const ReadOptions& options = {});
/// The same from a stream, which is read to its end first.
[[nodiscard]] Result<SceneInput2> read_text(std::istream& in, const ReadOptions& options = {});

/// Writes what read_text reads, with the shortest decimals that read back to the same doubles.
void write_text(std::ostream& out, const SceneInput2& input);

/// The canonical text of a scene: equal scenes have equal texts, and scene_from_text gives the
/// scene back.
[[nodiscard]] std::string to_text(const Scene2& scene);
/// read_text, then Scene2::make.
[[nodiscard]] Result<Scene2> scene_from_text(std::string_view text);

std::ostream& operator<<(std::ostream& out, const Scene2& scene);

}  // namespace sightline
