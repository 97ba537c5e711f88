// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of generators and transforms share.
#pragma once

#include <bit>
#include <cstdint>
#include <variant>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::families_test {

/// All points of a scene in input order, which is how Scene2 numbers its vertices.
inline std::vector<Point2> points_of(const SceneInput2& scene) {
    std::vector<Point2> points;
    const auto add = [&](const std::vector<Point2>& more) {
        points.insert(points.end(), more.begin(), more.end());
    };
    for (const SceneElement2& element : scene.elements) {
        if (const auto* polygon = std::get_if<Polygon2>(&element)) {
            add(polygon->outer);
            for (const Ring2& hole : polygon->holes) add(hole);
        } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
            add(wall->points);
        } else {
            points.push_back(std::get<Point2>(element));
        }
    }
    return points;
}

/// FNV-1a of the bits of a scene: kinds, sizes and coordinates.
class Fingerprint {
public:
    void add(std::uint64_t word) {
        for (int i = 0; i < 8; ++i)
            value_ = (value_ ^ ((word >> (8 * i)) & 0xFF)) * 0x100000001b3ULL;
    }
    void add(const Point2& p) {
        add(std::bit_cast<std::uint64_t>(p.x));
        add(std::bit_cast<std::uint64_t>(p.y));
    }
    void add(const std::vector<Point2>& points) {
        add(points.size());
        for (const Point2& p : points) add(p);
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

inline std::uint64_t fingerprint(const SceneInput2& scene) {
    Fingerprint print;
    print.add(scene.world ? 1 : 0);
    for (const SceneElement2& element : scene.elements) {
        print.add(element.index());
        if (const auto* polygon = std::get_if<Polygon2>(&element)) {
            print.add(polygon->outer);
            print.add(polygon->holes.size());
            for (const Ring2& hole : polygon->holes) print.add(hole);
        } else if (const auto* wall = std::get_if<Polyline2>(&element)) {
            print.add(wall->points);
        } else {
            print.add(std::get<Point2>(element));
        }
    }
    return print.value();
}

}  // namespace sightline::families_test
