// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/wkt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "scene/text_cursor.hpp"

namespace sightline {
namespace {

enum class Kind : std::uint8_t {
    point,
    multipoint,
    linestring,
    multilinestring,
    polygon,
    multipolygon,
    collection,
    unsupported,
    unknown
};

std::string upper(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return text;
}

Kind kind_of(const std::string& word) {
    static constexpr std::pair<std::string_view, Kind> kinds[] = {
        {"POINT", Kind::point},
        {"MULTIPOINT", Kind::multipoint},
        {"LINESTRING", Kind::linestring},
        {"MULTILINESTRING", Kind::multilinestring},
        {"POLYGON", Kind::polygon},
        {"MULTIPOLYGON", Kind::multipolygon},
        {"GEOMETRYCOLLECTION", Kind::collection},
        {"CIRCULARSTRING", Kind::unsupported},
        {"COMPOUNDCURVE", Kind::unsupported},
        {"CURVEPOLYGON", Kind::unsupported},
        {"MULTICURVE", Kind::unsupported},
        {"MULTISURFACE", Kind::unsupported},
        {"CURVE", Kind::unsupported},
        {"SURFACE", Kind::unsupported},
        {"POLYHEDRALSURFACE", Kind::unsupported},
        {"TIN", Kind::unsupported},
        {"TRIANGLE", Kind::unsupported}};
    for (const auto& [name, kind] : kinds) {
        if (word == name) return kind;
    }
    return Kind::unknown;
}

class WktReader {
public:
    WktReader(std::string_view text, const ReadOptions& options)
        : options_(options), cursor_(text, options) {
        input_.world = options.world;
        input_.file = options.file;
    }

    Result<SceneInput2> run() {
        for (cursor_.skip_space(); !cursor_.at_end(); cursor_.skip_space()) {
            if (!geometry(0)) return tl::unexpected(*cursor_.error());
            while (cursor_.accept(';')) {
            }
            cursor_.report_progress();
        }
        return std::move(input_);
    }

private:
    bool geometry(std::uint32_t depth) {
        cursor_.skip_space();
        if (depth == 0) skip_srid();
        line_ = cursor_.line();
        const std::string_view word = cursor_.word();
        const std::string name = upper(word);
        const Kind kind = kind_of(name);
        if (kind == Kind::unknown) {
            return cursor_.refuse(
                Errc::syntax,
                name.empty()
                    ? "expected a geometry such as POLYGON, " + cursor_.found()
                    : fmt::format("'{}' is no geometry; write POLYGON, LINESTRING or POINT",
                                  word.substr(0, 40)));
        }
        if (kind == Kind::unsupported) {
            return cursor_.refuse(Errc::unsupported,
                                  name + " is not supported; write it as POLYGON or LINESTRING");
        }
        cursor_.skip_space();
        const std::string modifier = upper(cursor_.word());
        if (modifier == "EMPTY") return true;
        if (modifier == "Z" || modifier == "M" || modifier == "ZM") {
            return cursor_.refuse(
                Errc::unsupported,
                name + " " + modifier + " has more than two coordinates; give x and y only");
        }
        if (!modifier.empty())
            return cursor_.refuse(Errc::syntax, "expected '(' or EMPTY after " + name);
        return body(kind, depth);
    }

    void skip_srid() {
        const std::string_view rest = cursor_.rest();
        if (rest.size() < 5 || upper(rest.substr(0, 5)) != "SRID=") return;
        const std::size_t end = rest.find_first_not_of("0123456789", 5);
        if (end != std::string_view::npos && rest[end] == ';') cursor_.advance(end + 1);
        cursor_.skip_space();
    }

    bool body(Kind kind, std::uint32_t depth) {
        switch (kind) {
            case Kind::point:
                return point_body();
            case Kind::multipoint:
                return list([&] { return multipoint_member(); });
            case Kind::linestring:
                return linestring_body();
            case Kind::multilinestring:
                return list([&] { return is_empty_member() || linestring_body(); });
            case Kind::polygon:
                return polygon_body();
            case Kind::multipolygon:
                return list([&] { return is_empty_member() || polygon_body(); });
            default:
                break;
        }
        if (depth >= options_.max_depth) {
            return cursor_.refuse(Errc::limit_reached,
                                  fmt::format("collections are nested deeper than {}; flatten them",
                                              options_.max_depth));
        }
        return list([&] { return geometry(depth + 1); });
    }

    /// "(", members with commas between, ")".
    template <typename Member>
    bool list(const Member& member) {
        if (!expect('(')) return false;
        do {
            if (!member()) return false;
        } while (cursor_.accept(','));
        return expect(')');
    }

    bool expect(char c) {
        if (cursor_.accept(c)) return true;
        return cursor_.refuse(Errc::syntax, fmt::format("expected '{}', {}", c, cursor_.found()));
    }

