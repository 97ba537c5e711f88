// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

/// B ∪ W near each vertex of a scene, whatever touches it there: which lines through the vertex are
/// locally tangent. Exact.
class Surroundings {
public:
    /// O(n log n + touching pairs).
    explicit Surroundings(const Scene2& scene);

    /// Whether some line is locally tangent at v.
    [[nodiscard]] bool has_tangents(VertexId v) const { return at_[v].kind != Kind::reflex; }
    /// Whether a short piece of the line from p (at another place) through v is free round v, as
    /// far as walls that leave v along the line don't decide otherwise farther away.
    [[nodiscard]] bool is_tangent(const Point2& p, VertexId v) const;

private:
    enum class Kind : std::uint8_t {
        open,    ///< nothing: always tangent
        sector,  ///< one sector of B of at most 180°: when its edges lie on one closed side
        reflex,  ///< one sector of more, or all: never
        general  ///< several sectors, or walls
    };
    /// What leaves the place along one direction.
    struct Arm {
        Point2 tip;
        bool wall = false;
        bool solid_left = false;  ///< of the arm, seen from the place
        bool solid_right = false;
        bool solid = false;  ///< the sector from here to the next arm, counter-clockwise
    };
    struct Around {
        Kind kind = Kind::open;
        Point2 first;  ///< on the edges of the sector
        Point2 last;
        std::uint32_t arms = 0;  ///< place in arms_, when general
    };
    /// Where a ray leaves the place: along an arm, or in the sector after it.
    struct Spot {
        std::size_t arm = 0;
        bool on_arm = false;
    };

    void survey(const std::vector<VertexId>& vertices, std::vector<Arm> arms);
    static void add(std::vector<Arm>& arms, const Point2& place, const Arm& arm);
    static void find_sectors(std::vector<Arm>& arms, const Point2& place);
    [[nodiscard]] static Spot locate(const std::vector<Arm>& arms, const Point2& place,
                                     const Point2& p, bool away);
    [[nodiscard]] static bool can_pass(const std::vector<Arm>& arms, const Spot& in,
                                       const Spot& out);

    const Scene2* scene_;
    PerVertex<Around> at_;
    std::vector<std::vector<Arm>> arms_;
};

}  // namespace sightline::detail
