// SPDX-License-Identifier: GPL-3.0-or-later
#include "02-maps2d/maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>

#include "sightline/scene/repair2.hpp"
#include "sightline/scene/scene_io.hpp"
#include "sightline/scene/transform2.hpp"

namespace sightline::experiments {
namespace {

std::optional<std::size_t> number(const std::string& text) {
    if (text.empty()) return std::nullopt;
    return std::stoul(text);
}

// Like families::Nudge, but the same for all vertices of a place.
SceneInput2 one_ulp_off(SceneInput2 input, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto nudged = [&](double x) {
        const std::uint64_t r = random();
        if ((r & 1U) == 0) return x;
        const double towards = (r & 2U) == 0 ? -1.0 : 1.0;
        return std::nextafter(x, towards * std::numeric_limits<double>::infinity());
    };
    std::map<std::pair<double, double>, Point2> places;
    const auto nudge = [&](Point2& p) {
        const auto [place, is_new] = places.try_emplace({p.x, p.y});
        if (is_new) {
            place->second.x = nudged(p.x);
            place->second.y = nudged(p.y);
        }
        p = place->second;
    };
    for (SceneElement2& element : input.elements) {
        auto& polygon = std::get<Polygon2>(element);
        std::ranges::for_each(polygon.outer, nudge);
        for (auto& hole : polygon.holes) std::ranges::for_each(hole, nudge);
    }
    return input;
}

// The hole that the validation complains about, if it is one of the world.
std::optional<std::size_t> hole_named_in(const std::string& message) {
    const std::string word = "hole ";
    const std::size_t at = message.find(word);
    if (at == std::string::npos) return std::nullopt;
    std::size_t hole = 0;
    const char* first = message.data() + at + word.size();
    const auto read = std::from_chars(first, message.data() + message.size(), hole);
    if (read.ec != std::errc{}) return std::nullopt;
    return hole;
}

// Rounding may let rings that touched cross: then overlaps are merged, and what can't be is left out.
Moved made_valid(std::string transform, SceneInput2 input) {
    std::size_t dropped = 0;
    for (;;) {
        auto scene = Scene2::make(input);
        if (scene) {
            const std::string handling =
                dropped == 0 ? "valid" : fmt::format("{} holes left out", dropped);
            return {std::move(transform), std::move(*scene), handling};
        }
        if (auto repaired = repair(input)) {
            return {
                std::move(transform), std::move(repaired->scene),
                fmt::format("{} repairs + {} holes left out", repaired->changes.size(), dropped)};
        }
        const auto hole = hole_named_in(scene.error().message);
        auto& holes = std::get<Polygon2>(input.elements.front()).holes;
        if (!hole || *hole >= holes.size()) {
            throw std::runtime_error(transform + ": " + scene.error().message);
        }
        holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(*hole));
        ++dropped;
    }
}

}  // namespace

std::vector<Map> read_maps(const std::string& folder, const std::vector<std::string>& only) {
    std::ifstream expected(SIGHTLINE_SOURCE_DIR "/experiments/02-maps2d/expected.csv");
    std::vector<Map> maps;
    for (std::string line; std::getline(expected, line);) {
        if (line.starts_with('#') || line.starts_with("map,")) continue;
        std::vector<std::string> cells;
        std::istringstream in(line + ',');
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        if (cells.size() < 4) throw std::runtime_error("expected.csv: " + line);
        cells.resize(5);
        if (!only.empty() && std::ranges::find(only, cells[0]) == only.end()) continue;
        const std::string path = folder + "/" + cells[0] + ".wkt";
        if (!std::filesystem::exists(path)) {
            fmt::print("{} is not there: left out\n", path);
            continue;
        }
        auto input = read_input(path, {.world = true});
        if (!input) throw std::runtime_error(input.error().message);
        maps.push_back({cells[0], std::move(*input), *number(cells[1]), *number(cells[2]),
                        number(cells[3]), number(cells[4])});
    }
    return maps;
}

std::vector<Moved> moved(const Map& map, std::uint64_t seed) {
    namespace f = families;
    const std::vector<std::pair<const char*, f::Transform>> transforms = {
        {"none", f::Translation{}},
        {"rotated 30 deg", f::ApproxRotation{30}},
        {"rotated 17.3 deg", f::ApproxRotation{17.3}},
        {"scaled 0.1", f::ApproxScaling{0.1}},
        {"scaled 1e-8", f::ApproxScaling{1e-8}},
        {"scaled 1e8", f::ApproxScaling{1e8}},
        {"shifted 1e8", f::ApproxTranslation{1e8, 1e8}},
        {"shifted 1e8/3", f::ApproxTranslation{1e8 / 3, 1e8 / 3}},
    };
    std::vector<Moved> result;
    for (const auto& [name, transform] : transforms) {
        result.push_back(made_valid(name, f::transformed(map.input, transform).value()));
    }
    const SceneInput2 turned = f::transformed(map.input, f::ApproxRotation{30}).value();
    result.push_back(made_valid("rotated 30 deg + shifted 1e8",
                                f::transformed(turned, f::ApproxTranslation{1e8, 1e8}).value()));
    result.push_back(made_valid("one ulp off", one_ulp_off(map.input, seed)));
    const SceneInput2 small = f::transformed(map.input, f::ApproxScaling{0.1}).value();
    result.push_back(made_valid("scaled 0.1 + one ulp off", one_ulp_off(small, seed)));
    return result;
}

}  // namespace sightline::experiments
