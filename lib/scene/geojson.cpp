// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>

#include "scene/text_cursor.hpp"

namespace sightline {
namespace {

/// Where the parser has got to; shared by the copies of an iterator.
struct Progress {
    const char* begin = nullptr;
    const char* end = nullptr;
    const char* at = nullptr;
    const char* line_start = nullptr;
    std::uint32_t line = 1;
};

/// Reads characters and keeps count of lines, so that handlers know where they are.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, Progress* progress) : at_(at), progress_(progress) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        if (*at_++ == '\n') {
            ++progress_->line;
            progress_->line_start = at_;
        }
        progress_->at = at_;
        return *this;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ != b.at_;
    }

private:
    const char* at_;
    Progress* progress_;
};

/// Coordinates as they come, before the type is known: rings of positions, and where polygons end.
struct Coordinates {
    std::vector<Ring2> rings;
    std::vector<std::size_t> polygon_ends;  ///< how many rings stand before each end
    Ring2 open_ring;
    std::uint32_t depth = 0;  ///< how many brackets stand round a number; 0: no number yet
    bool present = false;

    void close_ring() {
        if (open_ring.empty()) return;
        if (open_ring.capacity() > open_ring.size() + open_ring.size() / 8)
            open_ring.shrink_to_fit();
        rings.push_back(std::move(open_ring));
        open_ring = {};
    }
    void close_polygon() {
        if (rings.size() > (polygon_ends.empty() ? 0 : polygon_ends.back()))
            polygon_ends.push_back(rings.size());
    }
};

/// An object in the place of a geometry, a feature or a collection.
struct GeoObject {
    std::string type;
    Coordinates coordinates;
    std::uint32_t line = 1;
};

class GeoJsonHandler {
public:
    using Json = nlohmann::json;

