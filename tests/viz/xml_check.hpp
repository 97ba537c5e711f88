// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::viz {

/// Why a text is no well-formed XML element, or empty when it is one. Knows what our writers use:
/// a declaration, elements, double-quoted attributes, text, the predefined entities.
class XmlCheck {
public:
    static std::string fault(std::string_view text) { return XmlCheck(text).run(); }

private:
    explicit XmlCheck(std::string_view text) : rest_(text) {}

    std::string run() {
        if (rest_.starts_with("<?xml ")) rest_.remove_prefix(rest_.find("?>") + 2);
        bool seen_root = false;
        while (!rest_.empty()) {
            if (rest_[0] == '<') {
                if (open_.empty() && seen_root) return "two roots";
                if (!tag()) return fault_;
                seen_root = seen_root || open_.empty();
            } else if (!text()) {
                return fault_;
            }
        }
        return !open_.empty() ? "open: " + open_.back() : seen_root ? "" : "no element";
    }

    bool tag() {
        const std::size_t end = rest_.find('>');
        if (end == std::string_view::npos) return fail("tag without end");
        std::string_view inside = rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        if (inside.starts_with('/')) {
            if (open_.empty() || open_.back() != inside.substr(1))
                return fail("closes " + std::string(inside));
            open_.pop_back();
            return true;
        }
        const bool closed = inside.ends_with('/');
        if (closed) inside.remove_suffix(1);
        const std::string name(inside.substr(0, inside.find_first_of(" \n")));
        if (name.empty()) return fail("tag without name");
        if (!attributes(inside.substr(name.size()))) return fail("attributes of " + name);
        if (!closed) open_.push_back(name);
        return true;
    }

    bool attributes(std::string_view text) {
        std::vector<std::string> seen;
        while (true) {
            const std::size_t from = text.find_first_not_of(" \n");
            if (from == std::string_view::npos) return true;
            if (from == 0) return false;
            text.remove_prefix(from);
            const std::size_t equals = text.find("=\"");
            if (equals == std::string_view::npos) return false;
            const std::string name(text.substr(0, equals));
            for (const std::string& other : seen) {
                if (other == name) return false;
            }
            seen.push_back(name);
            text.remove_prefix(equals + 2);
            const std::size_t quote = text.find('"');
            if (quote == std::string_view::npos || !clean(text.substr(0, quote))) return false;
            text.remove_prefix(quote + 1);
        }
    }

    bool text() {
        const std::size_t end = std::min(rest_.find('<'), rest_.size());
        const std::string_view words = rest_.substr(0, end);
        rest_.remove_prefix(end);
        if (open_.empty() && words.find_first_not_of(" \n") != std::string_view::npos)
            return fail("text outside");
        return clean(words) || fail("text: " + std::string(words));
    }

    /// No bare markup, no control characters.
    static bool clean(std::string_view words) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto c = static_cast<unsigned char>(words[i]);
            if (c == '<' || (c < 0x20 && c != '\n' && c != '\t')) return false;
            if (c != '&') continue;
            bool known = false;
            for (const char* entity : {"&lt;", "&gt;", "&amp;", "&quot;", "&apos;"}) {
                known = known || words.substr(i).starts_with(entity);
            }
            if (!known) return false;
        }
        return true;
    }

    bool fail(std::string why) {
        fault_ = std::move(why);
        return false;
    }

    std::string_view rest_;
    std::vector<std::string> open_;
    std::string fault_;
};

}  // namespace sightline::viz
