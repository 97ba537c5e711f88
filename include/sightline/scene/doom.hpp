// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/scene/result.hpp"
#include "sightline/scene/scene2.hpp"

/// Floor plans of Doom as walls. A WAD file is a list of named lumps; a map is a marker lump (E1M1, MAP07)
/// that the lumps VERTEXES and LINEDEFS, among others, follow. Source: "The Unofficial Doom Specs" 1.666, 1994.
namespace sightline {

struct DoomOptions {
    /// Also the linedefs with a floor on both sides: steps, windows, doors. Otherwise one-sided ones only, which
    /// are what solid walls are made of.
    bool all_lines = false;
};

/// The names of the maps in the bytes of a WAD, in file order: markers that a LINEDEFS lump follows.
[[nodiscard]] Result<std::vector<std::string>> doom_maps(std::span<const std::byte> wad,
                                                         const std::string& file = {});
/// The same for a file.
[[nodiscard]] Result<std::vector<std::string>> doom_maps(const std::string& path);

/// A map as walls, one polyline per maximal chain of linedefs whose inner vertices two lines meet; a closed
/// chain repeats its first point at its end. Linedefs without length and repeats of a linedef are left out. Map
/// names may be given in small letters. Reads Doom's and Hexen's layouts.
///
/// Fails with cannot_open, syntax (no WAD; a directory or lump beyond the end of the file; a linedef with a
/// vertex that isn't there), bad_parameter (no such map: the message says which there are), unsupported
/// (UDMF text maps), empty_scene (no linedef left). O(size of the lumps).
[[nodiscard]] Result<SceneInput2> read_doom(std::span<const std::byte> wad, std::string_view map,
                                            const DoomOptions& options = {},
                                            const std::string& file = {});
/// The same for a file.
[[nodiscard]] Result<SceneInput2> read_doom(const std::string& path, std::string_view map,
                                            const DoomOptions& options = {});

}  // namespace sightline
