// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sightline/scene/scene3.hpp"

namespace sightline {

/// A scene of space that was made valid, and what had to be done.
struct RepairedScene3 {
    Scene3 scene;
    /// The input as repaired; numbers are others where vertices or faces were removed.
    SceneInput3 input;
    /// A sentence a change, in the order of the changes; empty when the input was valid.
    std::vector<std::string> changes;
};

/// Makes a scene of input that Scene3::make refuses, where that can be done without guessing. In each mesh it
/// - merges vertices at one place and removes those that no face uses,
/// - removes repeated corners and spikes of faces, faces without area, and faces that come twice,
/// - cuts faces that are not planar into triangles,
/// - turns faces of solids so that neighbours agree, and solids that look inwards (with what is inside of them).
/// Valid input is left as it is.
///
/// Fails with what remains wrong: open solids, surfaces that cross, bodies that overlap, sheets that have to be cut.
/// Cost as Scene3::make.
[[nodiscard]] Result<RepairedScene3> repair(const SceneInput3& input);

}  // namespace sightline
