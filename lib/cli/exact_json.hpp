// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "cli/json_writer.hpp"
#include "sightline/geom/plucker.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/scene/result.hpp"

/// Exact numbers and points, from the command line and in JSON.
namespace sightline::detail {

/// "1.5,-7/2": decimals are taken exactly. `option` is named in the error.
[[nodiscard]] Result<RationalPoint2> parse_point(const std::string& option, std::string_view text);
/// The same for a point that becomes part of a scene: each number is the nearest double.
[[nodiscard]] Result<Point2> parse_scene_point(const std::string& option, std::string_view text);

/// ["3/2", "-7/2"]
void write_point(JsonWriter& json, const RationalPoint2& p);
void write_point(JsonWriter& json, const Point2& p);
/// "3/2", or {"a": "1/2", "b": "-1", "c": "45"} for a - √c.
void write_number(JsonWriter& json, const Surd& x);
/// The six coordinates: direction, then moment.
void write_line(JsonWriter& json, const SurdLine3& line);
[[nodiscard]] nlohmann::ordered_json to_json(const RationalPoint2& p);
[[nodiscard]] nlohmann::ordered_json to_json(const Point2& p);

}  // namespace sightline::detail
