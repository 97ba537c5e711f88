// SPDX-License-Identifier: GPL-3.0-or-later
// Families by name: what the registries of 2D and 3D scenes share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/scene/families.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::families::detail {

/// The three names nearest to an unknown one; names that contain it, or it them, come first. At least three names.
[[nodiscard]] std::string nearest_names(std::string_view name,
                                        std::span<const std::string_view> names);

/// Values of all parameters: those given, parsed and checked, then defaults.
[[nodiscard]] Result<std::vector<std::uint64_t>> parse_parameters(
    std::string_view family, std::span<const FamilyParameter> parameters,
    std::span<const std::string> given);

/// The error for a name that is not in the table.
[[nodiscard]] tl::unexpected<Error> no_family(std::string_view name,
                                              std::span<const std::string_view> names);

/// The scene of the family of that name in a table of FamilyInfo or FamilyInfo3.
template <typename Table>
[[nodiscard]] auto generate_by_name(const Table& table, std::string_view name,
                                    std::span<const std::string> given, std::uint64_t seed)
    -> Result<decltype(std::begin(table)->generate({}, seed))> {
    const auto* const family = std::find_if(std::begin(table), std::end(table),
                                            [&](const auto& f) { return f.name == name; });
    if (family == std::end(table)) {
        std::vector<std::string_view> names;
        for (const auto& f : table) names.push_back(f.name);
        return no_family(name, names);
    }
    const auto values = parse_parameters(name, family->parameters, given);
    if (!values) return tl::unexpected<Error>(values.error());
    return family->generate(*values, seed);
}

}  // namespace sightline::families::detail
