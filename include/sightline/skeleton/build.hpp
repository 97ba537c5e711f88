// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline {

struct SkeletonOptions {
    /// `interval` and `double_` may miss or invent nodes; they exist to be measured.
    Arithmetic arithmetic = Arithmetic::filtered;
    /// Counts which tier decided; may be null.
    Tally* tally = nullptr;
};

/// The whole visibility skeleton of a scene.
[[nodiscard]] VisibilitySkeleton visibility_skeleton(const Scene3& scene,
                                                     const SkeletonOptions& options = {});

}  // namespace sightline
