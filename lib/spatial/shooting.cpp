// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/spatial/shooting.hpp"

#include <ostream>

namespace sightline {

std::ostream& operator<<(std::ostream& out, const FreeEnd3& end) {
    if (!end.point) return out << "| inf";
    out << *end.point << " |";
    for (const FaceSide& side : end.faces) {
        out << ' ' << to_string(side.face) << (side.back ? "-" : "");
    }
    return out;
}

}  // namespace sightline