    GeoJsonHandler(const Progress& progress, const ReadOptions& options)
        : at_(progress), options_(options) {
        input_.world = options.world;
        input_.file = options.file;
    }

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }
    [[nodiscard]] SceneInput2 take() { return std::move(input_); }

    bool null() {
        const bool no_geometry =
            skipped_ == 0 && brackets_ == 0 && in_object() && key_ == "geometry";
        return no_geometry || scalar("null");
    }
    bool boolean(bool value) {
        if (skipped_ == 0 && open_.size() == 1 && key_ == "world")
            input_.world = input_.world || value;
        return scalar("a truth value");
    }
    bool number_integer(Json::number_integer_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(Json::number_unsigned_t value) {
        return number(static_cast<double>(value));
    }
    bool number_float(Json::number_float_t value, const std::string&) { return number(value); }
    bool binary(Json::binary_t&) { return scalar("binary data"); }

    bool string(std::string& value) {
        if (skipped_ == 0 && brackets_ == 0 && in_object() && key_ == "type") {
            open_.back().object.type = value;
            return true;
        }
        return scalar("a text");
    }

    bool key(std::string& value) {
        if (skipped_ == 0) key_ = value.substr(0, 32);
        return true;
    }

    bool start_object(std::size_t) {
        if (skipped_ > 0) return skip();
        if (brackets_ > 0)
            return refuse(Errc::syntax, "an object stands among the coordinates; write [x, y]");
        const bool wanted = open_.empty() || !in_object() || key_ == "geometry";
        if (!wanted) return is_ours(key_) ? refuse_kind("an object") : skip();
        if (!nest()) return false;
        open_.push_back({});
        open_.back().object.line = at_.line;
        key_.clear();
        return true;
    }

    bool end_object() {
        if (skipped_ > 0) return unskip();
        GeoObject object = std::move(open_.back().object);
        open_.pop_back();
        key_.clear();
        if (options_.progress) {
            options_.progress(static_cast<double>(at_.at - at_.begin) /
                              static_cast<double>(at_.end - at_.begin));
        }
        return finish(object);
    }

    bool start_array(std::size_t) {
        if (skipped_ > 0) return skip();
        if (brackets_ > 0) return open_bracket();
        if (open_.empty())
            return refuse(Errc::syntax, "GeoJSON begins with an object; write {\"type\": …}");
        if (!in_object())
            return refuse(Errc::syntax,
                          "a list stands in the place of a geometry; write an object");
        if (key_ == "coordinates") {
            Coordinates& coordinates = open_.back().object.coordinates;
            if (coordinates.present)
                return refuse(Errc::syntax, "an object has coordinates twice; remove one");
            coordinates.present = true;
            return open_bracket();
        }
        if (key_ != "features" && key_ != "geometries")
            return is_ours(key_) ? refuse_kind("a list") : skip();
        if (!nest()) return false;
        open_.push_back({true, {}});
        return true;
    }

    bool end_array() {
        if (skipped_ > 0) return unskip();
        if (brackets_ > 0) return close_bracket();
        open_.pop_back();
        key_.clear();
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& problem) {
        if (problem.id == 406) {
            return refuse(Errc::coordinate_too_large,
                          "the number is beyond the doubles; give one below 2^1020 in size");
        }
        const bool ends = std::string_view(problem.what()).find("unexpected end of input") !=
                          std::string_view::npos;
        return refuse(Errc::syntax,
                      ends ? "not JSON: the text ends too early; complete it"
                           : "not JSON: a bracket, comma, text or number is wrong here; mend it");
    }

    bool refuse(Errc code, std::string_view what) {
        if (error_) return false;
        const std::string where = options_.file.empty() ? "line " : options_.file + ":";
        const auto column = at_.at - at_.line_start;
        error_ = Error{code, fmt::format("{}{}:{}: {}", where, at_.line,
                                         std::max<std::ptrdiff_t>(column, 1), what)};
        return false;
    }

private:
    struct Level {
        bool is_array = false;
        GeoObject object;
    };

    [[nodiscard]] bool in_object() const { return !open_.empty() && !open_.back().is_array; }
    [[nodiscard]] static bool is_ours(std::string_view key) {
        return key == "type" || key == "coordinates" || key == "features" || key == "geometries" ||
               key == "geometry";
    }

    bool nest() {
        if (open_.size() < 2 * std::size_t{options_.max_depth}) return true;
        return refuse(
            Errc::limit_reached,
            fmt::format("collections are nested deeper than {}; flatten them", options_.max_depth));
    }

    // The parser keeps a bit a level; the bound keeps even that small.
    bool skip() {
        if (++skipped_ <= 10'000) return true;
        return refuse(Errc::limit_reached, "a member is nested deeper than 10000; remove it");
    }
    bool unskip() {
        --skipped_;
        return true;
    }

    bool refuse_kind(std::string_view found) {
        return refuse(Errc::syntax, fmt::format("member \"{}\" is {}; write a {}", key_, found,
                                                key_ == "type"       ? "text"
                                                : key_ == "geometry" ? "geometry object"
                                                                     : "list"));
    }

    bool scalar(std::string_view found) {
        if (skipped_ > 0) return true;
        if (brackets_ > 0)
            return refuse(Errc::syntax,
                          fmt::format("{} stands among the coordinates; write numbers", found));
        if (open_.empty())
            return refuse(Errc::syntax, "GeoJSON begins with an object; write {\"type\": …}");
        if (!in_object())
            return refuse(
                Errc::syntax,
                fmt::format("{} stands in the place of a geometry; write an object", found));
        return is_ours(key_) ? refuse_kind(found) : true;
    }

    bool open_bracket() {
        const std::uint32_t depth = open_.back().object.coordinates.depth;
        if (brackets_ == 4)
            return refuse(Errc::syntax,
                          "coordinates are nested deeper than 4; no geometry has that");
        if (depth != 0 && brackets_ == depth) return refuse(Errc::syntax, different_depths);
        ++brackets_;
        numbers_ = 0;
        return true;
    }

    bool close_bracket() {
        Coordinates& coordinates = open_.back().object.coordinates;
        if (coordinates.depth == brackets_ && numbers_ < 2) {
            return refuse(Errc::syntax,
                          fmt::format("a position has {} numbers; write [x, y]", numbers_));
        }
        numbers_ = 0;
        --brackets_;
        // Closed was level brackets_ + 1: a ring is one level above positions, a polygon two.
        if (brackets_ == 0 || brackets_ + 2 == coordinates.depth) coordinates.close_ring();
        if (brackets_ == 0 || brackets_ + 3 == coordinates.depth) coordinates.close_polygon();
        if (brackets_ == 0) key_.clear();
        return true;
    }

    bool number(double value) {
        if (brackets_ == 0) return scalar("a number");
        Coordinates& coordinates = open_.back().object.coordinates;
        if (coordinates.depth == 0) coordinates.depth = brackets_;
        if (coordinates.depth != brackets_) return refuse(Errc::syntax, different_depths);
        if (numbers_ == 2)
            return refuse(Errc::unsupported,
                          "a third coordinate is not supported; give x and y only");
        Ring2& ring = coordinates.open_ring;
        if (numbers_++ == 0) {
            ring.push_back({value, 0});
        } else {
            ring.back().y = value;
        }
        return true;
    }

    bool finish(GeoObject& object) {
        if (object.type.empty()) return refuse(Errc::syntax, "an object has no type; add \"type\"");
        if (object.type == "Feature" || object.type == "FeatureCollection" ||
            object.type == "GeometryCollection") {
            return true;
        }
        static constexpr std::pair<std::string_view, std::uint32_t> depths[] = {
            {"Point", 1},           {"MultiPoint", 2}, {"LineString", 2},
            {"MultiLineString", 3}, {"Polygon", 3},    {"MultiPolygon", 4}};
        for (const auto& [type, depth] : depths) {
            if (object.type != type) continue;
            if (!object.coordinates.present)
                return refuse(Errc::syntax, object.type + " has no coordinates; add them");
            if (object.coordinates.depth == 0) return true;
            if (object.coordinates.depth != depth) {
                return refuse(
                    Errc::syntax,
                    fmt::format("{} needs positions within {} brackets, not {}; mend the brackets",
                                object.type, depth, object.coordinates.depth));
            }
            emit(object);
            return true;
        }
        std::string shown = object.type.substr(0, 40);
        for (char& c : shown) {
            if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f)
                c = '?';
        }
        return refuse(
            Errc::unsupported,
            fmt::format("type \"{}\" is not supported; write Polygon, LineString or Point", shown));
    }

    void emit(GeoObject& object) {
        std::vector<Ring2>& rings = object.coordinates.rings;
        if (object.type == "Polygon" || object.type == "MultiPolygon") {
            std::size_t first = 0;
            for (const std::size_t end : object.coordinates.polygon_ends) {
                emit_polygon(std::span(rings).subspan(first, end - first), object.line);
                first = end;
            }
            return;
        }
        const bool is_wall = object.type == "LineString" || object.type == "MultiLineString";
        for (Ring2& ring : rings) {
            if (is_wall) {
                emit(Polyline2{std::move(ring)}, object.line);
                continue;
            }
            for (const Point2& p : ring) emit(p, object.line);
        }
    }

    void emit_polygon(std::span<Ring2> rings, std::uint32_t line) {
        for (Ring2& ring : rings) {
            if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        }
        Polygon2 polygon{std::move(rings[0]), {}};
        polygon.holes.assign(std::move_iterator(rings.begin() + 1),
                             std::move_iterator(rings.end()));
        emit(std::move(polygon), line);
    }

    void emit(SceneElement2 element, std::uint32_t line) {
        input_.elements.push_back(std::move(element));
        input_.lines.push_back(line);
    }

    static constexpr std::string_view different_depths =
        "positions stand at different depths; write all as [x, y]";

    const Progress& at_;
    const ReadOptions& options_;
    SceneInput2 input_;
    std::optional<Error> error_;
    std::vector<Level> open_;
    std::string key_;
    std::size_t skipped_ = 0;     ///< depth within a member that does not matter
    std::uint32_t brackets_ = 0;  ///< depth within coordinates
    std::uint32_t numbers_ = 0;   ///< of the position being read
};

