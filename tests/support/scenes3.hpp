// SPDX-License-Identifier: GPL-3.0-or-later
// 3D scenes written down in tests, in one line or a few.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene/families3_detail.hpp"
#include "sightline/scene/families3.hpp"
#include "sightline/scene/off.hpp"
#include "sightline/scene/scene3.hpp"

namespace sightline::testing {

/// "x y z, x y z, …"
inline std::vector<Point3> parse_points3(const std::string& text) {
    std::vector<Point3> points;
    std::istringstream in(text);
    for (std::string triple; std::getline(in, triple, ',');) {
        std::istringstream numbers(triple);
        std::vector<double> xyz;
        for (std::string word; numbers >> word;)
            xyz.push_back(std::strtod(word.c_str(), nullptr));  // std::stod refuses denormals
        if (xyz.size() != 3) throw std::invalid_argument("not a point: " + triple);
        points.push_back({xyz[0], xyz[1], xyz[2]});
    }
    return points;
}

inline MeshInput3 box_mesh(const Point3& a, const Point3& b) {
    MeshInput3 mesh;
    mesh.vertices = {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z},
                     {a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}};
    mesh.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return mesh;
}

/// The hull of points with whole coordinates; a tetrahedron for four.
inline MeshInput3 hull_mesh(const std::vector<Point3>& points) {
    families::detail::Ring3 whole;
    for (const Point3& p : points) {
        whole.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y),
                         static_cast<std::int64_t>(p.z)});
        if (families::detail::to_point(whole.back()) != p)
            throw std::invalid_argument("hull of points with fractions");
    }
    families::detail::MeshBuilder mesh;
    mesh.add(families::detail::convex_hull(whole));
    return mesh.take();
}

inline MeshInput3 sheet_mesh(const std::vector<Point3>& ring) {
    MeshInput3 mesh;
    mesh.vertices = ring;
    mesh.faces.emplace_back();
    for (std::uint32_t v = 0; v < ring.size(); ++v) mesh.faces[0].push_back(v);
    mesh.kind = SurfaceKind::sheet;
    return mesh;
}

/// Lines, separated by line breaks or semicolons, each a mesh of its own: `box LOW, HIGH`,
/// `hull POINT, …` (whole coordinates), `sheet POINT, …` (one polygon), `family NAME [PARAMETER…]`
/// (seed 1). `world` alone: the first mesh bounds the free world.
inline SceneInput3 scene_input3(const std::string& text) {
    SceneInput3 input;
    const auto parse_line = [&input](const std::string& line) {
        std::istringstream in(line);
        std::string word;
        if (!(in >> word) || word[0] == '#') return;
        std::string rest;
        std::getline(in, rest);
        if (word == "world") {
            input.world = true;
        } else if (word == "box") {
            const auto corners = parse_points3(rest);
            input.meshes.push_back(box_mesh(corners.at(0), corners.at(1)));
        } else if (word == "hull") {
            input.meshes.push_back(hull_mesh(parse_points3(rest)));
        } else if (word == "sheet") {
            input.meshes.push_back(sheet_mesh(parse_points3(rest)));
        } else if (word == "family") {
            std::istringstream words(rest);
            std::string name;
            words >> name;
            std::vector<std::string> parameters;
            for (std::string parameter; words >> parameter;) parameters.push_back(parameter);
            auto scene = families::generate3(name, parameters, 1);
            if (!scene) throw std::invalid_argument(scene.error().message);
            for (MeshInput3& mesh : scene->meshes) input.meshes.push_back(std::move(mesh));
            input.world = input.world || scene->world;
        } else {
            throw std::invalid_argument("not a line of a scene: " + line);
        }
    };
    std::string line;
    for (const char c : text + "\n") {
        if (c != '\n' && c != ';') {
            line += c;
            continue;
        }
        parse_line(line);
        line.clear();
    }
    return input;
}

inline std::string to_text(const SceneInput3& input) {
    std::ostringstream out;
    write_off(out, input);
    return out.str();
}

/// The valid scene; throws when it is not.
inline Scene3 scene3(const SceneInput3& input) {
    auto scene = Scene3::make(input);
    if (!scene) throw std::invalid_argument(scene.error().message + " in:\n" + to_text(input));
    return *std::move(scene);
}
inline Scene3 scene3(const std::string& text) { return scene3(scene_input3(text)); }

/// Scenes put together; at most the first may have a world.
inline SceneInput3 joined(std::initializer_list<SceneInput3> scenes) {
    SceneInput3 result;
    for (const SceneInput3& scene : scenes) {
        if (scene.world && !result.meshes.empty())
            throw std::invalid_argument("a world comes first");
        result.world = result.world || scene.world;
        result.meshes.insert(result.meshes.end(), scene.meshes.begin(), scene.meshes.end());
    }
    return result;
}

}  // namespace sightline::testing
