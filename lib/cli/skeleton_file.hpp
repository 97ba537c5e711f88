// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sightline/scene/scene3.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"
#include "sightline/viz/draw_skeleton.hpp"

namespace sightline::detail {

/// The skeleton that `sightline skeleton` wrote, as the `result` of its document; `path` is for messages. Where a sheet
/// has several edges between two vertices, the first one stands for all.
///
/// Fails with syntax when the text is not as the program writes it, with bad_parameter when it names features that
/// the scene does not have.
[[nodiscard]] Result<VisibilitySkeleton> skeleton_of(const nlohmann::json& result,
                                                     const Scene3& scene, const std::string& path);

/// Chooses the arcs to draw: types and numbers, as in "EEE" or "12,40,EV"; empty: all.
[[nodiscard]] Result<void> choose_arcs(const std::string& text, const VisibilitySkeleton& skeleton,
                                       viz::SkeletonDrawOptions& options);

}  // namespace sightline::detail
