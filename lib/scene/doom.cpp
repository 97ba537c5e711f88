// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/doom.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <map>
#include <utility>

namespace sightline {

namespace {

using Bytes = std::span<const std::byte>;

/// The little-endian 16-bit word at an offset; the caller knows that it is there.
std::uint16_t word_at(Bytes bytes, std::size_t offset) {
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[offset]) |
                                      std::to_integer<unsigned>(bytes[offset + 1]) << 8U);
}
std::uint32_t double_word_at(Bytes bytes, std::size_t offset) {
    return word_at(bytes, offset) | static_cast<std::uint32_t>(word_at(bytes, offset + 2)) << 16U;
}
double coordinate_at(Bytes bytes, std::size_t offset) {
    return static_cast<double>(static_cast<std::int16_t>(word_at(bytes, offset)));
}

/// A name of up to 8 characters, padded with zeros.
std::string name_at(Bytes bytes, std::size_t offset) {
    std::string name;
    for (std::size_t i = 0; i < 8; ++i) {
        const auto c = std::to_integer<unsigned char>(bytes[offset + i]);
        if (c == 0) break;
        name.push_back(std::isprint(c) != 0 ? static_cast<char>(std::toupper(c)) : '?');
    }
    return name;
}

struct Lump {
    std::string name;
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
};

/// What a message begins with.
std::string place(const std::string& file) { return file.empty() ? "WAD: " : file + ": "; }

Result<std::vector<Lump>> directory_of(Bytes wad, const std::string& file) {
    constexpr std::size_t header_size = 12;
    constexpr std::size_t entry_size = 16;
    const std::string magic = wad.size() < header_size ? "" : name_at(wad.first(8), 0).substr(0, 4);
    if (magic != "IWAD" && magic != "PWAD") {
        return fail(Errc::syntax,
                    place(file) + "not a WAD (no IWAD or PWAD at the start); give a Doom WAD file");
    }
    const std::uint64_t count = double_word_at(wad, 4);
    const std::uint64_t start = double_word_at(wad, 8);
    if (start + count * entry_size > wad.size()) {
        return fail(Errc::syntax,
                    place(file) + "the directory of " + std::to_string(count) +
                        " lumps ends beyond the file; the file may be cut short, fetch it again");
    }
    std::vector<Lump> lumps;
    lumps.reserve(count);
    for (std::size_t at = start; at < start + count * entry_size; at += entry_size) {
        lumps.push_back(
            {name_at(wad, at + 8), double_word_at(wad, at), double_word_at(wad, at + 4)});
    }
    return lumps;
}

/// The lumps that belong to a map, in the order that Doom prescribes; others may be missing.
constexpr std::array<std::string_view, 12> map_lumps{"THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES",
                                                     "SEGS",   "SSECTORS", "NODES",    "SECTORS",
                                                     "REJECT", "BLOCKMAP", "BEHAVIOR", "SCRIPTS"};

bool is_map_lump(const Lump& lump) {
    return std::find(map_lumps.begin(), map_lumps.end(), lump.name) != map_lumps.end();
}

/// The lump of that name among those that follow the marker, or null.
const Lump* find_lump(std::span<const Lump> lumps, std::size_t marker, std::string_view name) {
    for (std::size_t i = marker + 1; i < lumps.size() && is_map_lump(lumps[i]); ++i) {
        if (lumps[i].name == name) return &lumps[i];
    }
    return nullptr;
}

bool is_marker(std::span<const Lump> lumps, std::size_t i) {
    return !is_map_lump(lumps[i]) && find_lump(lumps, i, "LINEDEFS") != nullptr;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::vector<std::string> markers_of(std::span<const Lump> lumps) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < lumps.size(); ++i) {
        if (is_marker(lumps, i)) names.push_back(lumps[i].name);
    }
    return names;
}

