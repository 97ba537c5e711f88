// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "scene/mesh_text.hpp"

namespace sightline {
namespace {

class ObjReader {
public:
    ObjReader(std::string_view text, const MeshReadOptions& options)
        : text_(text, options), cursor_(text_.cursor()) {}

    Result<MeshInput3> run() {
        if (read() && text_.mesh().faces.empty())
            cursor_.refuse(Errc::syntax, "there is no line 'f …'; is this an OBJ file with faces?");
        return text_.result();
    }

private:
    bool read() {
        if (cursor_.rest().starts_with("\xef\xbb\xbf")) cursor_.advance(3);
        for (text_.skip_to_content(); !cursor_.at_end(); text_.skip_to_content()) {
            const std::string_view word = keyword();
            if (word == "v") {
                cursor_.advance(1);
                if (!text_.vertex()) return false;
            } else if (word == "f") {
                cursor_.advance(1);
                if (!face()) return false;
            }
            skip_rest();
        }
        return check_forward();
    }

    [[nodiscard]] std::string_view keyword() const {
        const std::string_view rest = cursor_.rest();
        return rest.substr(0, rest.find_first_of(" \t\r\n\\"));
    }

    // A line that ends with a backslash goes on.
    bool continues() {
        const std::string_view rest = cursor_.rest();
        const std::size_t n = rest.starts_with("\\\n") ? 2 : rest.starts_with("\\\r\n") ? 3 : 0;
        cursor_.advance(n);
        return n != 0;
    }
    void skip_rest() {
        for (;;) {
            const std::size_t stop = cursor_.rest().find_first_of("\\\n");
            cursor_.advance(stop == std::string_view::npos ? cursor_.rest().size() : stop);
            if (cursor_.at_end() || cursor_.peek() == '\n') return;
            if (!continues()) cursor_.advance(1);
        }
    }

    bool face() {
        MeshInput3& mesh = text_.mesh();
        mesh.face_lines.push_back(cursor_.line());
        std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
        if (!text_.count()) return false;
        for (;;) {
            if (text_.at_line_end()) return true;
            if (cursor_.peek() == '\\' && continues()) continue;
            std::uint32_t v = 0;
            if (!text_.count() || !corner(v)) return false;
            face.push_back(v);
        }
    }

    bool corner(std::uint32_t& v) {
        const auto known = static_cast<std::int64_t>(text_.mesh().vertices.size());
        std::int64_t number = 0;
        if (!text_.integer(number)) return false;
        const std::int64_t index = number < 0 ? known + number : number - 1;
        if (number == 0 || index < 0 || index >= 0xffff'fff0)
            return text_.refuse_number(
                Errc::unknown_vertex,
                fmt::format("vertex {} of {} so far; numbers start at 1, or at -1 "
                            "for the last vertex",
                            number, known));
        if (index > largest_) {
            largest_ = index;
            largest_face_ = text_.mesh().faces.size() - 1;
        }
        v = static_cast<std::uint32_t>(index);
        for (int part = 0; part < 2 && cursor_.peek() == '/'; ++part) {
            cursor_.advance(1);
            const char next = cursor_.peek();
            std::int64_t ignored = 0;
            const bool given = next == '-' || (next >= '0' && next <= '9');
            if (given && !text_.integer(ignored)) return false;
        }
        const char next = cursor_.peek();
        if (cursor_.at_end() || next == ' ' || (next >= '\t' && next <= '\r') || next == '#')
            return true;
        return cursor_.refuse(Errc::syntax,
                              "expected a corner v, v/vt, v//vn or v/vt/vn, " + cursor_.found());
    }

    // A face may name a vertex that follows it.
    bool check_forward() {
        const MeshInput3& mesh = text_.mesh();
        if (largest_ < static_cast<std::int64_t>(mesh.vertices.size())) return true;
        return cursor_.refuse(
            Errc::unknown_vertex,
            fmt::format("the face in line {} names vertex {}, but there are {} "
                        "vertices; correct the number",
                        mesh.face_lines[largest_face_], largest_ + 1, mesh.vertices.size()));
    }

    detail::MeshText text_;
    detail::TextCursor& cursor_;
    std::int64_t largest_ = -1;
    std::size_t largest_face_ = 0;
};

}  // namespace

Result<MeshInput3> read_obj(std::string_view text, const MeshReadOptions& options) {
    return ObjReader(text, options).run();
}

}  // namespace sightline
