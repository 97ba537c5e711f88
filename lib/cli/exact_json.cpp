// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exact_json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sightline::detail {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

}  // namespace

Result<RationalPoint2> parse_point(const std::string& option, std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma != std::string_view::npos) {
        const auto x = Rational::parse(trimmed(text.substr(0, comma)));
        const auto y = Rational::parse(trimmed(text.substr(comma + 1)));
        if (x && y) return RationalPoint2{*x, *y};
    }
    return fail(Errc::bad_parameter,
                fmt::format("{}: '{}' is no point; write X,Y with decimals or fractions, as in "
                            "1.5,-7/2",
                            option, text));
}

Result<Point2> parse_scene_point(const std::string& option, std::string_view text) {
    const Result<RationalPoint2> exact = parse_point(option, text);
    if (!exact) return tl::unexpected(exact.error());
    const Point2 p = approx_point(*exact);
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        return fail(Errc::coordinate_too_large,
                    fmt::format("{}: '{}' has a coordinate beyond the doubles; scale the scene",
                                option, text));
    }
    return p;
}

void write_point(JsonWriter& json, const RationalPoint2& p) {
    json.begin_array(JsonWriter::Layout::inline_);
    json.value(p.x.to_string());
    json.value(p.y.to_string());
    json.end();
}

void write_point(JsonWriter& json, const Point2& p) { write_point(json, to_rational(p)); }

void write_number(JsonWriter& json, const Surd& x) {
    if (x.is_rational()) return json.value(x.rational_part().to_string());
    json.begin_object(JsonWriter::Layout::inline_);
    json.member("a", x.rational_part().to_string());
    json.member("b", x.root_sign() == Sign::negative ? "-1" : "1");
    json.member("c", x.radicand().to_string());
    json.end();
}

void write_line(JsonWriter& json, const SurdLine3& line) {
    json.begin_array(JsonWriter::Layout::inline_);
    for (const Surd& x : line.coordinates()) write_number(json, x);
    json.end();
}

nlohmann::ordered_json to_json(const RationalPoint2& p) {
    return nlohmann::ordered_json::array({p.x.to_string(), p.y.to_string()});
}

nlohmann::ordered_json to_json(const Point2& p) { return to_json(to_rational(p)); }

}  // namespace sightline::detail