Result<Bytes> bytes_of(Bytes wad, const Lump* lump, std::string_view name, std::size_t record,
                       const std::string& where) {
    if (lump == nullptr) {
        return fail(Errc::syntax,
                    where + "has no " + std::string(name) + " lump; choose another map");
    }
    if (std::uint64_t{lump->offset} + lump->size > wad.size()) {
        return fail(Errc::syntax,
                    where + "the lump " + lump->name +
                        " ends beyond the file; the file may be cut short, fetch it again");
    }
    if (lump->size % record != 0) {
        return fail(Errc::syntax, where + "the lump " + lump->name + " has " +
                                      std::to_string(lump->size) + " bytes, not a multiple of " +
                                      std::to_string(record) + "; choose another map");
    }
    return wad.subspan(lump->offset, lump->size);
}

using Segments = std::vector<std::pair<Point2, Point2>>;

struct Linedefs {
    Bytes vertices;
    Bytes lines;
    std::size_t record = 14;  ///< bytes a linedef: 14 in Doom, 16 in Hexen
};

/// The chosen linedefs as segments, without those that have no length.
Result<Segments> segments_of(const Linedefs& data, bool all_lines, const std::string& where) {
    constexpr std::uint16_t no_side = 0xFFFF;
    const std::size_t vertex_count = data.vertices.size() / 4;
    Segments segments;
    for (std::size_t at = 0; at < data.lines.size(); at += data.record) {
        const std::size_t u = word_at(data.lines, at);
        const std::size_t v = word_at(data.lines, at + 2);
        if (u >= vertex_count || v >= vertex_count) {
            return fail(Errc::syntax, where + "linedef " + std::to_string(at / data.record) +
                                          " names vertex " + std::to_string(std::max(u, v)) +
                                          " of " + std::to_string(vertex_count) +
                                          "; choose another map");
        }
        const bool right = word_at(data.lines, at + data.record - 4) != no_side;
        const bool left = word_at(data.lines, at + data.record - 2) != no_side;
        if (!all_lines && right && left) continue;
        const auto point = [&](std::size_t i) {
            return Point2{coordinate_at(data.vertices, 4 * i),
                          coordinate_at(data.vertices, 4 * i + 2)};
        };
        if (point(u) != point(v)) segments.emplace_back(point(u), point(v));
    }
    return segments;
}

/// Joins segments to maximal chains whose inner points exactly two segments meet.
class Chains {
public:
    explicit Chains(const Segments& segments) {
        for (const auto& [u, v] : segments) {
            std::vector<Point2>& from = neighbours_[key(u)];
            if (std::find(from.begin(), from.end(), v) != from.end()) continue;  // a repeat
            from.push_back(v);
            neighbours_[key(v)].push_back(u);
        }
    }

    [[nodiscard]] SceneInput2 walls() {
        SceneInput2 scene;
        for (const bool closed :
             {false, true}) {  // first from all ends and branchings, then the closed chains
            for (auto& [at, neighbours] : neighbours_) {
                if (!closed && neighbours.size() == 2) continue;
                starts_.push_back({at, {neighbours.begin(), neighbours.end()}});
            }
            for (const auto& [at, neighbours] : starts_) {
                for (const Point2& next : neighbours) follow(at, next, scene);
            }
            starts_.clear();
        }
        return scene;
    }

private:
    using Key = std::pair<double, double>;
    static Key key(const Point2& p) { return {p.x, p.y}; }

    bool remove(const Point2& from, const Point2& to) {
        std::vector<Point2>& list = left_[key(from)];
        const auto found = std::find(list.begin(), list.end(), to);
        if (found == list.end()) return false;
        list.erase(found);
        return true;
    }

    void follow(const Key& start, Point2 next, SceneInput2& scene) {
        if (left_.empty()) left_ = neighbours_;
        Point2 at{start.first, start.second};
        if (!remove(at, next)) return;
        remove(next, at);
        Polyline2 chain{{at, next}};
        while (neighbours_[key(next)].size() == 2 && !left_[key(next)].empty()) {
            at = next;
            next = left_[key(at)].front();
            remove(at, next);
            remove(next, at);
            chain.points.push_back(next);
        }
        scene.elements.emplace_back(std::move(chain));
    }

