// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::detail {

/// Writes JSON as it is told to, never holding more than a buffer: for results with millions of
/// elements. Keys come in the order in which they are given.
class JsonWriter {
public:
    /// How the elements of an object or array stand: one a line, or all on one line.
    enum class Layout : std::uint8_t { lines, inline_ };

    explicit JsonWriter(std::ostream& out) : out_(out) {}
    JsonWriter(const JsonWriter&) = delete;
    JsonWriter& operator=(const JsonWriter&) = delete;
    ~JsonWriter() { flush(); }

    void begin_object(Layout layout = Layout::lines) { begin('{', '}', layout); }
    void begin_array(Layout layout = Layout::lines) { begin('[', ']', layout); }
    /// Ends the innermost object or array; ending the outermost adds a line break.
    void end();
    void key(std::string_view name);

    void value(std::string_view text);
    void value(const char* text) { value(std::string_view(text)); }
    void value(bool truth) { raw(truth ? "true" : "false"); }
    template <std::unsigned_integral Integer>
        requires(!std::same_as<Integer, bool>)
    void value(Integer number) {
        whole(number);
    }
    /// The shortest decimal that reads back to the same double; null when it isn't finite.
    void value(double number);
    /// A small tree, on one line.
    void tree(const nlohmann::ordered_json& content);
    void null() { raw("null"); }
    /// Text that is JSON already.
    void raw(std::string_view json);

    template <typename T>
    void member(std::string_view name, const T& content) {
        key(name);
        value(content);
    }

    void flush();
    /// Where the next character will stand, in bytes from the start.
    [[nodiscard]] std::uint64_t position() const noexcept { return flushed_ + buffer_.size(); }

private:
    struct Level {
        char closing;
        Layout layout;
        bool is_empty = true;
    };
    void whole(std::uint64_t number);
    void begin(char opening, char closing, Layout layout);
    void separate();
    void new_line();

    std::ostream& out_;
    std::string buffer_;
    std::uint64_t flushed_ = 0;
    std::vector<Level> levels_;
    bool after_key_ = false;
};

}  // namespace sightline::detail
