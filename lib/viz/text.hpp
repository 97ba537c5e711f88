// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sightline::viz::detail {

/// Text as it may stand in XML 1.0, in attributes too: markup escaped, bytes that are no UTF-8 and
/// characters that XML forbids replaced by U+FFFD.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace sightline::viz::detail
