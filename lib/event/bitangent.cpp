// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/bitangent.hpp"

#include <charconv>
#include <ostream>
#include <sstream>

namespace sightline {
namespace {

constexpr std::string_view letters = "LROB";

// Takes pieces of a text from its start; after a failure everything else fails.
class Pieces {
public:
    explicit Pieces(std::string_view text) : rest_(text) {}

    Side side() {
        const auto letter = rest_.empty() ? std::string_view::npos : letters.find(rest_[0]);
        if (letter == std::string_view::npos) {
            ok_ = false;
            return Side::left;
        }
        rest_.remove_prefix(1);
        return static_cast<Side>(letter);
    }
    void word(std::string_view expected) {
        if (rest_.substr(0, expected.size()) != expected)
            ok_ = false;
        else
            rest_.remove_prefix(expected.size());
    }
    template <typename Number>
    Number number() {
        Number value{};
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{})
            ok_ = false;
        else
            rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    VertexId vertex() {
        word("v");
        return {number<std::uint32_t>()};
    }
    BodyId body() {
        word("b");
        if (!rest_.empty() && rest_[0] == '-') {
            rest_.remove_prefix(1);
            return BodyId::none();
        }
        return {number<std::uint32_t>()};
    }
    [[nodiscard]] bool is_done() const { return ok_ && rest_.empty(); }

private:
    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace

char letter_of(Side side) noexcept { return letters[static_cast<std::size_t>(side)]; }

std::ostream& operator<<(std::ostream& out, Side side) { return out << letter_of(side); }

std::string Bitangent::type() const { return {letter_of(source_side), letter_of(target_side)}; }

std::string to_string(const Bitangent& b) {
    return b.type() + ' ' + to_string(b.source) + ' ' + to_string(b.target) + ' ' +
           to_string(b.source_body) + ' ' + to_string(b.target_body);
}

Result<Bitangent> bitangent_from_text(std::string_view text) {
    Pieces pieces(text);
    Bitangent b;
    b.source_side = pieces.side();
    b.target_side = pieces.side();
    pieces.word(" ");
    b.source = pieces.vertex();
    pieces.word(" ");
    b.target = pieces.vertex();
    pieces.word(" ");
    b.source_body = pieces.body();
    pieces.word(" ");
    b.target_body = pieces.body();
    if (pieces.is_done()) return b;
    return fail(Errc::syntax, "'" + std::string(text) +
                                  "' is no bitangent; write one as 'LR v1 v3 b0 b1', b- for none");
}

std::ostream& operator<<(std::ostream& out, const Bitangent& b) { return out << to_string(b); }

std::string to_string(const SupportingLine2& line) {
    std::ostringstream out;
    out << line.side << ' ' << to_string(line.contact) << ' ' << to_string(line.body) << ' '
        << line.from;
    return out.str();
}

Result<SupportingLine2> supporting_line_from_text(std::string_view text) {
    Pieces pieces(text);
    SupportingLine2 line;
    line.side = pieces.side();
    pieces.word(" ");
    line.contact = pieces.vertex();
    pieces.word(" ");
    line.body = pieces.body();
    pieces.word(" (");
    line.from.x = pieces.number<double>();
    pieces.word(", ");
    line.from.y = pieces.number<double>();
    pieces.word(")");
    if (pieces.is_done()) return line;
    return fail(Errc::syntax, "'" + std::string(text) +
                                  "' is no supporting line; write one as 'L v3 b0 (1, 2.5)'");
}

std::ostream& operator<<(std::ostream& out, const SupportingLine2& line) {
    return out << to_string(line);
}

}  // namespace sightline
