// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths in tests: shown, measured, checked.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "sightline/planar/shortest_path.hpp"
#include "sightline/reference/free_segment.hpp"
#include "support/views.hpp"

namespace sightline::testing {

/// "0,0 1/2,3 (v4)": points, then vertices.
inline std::string to_string(const ShortestPath& path) {
    std::ostringstream text;
    for (const RationalPoint2& p : path.points) text << to_string(ViewPoint{p, false}) << ' ';
    text << '(';
    for (const VertexId v : path.vertices)
        text << (v == path.vertices.front() ? "v" : " v") << v.value;
    text << ')';
    return text.str();
}

/// The squared lengths of its segments.
inline std::vector<Rational> squared_lengths(const ShortestPath& path) {
    std::vector<Rational> squares;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const Rational dx = path.points[i].x - path.points[i - 1].x;
        const Rational dy = path.points[i].y - path.points[i - 1].y;
        squares.push_back(dx * dx + dy * dy);
    }
    return squares;
}

/// Ends as asked for, vertices where the points say, every segment free.
inline void expect_valid_path(const Scene2& scene, const ShortestPath& path,
                              const RationalPoint2& from, const RationalPoint2& to) {
    ASSERT_FALSE(path.points.empty());
    EXPECT_EQ(path.points.front(), from);
    EXPECT_EQ(path.points.back(), to);
    for (std::size_t i = 0; i < path.vertices.size(); ++i) {
        ASSERT_LT(i + 2, path.points.size());
        EXPECT_EQ(path.points[i + 1], to_rational(scene[path.vertices[i]]));
    }
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        EXPECT_TRUE(reference::is_free(scene, path.points[i - 1], path.points[i]))
            << to_string(path);
    }
}

}  // namespace sightline::testing
