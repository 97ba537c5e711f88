// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/scene_io.hpp"

#include <algorithm>
#include <iostream>

#include "scene/file_text.hpp"
#include "scene/text_cursor.hpp"
#include "sightline/scene/geojson.hpp"
#include "sightline/scene/text_format.hpp"
#include "sightline/scene/wkt.hpp"

namespace sightline {
namespace {

Result<SceneInput2> read_text_as(SceneFormat2 format, std::string_view text,
                                 const ReadOptions& options) {
    switch (format) {
        case SceneFormat2::wkt:
            return read_wkt(text, options);
        case SceneFormat2::geojson:
            return read_geojson(text, options);
        case SceneFormat2::text:
            break;
    }
    return read_text(text, options);
}

bool ends_with(std::string_view path, std::string_view ending) {
    if (path.size() < ending.size()) return false;
    path.remove_prefix(path.size() - ending.size());
    return std::equal(path.begin(), path.end(), ending.begin(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b;
    });
}

}  // namespace

SceneFormat2 scene_format(std::string_view path, std::string_view content) {
    if (ends_with(path, ".wkt")) return SceneFormat2::wkt;
    if (ends_with(path, ".geojson") || ends_with(path, ".json")) return SceneFormat2::geojson;
    if (ends_with(path, ".scene")) return SceneFormat2::text;
    const std::size_t first = content.find_first_not_of(" \t\r\n\f\v");
    if (first == std::string_view::npos) return SceneFormat2::text;
    if (content[first] == '{' || content[first] == '[') return SceneFormat2::geojson;
    // Our own words are in small letters, and no number directly follows a word of WKT.
    const std::string_view rest = content.substr(first);
    for (const std::string_view word : {"#", "world", "polygon", "hole", "wall", "point"}) {
        if (!rest.starts_with(word)) continue;
        const std::size_t next = rest.find_first_not_of(" \t", word.size());
        if (word == "#" || next == std::string_view::npos ||
            (rest[next] != '(' && rest[next] != 'e')) {
            return SceneFormat2::text;
        }
    }
    return SceneFormat2::wkt;
}

Result<SceneInput2> read_input(const std::string& path, const ReadOptions& options) {
    ReadOptions named = options;
    if (path == "-") {
        if (named.file.empty()) named.file = "standard input";
        const std::string text = detail::read_all(std::cin);
        return read_text_as(scene_format("", text), text, named);
    }
    if (named.file.empty()) named.file = path;
    Result<detail::FileText> file = detail::FileText::open(path);
    if (!file) return tl::unexpected(file.error());
    named.progress = [&](double part) {
        file->release(part);
        if (options.progress) options.progress(part);
    };
    return read_text_as(scene_format(path, file->text()), file->text(), named);
}

Result<Scene2> read_scene(const std::string& path, const ReadOptions& options) {
    const Result<SceneInput2> input = read_input(path, options);
    if (!input) return tl::unexpected(input.error());
    return Scene2::make(*input);
}

void write_input(std::ostream& out, const SceneInput2& input, SceneFormat2 format) {
    switch (format) {
        case SceneFormat2::wkt:
            return write_wkt(out, input);
        case SceneFormat2::geojson:
            return write_geojson(out, input);
        case SceneFormat2::text:
            break;
    }
    write_text(out, input);
}

}  // namespace sightline
