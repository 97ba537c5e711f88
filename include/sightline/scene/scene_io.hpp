// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "sightline/scene/scene2.hpp"

namespace sightline {

/// The formats of 2D scenes.
enum class SceneFormat2 : std::uint8_t { wkt, geojson, text };

/// How scenes are read.
struct ReadOptions {
    /// The first polygon is the free world and its holes are bodies. Files of our own text, and
    /// GeoJSON with a member "world": true, may say so themselves.
    bool world = false;
    /// Named in error messages; the functions that open a file fill it in.
    std::string file = {};
    /// Collections nested deeper are refused with Errc::limit_reached.
    std::uint32_t max_depth = 64;
    /// Told now and then how much has been read, from 0 to 1.
    std::function<void(double)> progress = {};
};

/// The format that a file's name (.wkt, .geojson, .json, .txt, .scene) or else its first characters
/// tell.
[[nodiscard]] SceneFormat2 scene_format(std::string_view path, std::string_view content);

/// Reads elements, unchecked, in the format that path or content tell; "-" is standard input.
/// The file is mapped, not copied. Fails with cannot_open or as the reader of the format does.
[[nodiscard]] Result<SceneInput2> read_input(const std::string& path,
                                             const ReadOptions& options = {});
/// read_input, then Scene2::make.
[[nodiscard]] Result<Scene2> read_scene(const std::string& path, const ReadOptions& options = {});

/// The elements of a scene: vertices, rings and walls in the scene's own order, so that
/// Scene2::make(to_input(scene)) is the scene again.
[[nodiscard]] SceneInput2 to_input(const Scene2& scene);

/// Writes elements in the given format.
void write_input(std::ostream& out, const SceneInput2& input, SceneFormat2 format);

}  // namespace sightline
