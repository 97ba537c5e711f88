// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/segment_file.hpp"

#include <algorithm>
#include <cstddef>

namespace sightline {

namespace {

constexpr std::size_t longest_shown = 40;

std::string place(const std::string& name, std::size_t line) {
    return name + ":" + std::to_string(line) + ": ";
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

// One word at a time, with its line.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    [[nodiscard]] bool next() {
        skip();
        std::size_t end = at_;
        while (end < text_.size() && !is_space(text_[end]) && text_[end] != '#') ++end;
        word_ = text_.substr(at_, end - at_);
        at_ = end;
        return !word_.empty();
    }
    [[nodiscard]] std::string_view word() const { return word_; }
    [[nodiscard]] std::size_t line() const { return line_; }

private:
    void skip() {
        bool is_comment = false;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '#') is_comment = true;
            if (!is_comment && !is_space(c)) return;
            if (c != '\n') continue;
            ++line_;
            is_comment = false;
        }
    }

    std::string_view text_;
    std::string_view word_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

struct Points {
    std::vector<RationalPoint3> points;
    std::vector<std::size_t> lines;  // on which each point begins
};

Result<Points> read_points(std::string_view text, const std::string& name, std::size_t corners,
                           const std::string& what) {
    Words words(text);
    std::vector<Rational> numbers;
    Points result;
    const auto object = [&] { return what + " " + std::to_string(numbers.size() / 3 / corners); };
    while (words.next()) {
        auto number = Rational::parse(words.word());
        if (!number) {
            return fail(Errc::syntax, place(name, words.line()) + object() + ": '" +
                                          std::string(words.word().substr(0, longest_shown)) +
                                          "' is no number; write a decimal as 1.5 or 2e-3, or a "
                                          "fraction as 3/7");
        }
        if (numbers.size() % 3 == 0) result.lines.push_back(words.line());
        numbers.push_back(std::move(*number));
    }
    if (numbers.size() % (3 * corners) != 0) {
        return fail(Errc::syntax, place(name, words.line()) + "the text ends within " + object() +
                                      "; each has " + std::to_string(3 * corners) + " numbers");
    }
    if (numbers.empty()) {
        return fail(Errc::empty_scene, name + ": there is no " + what + "; write " +
                                           std::to_string(3 * corners) + " numbers for each");
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
        result.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    }
    return result;
}

}  // namespace

Result<std::vector<RationalSegment3>> read_segments(std::string_view text,
                                                    const std::string& name) {
    auto read = read_points(text, name, 2, "segment");
    if (!read) return tl::unexpected(read.error());
    std::vector<RationalSegment3> segments;
    for (std::size_t i = 0; i < read->points.size(); i += 2) {
        segments.push_back({read->points[i], read->points[i + 1]});
    }
    return segments;
}

Result<std::vector<RationalTriangle3>> read_triangles(std::string_view text,
                                                      const std::string& name) {
    auto read = read_points(text, name, 3, "triangle");
    if (!read) return tl::unexpected(read.error());
    std::vector<RationalTriangle3> triangles;
    for (std::size_t i = 0; i < read->points.size(); i += 3) {
        const auto& p = read->points;
        if (plane_through(p[i], p[i + 1], p[i + 2]).is_degenerate()) {
            return fail(Errc::zero_length, place(name, read->lines[i]) + "triangle " +
                                               std::to_string(i / 3) +
                                               ": its corners are collinear; move one");
        }
        triangles.push_back({p[i], p[i + 1], p[i + 2]});
    }
    return triangles;
}

}  // namespace sightline
