// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/text_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "scene/text_cursor.hpp"

namespace sightline {
namespace {

class TextReader {
public:
    TextReader(std::string_view text, const ReadOptions& options) : cursor_(text, options) {
        input_.world = options.world;
        input_.file = options.file;
    }

    Result<SceneInput2> run() {
        for (cursor_.skip_space(); !cursor_.at_end(); cursor_.skip_space()) {
            // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a line that fails leaves its error
            if (!line()) return tl::unexpected(*cursor_.error());
            cursor_.report_progress();
        }
        return std::move(input_);
    }

private:
    bool line() {
        if (cursor_.peek() == '#') return end_of_line();
        line_ = cursor_.line();
        const std::string_view word = cursor_.word();
        if (word == "world") return world();
        if (word == "polygon") return polygon();
        if (word == "hole") return hole();
        if (word == "wall") return wall();
        if (word == "point") return points();
        return cursor_.refuse(
            Errc::syntax,
            word.empty()
                ? "expected polygon, hole, wall, point or world, " + cursor_.found()
                : fmt::format(
                      "'{}' is no word of a scene; write polygon, hole, wall, point or world",
                      word.substr(0, 40)));
    }

    bool world() {
        const auto is_polygon = [](const SceneElement2& e) {
            return std::holds_alternative<Polygon2>(e);
        };
        if (std::any_of(input_.elements.begin(), input_.elements.end(), is_polygon)) {
            return cursor_.refuse(Errc::syntax,
                                  "'world' follows a polygon; put it before the first one");
        }
        input_.world = true;
        return end_of_line();
    }

    bool polygon() {
        Polygon2 polygon;
        if (!ring(polygon.outer)) return false;
        emit(std::move(polygon));
        return true;
    }

    bool hole() {
        auto* polygon =
            input_.elements.empty() ? nullptr : std::get_if<Polygon2>(&input_.elements.back());
        if (polygon == nullptr) {
            return cursor_.refuse(
                Errc::syntax, "'hole' does not follow a polygon; put it below its polygon's line");
        }
        return ring(polygon->holes.emplace_back());
    }

    bool wall() {
        Polyline2 wall;
        if (!chain(wall.points)) return false;
        emit(std::move(wall));
        return true;
    }

    bool points() {
        std::vector<Point2> points;
        if (!chain(points)) return false;
        for (const Point2& p : points) emit(p);
        return true;
    }

    void emit(SceneElement2 element) {
        input_.elements.push_back(std::move(element));
        input_.lines.push_back(line_);
    }

    bool ring(Ring2& points) {
        if (!chain(points)) return false;
        if (points.size() > 1 && points.front() == points.back()) points.pop_back();
        return true;
    }

    /// "x y, x y, …" up to the end of the line.
    bool chain(std::vector<Point2>& points) {
        const std::string_view rest = cursor_.rest();
        const auto end =
            rest.begin() + static_cast<std::ptrdiff_t>(std::min(rest.find('\n'), rest.size()));
        points.reserve(static_cast<std::size_t>(std::count(rest.begin(), end, ',')) + 1);
        do {
            Point2 p;
            for (double* coordinate : {&p.x, &p.y}) {
                cursor_.skip_blanks();
                if (!cursor_.number(*coordinate)) return false;
            }
            points.push_back(p);
            cursor_.skip_blanks();
        } while (take_comma());
        return end_of_line();
    }

    bool take_comma() {
        if (cursor_.peek() != ',') return false;
        cursor_.advance(1);
        return true;
    }

    bool end_of_line() {
        cursor_.skip_blanks();
        if (cursor_.at_end() || cursor_.peek() == '\n') return true;
        if (cursor_.peek() != '#') {
            return cursor_.refuse(Errc::syntax,
                                  "expected ',' or the end of the line, " + cursor_.found());
        }
        const std::string_view rest = cursor_.rest();
        cursor_.advance(std::min(rest.find('\n'), rest.size()));
        return true;
    }

    detail::TextCursor cursor_;
    SceneInput2 input_;
    std::uint32_t line_ = 1;
};

void append_line(std::string& out, std::string_view word, const std::vector<Point2>& points) {
    if (points.empty()) return;
    out += word;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out += i == 0 ? " " : ", ";
        detail::append_point(out, points[i]);
    }
    out += '\n';
}

void append_element(std::string& out, const SceneElement2& element) {
    if (const auto* polygon = std::get_if<Polygon2>(&element)) {
        append_line(out, "polygon", polygon->outer);
        if (polygon->outer.empty()) return;
        for (const Ring2& hole : polygon->holes) append_line(out, "hole", hole);
    } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
        append_line(out, "wall", wall->points);
    } else {
        append_line(out, "point", {std::get<Point2>(element)});
    }
}

}  // namespace

Result<SceneInput2> read_text(std::string_view text, const ReadOptions& options) {
    return TextReader(text, options).run();
}

Result<SceneInput2> read_text(std::istream& in, const ReadOptions& options) {
    return read_text(detail::read_all(in), options);
}

void write_text(std::ostream& out, const SceneInput2& input) {
    if (input.world) out << "world\n";
    std::string text;
    for (const SceneElement2& element : input.elements) {
        text.clear();
        append_element(text, element);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
}

std::string to_text(const Scene2& scene) {
    const SceneInput2 input = to_input(scene);
    std::string text = input.world ? "world\n" : "";
    for (const SceneElement2& element : input.elements) append_element(text, element);
    return text;
}

Result<Scene2> scene_from_text(std::string_view text) {
    const Result<SceneInput2> input = read_text(text);
    if (!input) return tl::unexpected(input.error());
    return Scene2::make(*input);
}

std::ostream& operator<<(std::ostream& out, const Scene2& scene) { return out << to_text(scene); }

}  // namespace sightline
