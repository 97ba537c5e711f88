// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sightline/scene/result.hpp"

namespace sightline::detail {

/// How the program ends; the numbers are part of the interface.
enum class ExitStatus : std::uint8_t {
    done = 0,
    no_answer = 1,     ///< unreachable, inside a body, a limit was reached, a difference was found
    bad_input = 2,     ///< usage, files, scenes, parameters
    bug = 3,           ///< ours
    interrupted = 130  ///< SIGINT or SIGTERM
};

/// The status that an error of the library leads to.
[[nodiscard]] ExitStatus status_of(Errc code) noexcept;

}  // namespace sightline::detail
