// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "sightline/scene/scene3.hpp"

namespace sightline {

/// Writes all meshes as one OFF file, vertices and faces numbered through; coordinates are the shortest decimals
/// that read back to the same doubles. Comments tell what OFF can't: a world, and sheets.
void write_off(std::ostream& out, const SceneInput3& input);

}  // namespace sightline
