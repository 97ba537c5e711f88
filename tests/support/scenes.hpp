// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes written down in tests, in one line or a few.
#pragma once

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::testing {

/// "x y, x y, …"
inline std::vector<Point2> parse_points(const std::string& text) {
    std::vector<Point2> points;
    std::istringstream in(text);
    std::string pair;
    while (std::getline(in, pair, ',')) {
        std::istringstream numbers(pair);
        std::string x;
        std::string y;
        std::string more;
        if (!(numbers >> x >> y) || numbers >> more)
            throw std::invalid_argument("not a point: " + pair);
        // Not std::stod, which refuses denormals.
        points.push_back({std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr)});
    }
    return points;
}

/// One line of a scene: `polygon …`, `hole …` (of the last polygon), `wall …`, `point …`, or
/// `world` (the first polygon is the free world). Without a word: polygons, separated by |.
inline void parse_line(const std::string& line, SceneInput2& input) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word) || word[0] == '#') return;
    std::string rest;
    std::getline(in, rest);
    if (word == "world") {
        input.world = true;
    } else if (word == "polygon") {
        input.elements.emplace_back(Polygon2{parse_points(rest), {}});
    } else if (word == "hole") {
        std::get<Polygon2>(input.elements.back()).holes.push_back(parse_points(rest));
    } else if (word == "wall") {
        input.elements.emplace_back(Polyline2{parse_points(rest)});
    } else if (word == "point") {
        for (const Point2& p : parse_points(rest)) input.elements.emplace_back(p);
    } else {
        std::istringstream polygons(line);
        std::string polygon;
        while (std::getline(polygons, polygon, '|')) {
            input.elements.emplace_back(Polygon2{parse_points(polygon), {}});
        }
    }
}

/// Lines as above, separated by line breaks or semicolons.
inline SceneInput2 scene_input(const std::string& text) {
    SceneInput2 input;
    std::string line;
    for (const char c : text + "\n") {
        if (c != '\n' && c != ';') {
            line += c;
            continue;
        }
        parse_line(line, input);
        line.clear();
    }
    return input;
}

/// The scene of such lines; throws when it is not valid.
inline Scene2 scene2(const std::string& text) {
    auto scene = Scene2::make(scene_input(text));
    if (!scene) throw std::invalid_argument(scene.error().message + " in: " + text);
    return *std::move(scene);
}

/// What `scene2` reads back, for messages.
inline std::string to_text(const SceneInput2& input) {
    std::ostringstream out;
    out.precision(17);
    const auto points = [&out](const char* word, const std::vector<Point2>& list) {
        out << word;
        for (std::size_t i = 0; i < list.size(); ++i) {
            out << (i == 0 ? " " : ", ") << list[i].x << ' ' << list[i].y;
        }
        out << '\n';
    };
    if (input.world) out << "world\n";
    for (const SceneElement2& element : input.elements) {
        if (const auto* polygon = std::get_if<Polygon2>(&element)) {
            points("polygon", polygon->outer);
            for (const Ring2& hole : polygon->holes) points("hole", hole);
        } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
            points("wall", wall->points);
        } else {
            points("point", {std::get<Point2>(element)});
        }
    }
    return out.str();
}

}  // namespace sightline::testing
