// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/skeleton/visibility_skeleton.hpp"
#include "skeleton/parameter.hpp"

namespace sightline::detail {

/// Which of the lines that share the node's support lies at t of the curve (see Root).
[[nodiscard]] Root root_of(const Curve& curve, const Parameter& t, const Line& line,
                           const SkeletonNode& node);

}  // namespace sightline::detail
