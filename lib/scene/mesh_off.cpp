// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/mesh_text.hpp"

namespace sightline {
namespace {

constexpr std::int64_t largest_count = 0xffff'fff0;

class OffReader {
public:
    OffReader(std::string_view text, const MeshReadOptions& options)
        : text_(text, options), cursor_(text_.cursor()) {}

    Result<MeshInput3> run() {
        static_cast<void>(read());
        return text_.result();
    }

private:
    bool read() {
        if (!header() || !counts()) return false;
        for (std::int64_t v = 0; v < vertices_; ++v)
            if (!vertex(v)) return false;
        for (std::int64_t f = 0; f < faces_; ++f)
            if (!face(f)) return false;
        text_.skip_to_content();
        if (cursor_.at_end()) return true;
        return cursor_.refuse(Errc::syntax,
                              fmt::format("expected the end after {} faces, {}; correct the counts",
                                          faces_, cursor_.found()));
    }

    bool header() {
        if (cursor_.rest().starts_with("\xef\xbb\xbf")) cursor_.advance(3);
        text_.skip_to_content();
        // Geomview: [ST][C][N][4][n]OFF, and the word may be missing.
        std::string_view rest = cursor_.rest();
        std::size_t used = 0;
        const auto accept = [&](std::string_view word) {
            if (!rest.substr(used).starts_with(word)) return false;
            used += word.size();
            return true;
        };
        const bool texture = accept("ST");
        const bool colour = accept("C");
        const bool normal = accept("N");
        const bool four = accept("4");
        const bool general = accept("n");
        if (!accept("OFF")) {
            if (used > (four ? 1U : 0U) || rest.empty() || rest[0] < '+' || rest[0] > '9')
                return cursor_.refuse(Errc::syntax,
                                      "expected the word OFF or the counts, " + cursor_.found());
            return true;
        }
        if (four || general)
            return cursor_.refuse(Errc::unsupported,
                                  "vertices of other than three coordinates; convert the file");
        extras_ = texture || colour || normal;
        cursor_.advance(used);
        cursor_.skip_blanks();
        if (cursor_.rest().starts_with("BINARY"))
            return cursor_.refuse(Errc::unsupported, "binary OFF; convert the file to text");
        return true;
    }

    bool counts() {
        text_.skip_to_content();
        if (!count(vertices_, "vertices")) return false;
        text_.skip_to_content();
        if (!count(faces_, "faces")) return false;
        if (text_.at_line_end()) return true;
        std::int64_t edges = 0;
        if (!text_.integer(edges)) return false;
        return line_end("the counts");
    }

    bool count(std::int64_t& value, std::string_view what) {
        if (!text_.integer(value)) return false;
        if (value < 0 || value > largest_count)
            return text_.refuse_number(
                Errc::syntax, fmt::format("{} {}: give a number from 0 to 2^32", value, what));
        return true;
    }

    bool line_end(std::string_view after) {
        if (text_.at_line_end()) return true;
        return cursor_.refuse(Errc::syntax, fmt::format("expected the end of the line after {}, {}",
                                                        after, cursor_.found()));
    }

    bool vertex(std::int64_t v) {
        text_.skip_to_content();
        if (cursor_.at_end())
            return cursor_.refuse(
                Errc::syntax, fmt::format("the text ends after {} of {} vertices", v, vertices_));
        if (!text_.vertex()) return false;
        if (extras_) {
            text_.skip_line();
            return true;
        }
        return line_end(
            "three coordinates (a file with colours or normals starts with COFF or NOFF)");
    }

    bool face(std::int64_t f) {
        text_.skip_to_content();
        if (cursor_.at_end())
            return cursor_.refuse(Errc::syntax,
                                  fmt::format("the text ends after {} of {} faces", f, faces_));
        MeshInput3& mesh = text_.mesh();
        mesh.face_lines.push_back(cursor_.line());
        std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
        std::int64_t size = 0;
        if (!text_.count() || !count(size, "vertices of a face")) return false;
        face.reserve(
            std::min<std::size_t>(static_cast<std::size_t>(size), cursor_.rest().size() / 2));
        for (std::int64_t i = 0; i < size; ++i) {
            text_.skip_to_content();
            std::int64_t v = 0;
            if (!text_.count() || !text_.integer(v)) return false;
            if (v < 0 || v >= vertices_)
                return text_.refuse_number(
                    Errc::unknown_vertex,
                    fmt::format("face {} names vertex {}, but there are {} vertices "
                                "(the first is 0); correct the number",
                                f, v, vertices_));
            face.push_back(static_cast<std::uint32_t>(v));
        }
        text_.skip_line();  // a colour
        return true;
    }

    detail::MeshText text_;
    detail::TextCursor& cursor_;
    std::int64_t vertices_ = 0;
    std::int64_t faces_ = 0;
    bool extras_ = false;
};

}  // namespace

Result<MeshInput3> read_off(std::string_view text, const MeshReadOptions& options) {
    return OffReader(text, options).run();
}

}  // namespace sightline
