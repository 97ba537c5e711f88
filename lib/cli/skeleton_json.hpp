// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cli/json_writer.hpp"
#include "sightline/skeleton/visibility_skeleton.hpp"

namespace sightline::detail {

/// Writes the `result` of a visibility skeleton, as docs/command-line.md has it: every node and arc with its
/// features, exact lines computed one by one. With a type given, only the arcs of that type.
void write_skeleton(JsonWriter& json, const Scene3& scene, const VisibilitySkeleton& skeleton,
                    std::optional<ArcType> only);

}  // namespace sightline::detail
