// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/mesh_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "scene/file_text.hpp"
#include "scene/text_cursor.hpp"

namespace sightline {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

MeshFormat format_of(std::string_view path, std::string_view bytes) {
    if (const auto format = mesh_format(path)) return *format;
    const std::string start = lower(bytes.substr(0, 5));
    if (start.starts_with("ply")) return MeshFormat::ply;
    if (start == "solid") return MeshFormat::stl;
    if (start.starts_with("v ") || start.starts_with("mtl") || start.starts_with("o "))
        return MeshFormat::obj;
    return MeshFormat::off;
}

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view path) {
    const std::string ending = lower(path.size() < 4 ? path : path.substr(path.size() - 4));
    if (ending == ".off") return MeshFormat::off;
    if (ending == ".obj") return MeshFormat::obj;
    if (ending == ".ply") return MeshFormat::ply;
    if (ending == ".stl") return MeshFormat::stl;
    return std::nullopt;
}

Result<MeshInput3> read_mesh(std::string_view bytes, MeshFormat format,
                             const MeshReadOptions& options) {
    switch (format) {
        case MeshFormat::obj:
            return read_obj(bytes, options);
        case MeshFormat::ply:
            return read_ply(bytes, options);
        case MeshFormat::stl:
            return read_stl(bytes, options);
        case MeshFormat::off:
            break;
    }
    return read_off(bytes, options);
}

Result<MeshInput3> read_mesh(const std::string& path, const MeshReadOptions& options) {
    MeshReadOptions named = options;
    if (path == "-") {
        if (named.file.empty()) named.file = "standard input";
        const std::string text = detail::read_all(std::cin);
        return read_mesh(text, format_of("", text), named);
    }
    if (named.file.empty()) named.file = path;
    const Result<detail::FileText> file = detail::FileText::open(path);
    if (!file) return tl::unexpected(file.error());
    return read_mesh(file->text(), format_of(path, file->text()), named);
}

}  // namespace sightline
