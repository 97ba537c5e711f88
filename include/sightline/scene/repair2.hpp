// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline {

/// A scene that was made valid, and what had to be done.
struct RepairedScene2 {
    Scene2 scene;
    /// The input as repaired; elements that nothing was done to are as they were.
    SceneInput2 input;
    /// A sentence a change, in the order of the changes; empty when the input was valid.
    std::vector<std::string> changes;
};

/// Makes a scene of input that Scene2::make refuses, where that can be done without guessing: removes
/// repeated vertices, walls of length zero, spikes, and rings that have fewer than three distinct vertices
/// left; merges bodies that overlap. With a world, bodies that reach out of it are clipped (merged with
/// its outside). What the union adds as vertices is rounded to the nearest doubles, which is said in
/// `changes`; the result is validated again.
///
/// Fails with what remains wrong: rings that cross themselves, walls and points inside of bodies,
/// coordinates that are not finite, and the rare unions that rounding made invalid.
/// Cost of a union: that of CGAL's arrangement of the overlapping bodies.
[[nodiscard]] Result<RepairedScene2> repair(const SceneInput2& input);

}  // namespace sightline
