// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/geom/point.hpp"

#include <array>
#include <charconv>
#include <ostream>
#include <string_view>

namespace sightline {

namespace {

std::ostream& write_shortest(std::ostream& out, double x) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.begin(), text.end(), x).ptr;
    return out << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Point2& p) {
    out << '(';
    write_shortest(out, p.x) << ", ";
    return write_shortest(out, p.y) << ')';
}

std::ostream& operator<<(std::ostream& out, const RationalPoint2& p) {
    return out << '(' << p.x << ", " << p.y << ')';
}

std::ostream& operator<<(std::ostream& out, const Point3& p) {
    out << '(';
    write_shortest(out, p.x) << ", ";
    write_shortest(out, p.y) << ", ";
    return write_shortest(out, p.z) << ')';
}

std::ostream& operator<<(std::ostream& out, const RationalPoint3& p) {
    return out << '(' << p.x << ", " << p.y << ", " << p.z << ')';
}

}  // namespace sightline
