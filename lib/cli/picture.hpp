// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/result_file.hpp"
#include "cli/session.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/draw_list.hpp"

namespace sightline::detail {

/// The scene with everything that the results say.
[[nodiscard]] Result<viz::DrawList> picture_of(const Scene2& scene,
                                               std::span<const ResultFile> results,
                                               viz::DrawOptions options);

/// Scene and result files, as `render` and `show` take them, in any order.
struct PictureArguments {
    SceneArguments scene;
    std::string title;
    bool vertices = false;
    bool labels = false;
};
[[nodiscard]] Result<viz::DrawList> load_picture(const PictureArguments& arguments,
                                                 Session& session);

}  // namespace sightline::detail