void append_position(std::string& out, const Point2& p) {
    // As an integer, "-0" would lose its sign in many readers.
    const auto append = [&out](double x) {
        detail::append_number(out, x);
        if (x == 0 && std::signbit(x)) out += ".0";
    };
    out += '[';
    append(p.x);
    out += ", ";
    append(p.y);
    out += ']';
}

void append_ring(std::string& out, const std::vector<Point2>& points, bool close) {
    out += '[';
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) out += ", ";
        append_position(out, points[i]);
    }
    if (close && !points.empty()) {
        out += ", ";
        append_position(out, points.front());
    }
    out += ']';
}

void append_geometry(std::string& out, const SceneElement2& element) {
    if (const auto* polygon = std::get_if<Polygon2>(&element)) {
        out += R"({"type": "Polygon", "coordinates": [)";
        if (!polygon->outer.empty()) append_ring(out, polygon->outer, true);
        for (const Ring2& hole : polygon->holes) {
            if (hole.empty() || polygon->outer.empty()) continue;
            out += ", ";
            append_ring(out, hole, true);
        }
        out += "]}";
    } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
        out += R"({"type": "LineString", "coordinates": )";
        append_ring(out, wall->points, false);
        out += '}';
    } else {
        out += R"({"type": "Point", "coordinates": )";
        append_position(out, std::get<Point2>(element));
        out += '}';
    }
}

}  // namespace

Result<SceneInput2> read_geojson(std::string_view text, const ReadOptions& options) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    Progress progress{text.data(), text.data() + text.size(), text.data(), text.data(), 1};
    GeoJsonHandler handler(progress, options);
    const CountingIterator begin(progress.begin, &progress);
    const CountingIterator end(progress.end, &progress);
    if (nlohmann::json::sax_parse(begin, end, &handler)) return handler.take();
    if (!handler.error()) handler.refuse(Errc::syntax, "the text is not GeoJSON; mend it there");
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): refuse() sets it
    return tl::unexpected(*handler.error());
}

Result<SceneInput2> read_geojson(std::istream& in, const ReadOptions& options) {
    return read_geojson(detail::read_all(in), options);
}

void write_geojson(std::ostream& out, const SceneInput2& input) {
    out << R"({"type": "GeometryCollection",)" << (input.world ? R"( "world": true,)" : "")
        << R"( "geometries": [)";
    std::string text;
    for (std::size_t i = 0; i < input.elements.size(); ++i) {
        text = i == 0 ? "\n" : ",\n";
        append_geometry(text, input.elements[i]);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    out << "\n]}\n";
}

}  // namespace sightline
