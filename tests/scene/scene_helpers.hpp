// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "sightline/scene/wkt.hpp"

namespace sightline::test {

/// Reads and validates.
inline Result<Scene2> make_wkt(std::string_view text, bool world = false) {
    const Result<SceneInput2> input = read_wkt(text, {.world = world});
    if (!input) return tl::unexpected(input.error());
    return Scene2::make(*input);
}

/// A scene that the test knows to be valid.
inline Scene2 scene_of(std::string_view text, bool world = false) {
    Result<Scene2> scene = make_wkt(text, world);
    if (!scene) throw std::invalid_argument(scene.error().message);
    return std::move(*scene);
}

}  // namespace sightline::test
