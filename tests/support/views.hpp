// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility polygons in tests: written down and shown.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "sightline/reference/visibility_polygon.hpp"

namespace sightline::testing {

/// "3,1/2": a point with exact coordinates.
inline RationalPoint2 exact_point2(const std::string& text) {
    const auto comma = text.find(',');
    return {*Rational::parse(text.substr(0, comma)), *Rational::parse(text.substr(comma + 1))};
}

/// "x,y" for a point and "@x,y" for a vertex at infinity, in its canonical scale.
inline std::string to_string(const ViewPoint& p) {
    return (p.at_infinity ? "@" : "") + p.coordinates.x.to_string() + "," +
           p.coordinates.y.to_string();
}

inline std::string to_string(const std::vector<ViewPoint>& ring) {
    std::ostringstream text;
    for (std::size_t i = 0; i < ring.size(); ++i) text << (i == 0 ? "" : " ") << to_string(ring[i]);
    return text.str();
}

inline std::string to_string(const std::vector<reference::SeenSegment>& needles) {
    std::ostringstream text;
    for (const auto& [near, far] : needles)
        text << to_string(near) << ".." << to_string(far) << ' ';
    return text.str();
}

}  // namespace sightline::testing
