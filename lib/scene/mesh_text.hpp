// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the readers of OFF and OBJ share. Private.

#include <cstdint>
#include <string_view>

#include "scene/text_cursor.hpp"
#include "sightline/scene/mesh_io.hpp"

namespace sightline::detail {

/// A text of lines, words and numbers with `#` comments.
class MeshText {
public:
    MeshText(std::string_view text, const MeshReadOptions& options)
        : max_elements_(options.max_elements), cursor_(text, read_options_) {
        read_options_.file = options.file;
        mesh_.kind = options.kind;
        mesh_.file = options.file;
    }
    MeshText(const MeshText&) = delete;
    MeshText& operator=(const MeshText&) = delete;

    [[nodiscard]] TextCursor& cursor() { return cursor_; }
    [[nodiscard]] MeshInput3& mesh() { return mesh_; }

    /// Skips blanks, line ends and comments.
    void skip_to_content();
    /// Skips blanks, and a comment; whether the line ends here.
    bool at_line_end();
    /// Skips the rest of the line.
    void skip_line();
    /// Takes a whole number.
    bool integer(std::int64_t& value);
    /// Notes an error at the number that was taken last. Returns false.
    bool refuse_number(Errc code, std::string_view what);
    /// Takes three coordinates that stand on this line as the next vertex.
    bool vertex();
    /// Counts one more vertex, face or corner.
    bool count();
    [[nodiscard]] Result<MeshInput3> result();

private:
    ReadOptions read_options_;
    std::size_t max_elements_;
    std::size_t elements_ = 0;
    std::size_t last_number_ = 0;  ///< its length
    TextCursor cursor_;
    MeshInput3 mesh_;
};

}  // namespace sightline::detail
