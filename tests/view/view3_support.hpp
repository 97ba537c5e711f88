// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of views share.
#pragma once

#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "sightline/reference/free_segment3.hpp"
#include "sightline/reference/view3.hpp"
#include "sightline/view/view3.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"
#include "support/scenes3.hpp"

namespace sightline::testing {

inline Viewpoint3 at(const Rational& x, const Rational& y, const Rational& z) {
    return {{x, y, z}, false};
}
inline Viewpoint3 along(const Rational& x, const Rational& y, const Rational& z) {
    return {{x, y, z}, true};
}

inline Result<View3> look(const PointVisibility3& visibility, const Viewpoint3& from,
                          const View3Options& options = {}) {
    const RationalPoint3& c = from.coordinates;
    return from.at_infinity ? visibility.along({c.x, c.y, c.z}, options)
                            : visibility.from(c, options);
}

/// The map is one of the sphere (or of the plane, and infinity): Euler's formula holds, rings fit arcs, and both
/// sides of every arc say what their regions say.
inline void expect_planar_map(const ViewMap3& map) {
    std::vector<std::size_t> parent(map.nodes.size());
    std::vector<std::size_t> degree(map.nodes.size(), 0);
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i];
        return i;
    };
    for (const ViewArc& arc : map.arcs) {
        ++degree[arc.source];
        ++degree[arc.target];
        parent[root(arc.source)] = root(arc.target);
    }
    // Nodes without arcs are holes of no area: they count neither as nodes nor as components.
    std::size_t nodes = 0;
    std::size_t components = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) {
        if (degree[i] == 0) continue;
        ++nodes;
        if (root(i) == i) ++components;
    }
    EXPECT_EQ(nodes + map.regions.size(), map.arcs.size() + components + 1) << map;
    std::map<ViewHalfArc, std::uint32_t> region_of;
    for (std::uint32_t r = 0; r < map.regions.size(); ++r) {
        for (const auto& ring : map.regions[r].rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                EXPECT_TRUE(region_of.emplace(ring[i], r).second);
                const ViewHalfArc& next = ring[(i + 1) % ring.size()];
                const ViewArc& a = map.arcs[ring[i].arc];
                const ViewArc& b = map.arcs[next.arc];
                EXPECT_EQ(ring[i].reversed ? a.source : a.target,
                          next.reversed ? b.target : b.source);
            }
        }
    }
    EXPECT_EQ(region_of.size(), 2 * map.arcs.size());
    for (std::uint32_t i = 0; i < map.arcs.size(); ++i) {
        EXPECT_EQ(region_of[(ViewHalfArc{i, false})], map.arcs[i].left);
        EXPECT_EQ(region_of[(ViewHalfArc{i, true})], map.arcs[i].right);
    }
}

/// Lines of one text that the other has not.
inline std::string difference(const std::string& a, const std::string& b) {
    std::multiset<std::string> lines;
    std::istringstream in(b);
    for (std::string line; std::getline(in, line);) lines.insert(line);
    std::string only;
    std::istringstream in_a(a);
    for (std::string line; std::getline(in_a, line);) {
        const auto found = lines.find(line);
        if (found == lines.end()) {
            only += "  " + line + "\n";
        } else {
            lines.erase(found);
        }
    }
    return only;
}

template <typename T>
std::string text_of(const T& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

/// Fast and slow agree on a view, and the fast one is a map.
inline bool expect_same_view(const Scene3& scene, const PointVisibility3& visibility,
                             const Viewpoint3& from, const std::string& what) {
    SCOPED_TRACE(what);
    const auto view = [&]() -> Result<View3> {
        try {
            return look(visibility, from);
        } catch (const ContractViolation& violation) {
            return fail(Errc::bad_parameter, violation.what());
        }
    }();
    if (!view) {
        ADD_FAILURE() << view.error().message;
        return false;
    }
    expect_planar_map(view->map);
    const auto expected = reference::view3(scene, from);
    const auto got = reference::labels_of(*view);
    if (got == expected) return !::testing::Test::HasFailure();
    const std::string a = text_of(got);
    const std::string b = text_of(expected);
    ADD_FAILURE() << "only found:\n" << difference(a, b) << "only expected:\n" << difference(b, a);
    return false;
}

/// A viewpoint or direction, often in a special position: on the grid, halves, thirds, far away.
inline Viewpoint3 random_viewpoint(std::mt19937_64& bits, int grid) {
    const auto pick = [&](int n) { return static_cast<int>(bits() % static_cast<unsigned>(n)); };
    if (pick(4) == 0) {
        std::array<int, 3> d{};
        while (d[0] == 0 && d[1] == 0 && d[2] == 0) {
            for (int& x : d) x = pick(5) - 2;
        }
        return along(d[0], d[1], d[2]);
    }
    const int scale = std::array{1, 1, 2, 3}[static_cast<std::size_t>(pick(4))];
    const auto coordinate = [&] {
        return Rational(pick((grid + 4) * scale + 1) - 2 * scale) / scale;
    };
    const Rational x = coordinate();
    const Rational y = coordinate();
    return at(x, y, coordinate());
}

/// Compares `views` views of each random scene of the given seeds; returns how many, and stops at the first failure.
inline int compare_on(std::uint64_t first, std::uint64_t last, int views) {
    int looked = 0;
    for (std::uint64_t seed = first; seed < last; ++seed) {
        const SceneInput3 input = random_scene3(seed);
        const Scene3 scene = scene3(input);
        const PointVisibility3 visibility(scene);
        std::mt19937_64 bits(seed);
        for (int i = 0; i < views; ++i) {
            const Viewpoint3 from = random_viewpoint(bits, 2 + static_cast<int>(seed % 5));
            if (!from.at_infinity && reference::is_interior(scene, from.coordinates)) {
                EXPECT_FALSE(look(visibility, from).has_value());
                continue;
            }
            ++looked;
            const std::string what = "seed " + std::to_string(seed) +
                                     (from.at_infinity ? " along " : " from ") +
                                     text_of(from.coordinates) + "\n" + to_text(input);
            if (!expect_same_view(scene, visibility, from, what)) return looked;
        }
    }
    return looked;
}

/// Compares views of one scene from special places and directions.
inline void compare_degenerate(const Scene3& scene) {
    const PointVisibility3 visibility(scene);
    const bool has_world = scene.bodies().front().is_world;
    std::vector<Viewpoint3> views{at(-3, Rational(1) / 2, Rational(1) / 2),
                                  at(1, 1, 1),
                                  at(Rational(1) / 2, Rational(1) / 2, 5),
                                  at(7, 0, 0),
                                  at(0, 0, 0),
                                  at(2, Rational(3) / 2, 2)};
    if (!has_world) {
        views.push_back(along(1, 0, 0));
        views.push_back(along(-1, -1, -1));
        views.push_back(along(0, 1, -1));
    }
    for (const Viewpoint3& from : views) {
        if (!from.at_infinity && reference::is_interior(scene, from.coordinates)) {
            EXPECT_FALSE(look(visibility, from).has_value());
            continue;
        }
        const std::string what =
            (from.at_infinity ? "along " : "from ") + text_of(from.coordinates);
        if (!expect_same_view(scene, visibility, from, what)) return;
    }
}

}  // namespace sightline::testing
