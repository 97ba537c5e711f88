// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <ostream>
#include <string>

#include "sightline/scene/off.hpp"

namespace sightline {

namespace {

void append(std::string& text, double x) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    text.append(buffer.data(), error == std::errc{} ? end : buffer.data());
}

void append_face(std::string& text, const std::vector<std::uint32_t>& face, std::size_t first) {
    text += std::to_string(face.size());
    for (const std::uint32_t v : face) text += ' ' + std::to_string(first + v);
    text += '\n';
}

std::string comments(const SceneInput3& input) {
    std::string text;
    if (input.world && !input.meshes.empty()) {
        text += "# world: the first " + std::to_string(input.meshes.front().faces.size()) +
                " faces bound the free world\n";
    }
    const bool sheets = std::any_of(input.meshes.begin(), input.meshes.end(), [](const auto& mesh) {
        return mesh.kind == SurfaceKind::sheet;
    });
    if (sheets) text += "# sheets: surfaces of zero thickness\n";
    return text;
}

}  // namespace

void write_off(std::ostream& out, const SceneInput3& input) {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (const MeshInput3& mesh : input.meshes) {
        vertices += mesh.vertices.size();
        faces += mesh.faces.size();
    }
    std::string text = "OFF\n" + comments(input);
    text += std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n";
    for (const MeshInput3& mesh : input.meshes) {
        for (const Point3& p : mesh.vertices) {
            append(text, p.x);
            text += ' ';
            append(text, p.y);
            text += ' ';
            append(text, p.z);
            text += '\n';
        }
    }
    std::size_t first = 0;
    for (const MeshInput3& mesh : input.meshes) {
        for (const auto& face : mesh.faces) append_face(text, face, first);
        first += mesh.vertices.size();
    }
    out << text;
}

}  // namespace sightline
