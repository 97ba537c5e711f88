// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/json_writer.hpp"
#include "cli/scene_loading.hpp"
#include "sightline/viz/draw_list.hpp"

namespace sightline::detail {

/// A result as it is written.
struct Document {
    std::string kind;
    const LoadedScene* scene = nullptr;
    const LoadedScene3* scene3 = nullptr;  ///< instead of `scene`
    /// What stands under `scene` when there is neither.
    nlohmann::ordered_json inputs{};
    nlohmann::ordered_json options = nlohmann::ordered_json::object();  ///< beside the scene's own
    bool complete = true;
    std::function<void(JsonWriter&)> result;   ///< writes one value
    std::function<viz::DrawList()> picture{};  ///< asked only for --vtk, --png, --svg
};

/// Before the work: whether what is asked for can be written.
[[nodiscard]] Result<void> check_outputs(const OutputArguments& outputs,
                                         const SceneArguments& scene);

/// Writes all outputs that are asked for; JSON to standard output when none is. All or nothing.
[[nodiscard]] Result<void> write_outputs(const OutputArguments& outputs, const Document& document,
                                         Session& session);

}  // namespace sightline::detail
