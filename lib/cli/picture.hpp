// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "cli/result_file.hpp"
#include "cli/session.hpp"
#include "sightline/viz/draw.hpp"
#include "sightline/viz/draw3.hpp"
#include "sightline/viz/draw_list.hpp"

namespace sightline::detail {

/// The scene with everything that the results say.
[[nodiscard]] Result<viz::DrawList> picture_of(const Scene2& scene,
                                               std::span<const ResultFile> results,
                                               viz::DrawOptions options);

/// How a scene of space is looked at.
struct CameraArguments {
    std::string look_from;     ///< X,Y,Z, towards the eye; empty: isometric
    bool see_through = false;  ///< faces of solids are like glass
};
[[nodiscard]] Result<viz::DrawOptions3> options_of(const CameraArguments& arguments);

/// Scene and result files, as `render` and `show` take them, in any order.
struct PictureArguments {
    SceneArguments scene;
    std::string title;
    bool vertices = false;
    bool labels = false;
    CameraArguments camera;
    std::string arcs;  ///< of skeletons: which are drawn
};
[[nodiscard]] Result<viz::DrawList> load_picture(const PictureArguments& arguments,
                                                 Session& session);

}  // namespace sightline::detail
