// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sightline/event/bitangents.hpp"
#include "sightline/planar/free_bitangents.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// All bitangents by trying every pair of vertices; the definition, transcribed. In both
/// directions, ascending. O(n³).
[[nodiscard]] std::vector<Bitangent> bitangents(const Scene2& scene,
                                                const BitangentOptions& options = {});

/// Those among them whose segment is_free() and contains no scene vertex. O(n³).
[[nodiscard]] std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                                         const FreeBitangentOptions& options = {});

}  // namespace sightline::reference
