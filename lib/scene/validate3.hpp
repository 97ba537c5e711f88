// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether the surfaces of a scene of space bound solids that don't overlap. Private.

#include "scene/features3.hpp"

namespace sightline::detail {

/// What validation finds out besides.
struct Nesting3 {
    /// A component: the component whose cavity it bounds, or itself.
    std::vector<std::uint32_t> owner;
    bool touching = false;
};

/// `features` with components as bodies. Let each solid surface count +1 for the points that it bounds (−1 when it looks
/// inwards, 1 more everywhere with a world). Valid scenes have a count of 0 or 1 everywhere, and sheets where it is 0.
/// It suffices to look at the places where features meet, and at one point of each connected cluster.
[[nodiscard]] Result<Nesting3> validate(const Mesh3& mesh, const Features3& features,
                                        const std::vector<Triangle3>& triangles);

}  // namespace sightline::detail
