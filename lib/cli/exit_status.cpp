// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_status.hpp"

namespace sightline::detail {

ExitStatus status_of(Errc code) noexcept {
    switch (code) {
        case Errc::inside_body:
        case Errc::outside_of_world:
        case Errc::unreachable:
        case Errc::limit_reached:
            return ExitStatus::no_answer;
        case Errc::cancelled:
            return ExitStatus::interrupted;
        default:
            return ExitStatus::bad_input;
    }
}

}  // namespace sightline::detail
