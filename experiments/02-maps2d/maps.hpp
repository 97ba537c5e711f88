// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::experiments {

/// A map and what is known about it.
struct Map {
    std::string name;
    SceneInput2 input;
    std::size_t vertices = 0;
    std::size_t all = 0;                    ///< visible pairs, collinear ones included
    std::optional<std::size_t> nearest;     ///< visible pairs with nothing in between
    std::optional<std::size_t> bitangents;  ///< free ones between different polygons
};

/// The maps of expected.csv that are in `folder`, read as worlds; `only` names some, or none for all.
/// Throws when a map can't be read.
[[nodiscard]] std::vector<Map> read_maps(const std::string& folder,
                                         const std::vector<std::string>& only);

/// A map after a rounded transform, valid again.
struct Moved {
    std::string transform;
    Scene2 scene;
    /// What had to be done to make it valid: nothing ("valid"), repairs, holes left out.
    std::string handling;
};

/// The map as it is, rotated by 30° and 17.3°, scaled by 0.1, 1e-8 and 1e8, shifted by 1e8 (also
/// after a rotation), and with about half of all coordinates one ulp off. Every place is moved as a
/// whole: rings that touch in a vertex still do.
[[nodiscard]] std::vector<Moved> moved(const Map& map, std::uint64_t seed);

}  // namespace sightline::experiments
