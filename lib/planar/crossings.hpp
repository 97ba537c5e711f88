// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "planar/triangulation.hpp"

namespace sightline::detail {

/// What a cone of sight meets when it enters a free triangle through one edge: half a cache line that
/// holds all that one step of the expansion reads.
struct alignas(32) Crossing {
    double x, y;  ///< the apex opposite the edge
    Place apex;
    /// Where the cone goes on through the edge on its left (apex…left end), [0], and on its right, [1]; or
    /// no_index.
    std::uint32_t exits[2];
    std::uint32_t flags;  ///< of the apex
};
inline constexpr std::uint32_t is_vertex_flag = 1;  ///< a scene vertex lies there
inline constexpr std::uint32_t is_knot_flag = 2;

/// The free part of a triangulation as the graph of its crossings. Index 3 t + i: entering triangle t
/// through its edge i.
class Crossings {
public:
    explicit Crossings(const Triangulation& t, unsigned threads = 1);

    [[nodiscard]] const Crossing& operator[](std::uint32_t i) const noexcept {
        return crossings_[i];
    }
    [[nodiscard]] static constexpr std::uint32_t index(HalfEdge h) noexcept {
        return (h >> 2U) * 3 + (h & 3U);
    }
    [[nodiscard]] static constexpr HalfEdge half_edge(std::uint32_t index) noexcept {
        return index / 3 * 4 + index % 3;
    }
    /// The crossing through h out of its triangle, or no_index when nothing can pass.
    [[nodiscard]] static std::uint32_t beyond(const Triangulation& t, HalfEdge h) noexcept {
        return t.is_open(h) ? index(t.twin(h)) : no_index;
    }

private:
    void fill(const Triangulation& t, HalfEdge begin, HalfEdge end);

    std::vector<Crossing> crossings_;
};

}  // namespace sightline::detail