    bool is_empty_member() {
        cursor_.skip_space();
        line_ = cursor_.line();
        if (upper(cursor_.rest().substr(0, 5)) != "EMPTY") return false;
        cursor_.advance(5);
        return true;
    }

    bool coordinates(Point2& p) {
        cursor_.skip_space();
        if (!cursor_.number(p.x)) return false;
        cursor_.skip_space();
        if (!cursor_.number(p.y)) return false;
        cursor_.skip_space();
        const char next = cursor_.peek();
        if (next == ',' || next == ')' || next == '\0') return true;
        double third = 0;
        const bool is_number =
            (next >= '0' && next <= '9') || next == '-' || next == '+' || next == '.';
        if (is_number && cursor_.number(third)) {
            return cursor_.refuse(Errc::unsupported,
                                  "a third coordinate is not supported; give x and y only");
        }
        return cursor_.refuse(Errc::syntax, "expected ',' or ')', " + cursor_.found());
    }

    bool chain(std::vector<Point2>& points) {
        if (!expect('(')) return false;
        // Counting first spares the vector its spare half: this is most of the memory of a large
        // file.
        const std::string_view rest = cursor_.rest();
        const auto end =
            rest.begin() + static_cast<std::ptrdiff_t>(std::min(rest.find(')'), rest.size()));
        points.reserve(static_cast<std::size_t>(std::count(rest.begin(), end, ',')) + 1);
        do {
            Point2 p;
            if (!coordinates(p)) return false;
            points.push_back(p);
        } while (cursor_.accept(','));
        return expect(')');
    }

    bool ring(Ring2& points) {
        if (!chain(points)) return false;
        if (points.size() > 1 && points.front() == points.back()) points.pop_back();
        return true;
    }

    void emit(SceneElement2 element, std::uint32_t line) {
        input_.elements.push_back(std::move(element));
        input_.lines.push_back(line);
    }

    bool point_body() {
        const std::uint32_t line = line_;
        Point2 p;
        if (!expect('(') || !coordinates(p) || !expect(')')) return false;
        emit(p, line);
        return true;
    }

    bool multipoint_member() {
        if (is_empty_member()) return true;
        if (cursor_.peek() == '(') return point_body();
        Point2 p;
        if (!coordinates(p)) return false;
        emit(p, line_);
        return true;
    }

    bool linestring_body() {
        const std::uint32_t line = line_;
        Polyline2 wall;
        if (!chain(wall.points)) return false;
        emit(std::move(wall), line);
        return true;
    }

    bool polygon_body() {
        const std::uint32_t line = line_;
        Polygon2 polygon;
        if (!expect('(') || !ring(polygon.outer)) return false;
        while (cursor_.accept(',')) {
            if (!ring(polygon.holes.emplace_back())) return false;
        }
        if (!expect(')')) return false;
        emit(std::move(polygon), line);
        return true;
    }

    const ReadOptions& options_;
    detail::TextCursor cursor_;
    SceneInput2 input_;
    std::uint32_t line_ = 1;
};

void append_chain(std::string& out, const std::vector<Point2>& points, bool close) {
    out += '(';
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0) out += ", ";
        detail::append_point(out, points[i]);
    }
    if (close) {
        out += ", ";
        detail::append_point(out, points.front());
    }
    out += ')';
}

void append_polygon(std::string& out, const Polygon2& polygon) {
    if (polygon.outer.empty()) {
        out += "POLYGON EMPTY";
        return;
    }
    out += "POLYGON (";
    append_chain(out, polygon.outer, true);
    for (const Ring2& hole : polygon.holes) {
        if (hole.empty()) continue;
        out += ", ";
        append_chain(out, hole, true);
    }
    out += ')';
}

}  // namespace

Result<SceneInput2> read_wkt(std::string_view text, const ReadOptions& options) {
    return WktReader(text, options).run();
}

Result<SceneInput2> read_wkt(std::istream& in, const ReadOptions& options) {
    return read_wkt(detail::read_all(in), options);
}

void write_wkt(std::ostream& out, const SceneInput2& input) {
    std::string line;
    for (const SceneElement2& element : input.elements) {
        line.clear();
        if (const auto* polygon = std::get_if<Polygon2>(&element)) {
            append_polygon(line, *polygon);
        } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
            line += "LINESTRING ";
            if (wall->points.empty()) {
                line += "EMPTY";
            } else {
                append_chain(line, wall->points, false);
            }
        } else {
            line += "POINT (";
            detail::append_point(line, std::get<Point2>(element));
            line += ')';
        }
        line += '\n';
        out.write(line.data(), static_cast<std::streamsize>(line.size()));
    }
}

}  // namespace sightline
