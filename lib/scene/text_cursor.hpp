// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sightline/scene/scene_io.hpp"

namespace sightline::detail {

/// Appends the shortest decimal that reads back to the same double.
void append_number(std::string& out, double value);
/// Appends "x y".
void append_point(std::string& out, const Point2& p);

/// The nearest double to a decimal; independent of the locale. `used`: how many characters it took;
/// 0 when there is no number. Infinite when the decimal is beyond the doubles.
[[nodiscard]] double parse_double(std::string_view text, std::size_t& used);

/// Whole contents of a stream.
[[nodiscard]] std::string read_all(std::istream& in);

/// A place in a text: characters, words and numbers from here on, and errors that say where.
class TextCursor {
public:
    TextCursor(std::string_view text, const ReadOptions& options)
        : text_(text), options_(options) {}

    [[nodiscard]] bool at_end() const noexcept { return at_ == text_.size(); }
    [[nodiscard]] char peek() const noexcept { return at_end() ? '\0' : text_[at_]; }
    [[nodiscard]] std::string_view rest() const noexcept { return text_.substr(at_); }
    void advance(std::size_t n) noexcept { at_ += n; }
    /// Goes back, within the line.
    void retreat(std::size_t n) noexcept { at_ -= n; }
    /// Skips blanks and line ends.
    void skip_space() noexcept;
    /// Skips blanks but not line ends.
    void skip_blanks() noexcept;
    /// Takes c after white space.
    bool accept(char c) noexcept;
    /// Takes the letters that stand here; possibly none.
    [[nodiscard]] std::string_view word() noexcept;
    /// Takes a number; on failure the error is set.
    bool number(double& value);

    /// Line of the current place, from 1. Amortised one pass over the text.
    [[nodiscard]] std::uint32_t line();
    /// Notes an error at the current place; the first one stays. Returns false.
    bool refuse(Errc code, std::string_view what);
    /// "found 'x'" or "the text ends".
    [[nodiscard]] std::string found() const;
    [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }
    void report_progress();

private:
    std::string_view text_;
    const ReadOptions& options_;
    std::size_t at_ = 0;
    std::size_t counted_to_ = 0;
    std::size_t line_start_ = 0;
    std::uint32_t line_ = 1;
    std::optional<Error> error_;
};

}  // namespace sightline::detail
