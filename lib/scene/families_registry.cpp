// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/families_registry.hpp"

#include <charconv>
#include <numeric>
#include <utility>

namespace sightline::families::detail {

namespace {

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

Result<std::uint64_t> parse(std::string_view family, const FamilyParameter& parameter,
                            const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    const bool whole = error == std::errc{} && stopped == end;
    if (whole && value >= parameter.least && value <= parameter.greatest) return value;
    return fail(Errc::bad_parameter,
                "generate " + std::string(family) + ": " + std::string(parameter.name) + " is '" +
                    text + "'; give a whole number from " + std::to_string(parameter.least) +
                    " to " + std::to_string(parameter.greatest));
}

}  // namespace

std::string nearest_names(std::string_view name, std::span<const std::string_view> names) {
    std::vector<std::pair<std::size_t, std::string_view>> ranked;
    for (const std::string_view known : names) {
        const bool related = !name.empty() && (known.find(name) != std::string_view::npos ||
                                               name.find(known) != std::string_view::npos);
        const std::size_t distance = edit_distance(name, known);
        ranked.emplace_back(related ? distance / 4 : distance, known);
    }
    std::partial_sort(ranked.begin(), ranked.begin() + 3, ranked.end());
    return std::string(ranked[0].second) + ", " + std::string(ranked[1].second) + " or " +
           std::string(ranked[2].second);
}

tl::unexpected<Error> no_family(std::string_view name, std::span<const std::string_view> names) {
    return fail(Errc::bad_parameter, "generate: there is no family '" + std::string(name) +
                                         "'; the nearest are " + nearest_names(name, names));
}

Result<std::vector<std::uint64_t>> parse_parameters(std::string_view family,
                                                    std::span<const FamilyParameter> parameters,
                                                    std::span<const std::string> given) {
    if (given.size() > parameters.size()) {
        return fail(Errc::bad_parameter, "generate " + std::string(family) + ": " +
                                             std::to_string(given.size()) +
                                             " parameters given; leave out all after the first " +
                                             std::to_string(parameters.size()));
    }
    std::vector<std::uint64_t> values;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (i >= given.size()) {
            values.push_back(parameters[i].default_value);
            continue;
        }
        const Result<std::uint64_t> value = parse(family, parameters[i], given[i]);
        if (!value) return tl::unexpected<Error>(value.error());
        values.push_back(*value);
    }
    return values;
}

}  // namespace sightline::families::detail