    std::map<Key, std::vector<Point2>> neighbours_;
    std::map<Key, std::vector<Point2>> left_;  ///< not yet in a chain
    std::vector<std::pair<Key, std::vector<Point2>>> starts_;
};

Result<std::vector<std::byte>> read_file(const std::string& path) {
    constexpr std::size_t chunk = std::size_t{1} << 20;
    std::ifstream stream(path, std::ios::binary);
    std::vector<char> text;
    while (stream) {  // in pieces: the size of what is no plain file is anyone's guess
        const std::size_t size = text.size();
        text.resize(size + chunk);
        stream.read(text.data() + size, chunk);
        text.resize(size + static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.eof()) {
        return fail(Errc::cannot_open,
                    path + ": cannot be read; check the path and its permissions");
    }
    const auto bytes = std::as_bytes(std::span(text));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
}

Result<std::size_t> marker_of(std::span<const Lump> lumps, std::string_view map,
                              const std::string& file) {
    std::string name(map);
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (std::size_t i = 0; i < lumps.size(); ++i) {
        if (lumps[i].name != name || is_map_lump(lumps[i])) continue;
        if (i + 1 < lumps.size() && lumps[i + 1].name == "TEXTMAP") {
            return fail(Errc::unsupported,
                        place(file) + "map " + name +
                            " is a UDMF text map; convert it to Doom's binary format");
        }
        if (is_marker(lumps, i)) return i;
    }
    const std::vector<std::string> names = markers_of(lumps);
    return fail(Errc::bad_parameter,
                place(file) + "there is no map '" + std::string(map) + "'; " +
                    (names.empty() ? "the file has no maps" : "give one of " + listed(names)));
}

}  // namespace

Result<std::vector<std::string>> doom_maps(Bytes wad, const std::string& file) {
    return directory_of(wad, file).map(
        [](const std::vector<Lump>& lumps) { return markers_of(lumps); });
}

Result<std::vector<std::string>> doom_maps(const std::string& path) {
    const Result<std::vector<std::byte>> wad = read_file(path);
    if (!wad) return tl::unexpected<Error>(wad.error());
    return doom_maps(*wad, path);
}

Result<SceneInput2> read_doom(Bytes wad, std::string_view map, const DoomOptions& options,
                              const std::string& file) {
    const Result<std::vector<Lump>> lumps = directory_of(wad, file);
    if (!lumps) return tl::unexpected<Error>(lumps.error());
    const Result<std::size_t> marker = marker_of(*lumps, map, file);
    if (!marker) return tl::unexpected<Error>(marker.error());
    const std::string where = place(file) + "map " + (*lumps)[*marker].name + ": ";
    const std::size_t record = find_lump(*lumps, *marker, "BEHAVIOR") != nullptr ? 16 : 14;
    const auto vertices =
        bytes_of(wad, find_lump(*lumps, *marker, "VERTEXES"), "VERTEXES", 4, where);
    if (!vertices) return tl::unexpected<Error>(vertices.error());
    const auto lines =
        bytes_of(wad, find_lump(*lumps, *marker, "LINEDEFS"), "LINEDEFS", record, where);
    if (!lines) return tl::unexpected<Error>(lines.error());
    const Result<Segments> segments =
        segments_of({*vertices, *lines, record}, options.all_lines, where);
    if (!segments) return tl::unexpected<Error>(segments.error());
    if (segments->empty()) {
        return fail(Errc::empty_scene, where + "no linedef is a wall; try all lines");
    }
    SceneInput2 scene = Chains(*segments).walls();
    scene.file = file;
    return scene;
}

Result<SceneInput2> read_doom(const std::string& path, std::string_view map,
                              const DoomOptions& options) {
    const Result<std::vector<std::byte>> wad = read_file(path);
    if (!wad) return tl::unexpected<Error>(wad.error());
    return read_doom(*wad, map, options, path);
}

}  // namespace sightline
