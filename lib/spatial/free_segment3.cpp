// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/free_segment3.hpp"

#include <ostream>

namespace sightline {

namespace {

void write_end(std::ostream& out, const SegmentEnd& end) {
    out << " |";
    if (end.empty()) out << " inf";
    for (const auto& side : end) out << ' ' << to_string(side.face) << (side.back ? "-" : "");
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const SegmentLabel& label) {
    const char* separator = "";
    for (const auto v : label.support.vertices) {
        out << separator << to_string(v);
        separator = " ";
    }
    for (const auto e : label.support.edges) {
        out << separator << to_string(e);
        separator = " ";
    }
    if (!label.support.along.empty()) out << separator << "along";
    for (const auto e : label.support.along) out << ' ' << to_string(e);
    for (const auto& end : label.ends) write_end(out, end);
    return out;
}

}  // namespace sightline
