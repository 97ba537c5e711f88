// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/session.hpp"

namespace sightline::detail {

struct SpaceTorture {
    std::vector<std::string> families;  ///< with their parameters, "grid3 2 2 1"; empty: a battery
    std::uint64_t seed = 1;
    std::string output;  ///< JSON; may be empty
};

/// The battery in space: visibility skeletons with filtered arithmetic, which have to be those of exact
/// arithmetic, and with plain doubles. Prints a table.
[[nodiscard]] Result<ExitStatus> torture_space(const SpaceTorture& torture, Session& session);

}  // namespace sightline::detail
