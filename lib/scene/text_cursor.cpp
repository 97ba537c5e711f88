// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/text_cursor.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <istream>
#include <limits>

namespace sightline::detail {
namespace {

bool is_space(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_letter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Decimal exponent of the first nonzero digit of a decimal (text as from_chars took it); its sign
/// tells overflow from underflow.
bool is_large(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    std::int64_t exponent = 0;
    if (e != std::string_view::npos) {
        std::size_t digits = e + 1;
        if (digits < text.size() && text[digits] == '+') ++digits;
        const auto result =
            std::from_chars(text.data() + digits, text.data() + text.size(), exponent);
        if (result.ec == std::errc::result_out_of_range) return text[digits] != '-';
    }
    const std::string_view mantissa = text.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    const auto before_point = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
    return exponent > -before_point;
}

}  // namespace

void append_number(std::string& out, double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, result.ptr);
}

void append_point(std::string& out, const Point2& p) {
    append_number(out, p.x);
    out += ' ';
    append_number(out, p.y);
}

double parse_double(std::string_view text, std::size_t& used) {
    used = 0;
    const std::size_t plus = !text.empty() && text[0] == '+' ? 1 : 0;
    const char* first = text.data() + plus;
    const char* last = text.data() + text.size();
    if (plus == 1 && first != last && *first == '-') return 0;
    double value = 0;
    const auto result = std::from_chars(first, last, value);
    if (result.ec == std::errc::invalid_argument) return 0;
    used = static_cast<std::size_t>(result.ptr - text.data());
    if (result.ec == std::errc{}) return value;
    const bool negative = *first == '-';
    const std::string_view taken(first, static_cast<std::size_t>(result.ptr - first));
    value = is_large(taken) ? std::numeric_limits<double>::infinity() : 0.0;
    return negative ? -value : value;
}

std::string read_all(std::istream& in) {
    std::string text;
    char buffer[1 << 16];
    while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(in.gcount()));
    }
    return text;
}

void TextCursor::skip_space() noexcept {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

void TextCursor::skip_blanks() noexcept {
    while (at_ < text_.size() && is_space(text_[at_]) && text_[at_] != '\n') ++at_;
}

bool TextCursor::accept(char c) noexcept {
    skip_space();
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
}

std::string_view TextCursor::word() noexcept {
    const std::size_t first = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
}

bool TextCursor::number(double& value) {
    std::size_t used = 0;
    value = parse_double(text_.substr(at_), used);
    const char next = at_ + used < text_.size() ? text_[at_ + used] : ' ';
    if (used == 0 || is_letter(next) || is_digit(next) || next == '.' || next == '+' ||
        next == '-') {
        return refuse(Errc::syntax, "expected a number, " + found());
    }
    // "inf" itself is read, and refused where scenes are made; a decimal must not become it.
    if (value - value != 0 &&
        text_.substr(at_, used).find_first_of("0123456789") != std::string_view::npos) {
        return refuse(Errc::coordinate_too_large,
                      "the number is beyond the doubles; give one below 2^1020 in size");
    }
    at_ += used;
    return true;
}

std::uint32_t TextCursor::line() {
    while (counted_to_ < at_) {
        const void* hit = std::memchr(text_.data() + counted_to_, '\n', at_ - counted_to_);
        if (hit == nullptr) {
            counted_to_ = at_;
            break;
        }
        counted_to_ = static_cast<std::size_t>(static_cast<const char*>(hit) - text_.data()) + 1;
        line_start_ = counted_to_;
        ++line_;
    }
    return line_;
}

bool TextCursor::refuse(Errc code, std::string_view what) {
    if (error_) return false;
    const std::uint32_t at_line = line();
    const std::string where = options_.file.empty() ? "line " : options_.file + ":";
    error_ = Error{code, fmt::format("{}{}:{}: {}", where, at_line, at_ - line_start_ + 1, what)};
    return false;
}

std::string TextCursor::found() const {
    if (at_end()) return "but the text ends";
    std::size_t n = 1;
    while (n < 12 && at_ + n < text_.size() && !is_space(text_[at_ + n]) &&
           std::strchr("(),;", text_[at_ + n]) == nullptr)
        ++n;
    std::string shown;
    for (const char c : text_.substr(at_, n)) {
        if (c == '\n') {
            shown += "\\n";
        } else if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) {
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            shown += c;
        }
    }
    return "found '" + shown + "'";
}

void TextCursor::report_progress() {
    if (options_.progress && !text_.empty()) {
        options_.progress(static_cast<double>(at_) / static_cast<double>(text_.size()));
    }
}

}  // namespace sightline::detail
