// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.hpp"
#include "cli/exit_status.hpp"
#include "cli/session.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::detail {

/// `info` on scenes of space.
[[nodiscard]] Result<ExitStatus> run_info3(const SceneArguments& scene,
                                           const OutputArguments& outputs, Session& session);

}  // namespace sightline::detail
