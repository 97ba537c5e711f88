// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace sightline::detail {

void JsonWriter::new_line() {
    buffer_ += '\n';
    buffer_.append(2 * levels_.size(), ' ');
}

void JsonWriter::separate() {
    constexpr std::size_t enough = 1 << 16;
    if (buffer_.size() > enough) flush();
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!level.is_empty) buffer_ += level.layout == Layout::lines ? "," : ", ";
    level.is_empty = false;
    if (level.layout == Layout::lines) new_line();
}

void JsonWriter::begin(char opening, char closing, Layout layout) {
    separate();
    buffer_ += opening;
    levels_.push_back({closing, layout});
}

void JsonWriter::end() {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == Layout::lines && !level.is_empty) new_line();
    buffer_ += level.closing;
    if (levels_.empty()) {
        buffer_ += '\n';
        flush();
    }
}

void JsonWriter::key(std::string_view name) {
    value(name);
    buffer_ += ": ";
    after_key_ = true;
}

void JsonWriter::raw(std::string_view json) {
    separate();
    buffer_ += json;
}

void JsonWriter::value(std::string_view text) {
    // File names need not be UTF-8; JSON must be.
    using Json = nlohmann::json;
    raw(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

void JsonWriter::whole(std::uint64_t number) {
    std::array<char, 20> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
    raw({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void JsonWriter::value(double number) {
    if (!std::isfinite(number)) return null();
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
    raw({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void JsonWriter::tree(const nlohmann::ordered_json& content) {
    if (!content.is_structured()) {
        return raw(content.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    content.is_object() ? begin_object(Layout::inline_) : begin_array(Layout::inline_);
    for (const auto& item : content.items()) {
        if (content.is_object()) key(item.key());
        tree(item.value());
    }
    end();
}

void JsonWriter::flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    flushed_ += buffer_.size();
    buffer_.clear();
}

}  // namespace sightline::detail
