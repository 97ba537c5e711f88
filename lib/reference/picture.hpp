// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "reference/place.hpp"
#include "sightline/scene/result.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::reference {

/// What leaves a place along one direction: pieces of walls, of boundaries of B, or of both.
struct Arm {
    Place tip;  ///< a place in that direction
    bool wall = false;
    bool solid_left = false;   ///< a body edge here has B on the counter-clockwise side
    bool solid_right = false;  ///< a body edge here has B on the clockwise side

    /// Whether a piece of the boundary of some body (or of the world) leaves along the arm.
    [[nodiscard]] bool is_body() const noexcept { return solid_left || solid_right; }
};

/// The scene in a small enough disc round one place: arms in counter-clockwise order, and the
/// sectors between them. Sector i lies between arm i and arm i + 1 (cyclically); without arms there
/// is one sector. Where no body edge passes, all sectors are taken to be free: whether the place
/// lies in the open inside of B is for the caller to know.
class Picture {
public:
    /// `touching` holds at least the edges that contain x.
    Picture(const Scene2& scene, std::span<const EdgeId> touching, const Place& x);

    /// On arm `index`, or in sector `index`.
    struct Spot {
        bool on_arm = false;
        std::size_t index = 0;
    };
    [[nodiscard]] Spot locate(const Heading& heading) const;

    [[nodiscard]] const Place& place() const noexcept { return place_; }
    [[nodiscard]] const std::vector<Arm>& arms() const noexcept { return arms_; }
    [[nodiscard]] std::size_t sector_count() const noexcept { return solid_.size(); }
    [[nodiscard]] bool is_solid(std::size_t sector) const { return solid_[sector]; }
    [[nodiscard]] std::size_t sector_before(std::size_t arm) const {
        return (arm + arms_.size() - 1) % arms_.size();
    }
    [[nodiscard]] bool has_wall() const;
    [[nodiscard]] bool has_body() const;

    /// Whether a short step along the heading lies in the interior of the closed union B.
    [[nodiscard]] bool is_interior(const Heading& heading) const;
    /// Whether a short step along the heading lies on a wall.
    [[nodiscard]] bool is_on_wall(const Heading& heading) const;
    /// Whether a short step along the heading lies on the boundary edge of a body or of the world.
    [[nodiscard]] bool is_on_body(const Heading& heading) const;
    /// The free sector that a short step along the heading, which is not interior to B and not on a
    /// wall, lies in or borders.
    [[nodiscard]] std::size_t free_sector(const Heading& heading) const;

    /// Whether a path may come in one free sector and leave in another: it does not cross a wall, or it
    /// goes from one of the parts that B alone makes to another.
    [[nodiscard]] bool may_pass(std::size_t sector, std::size_t other) const;

private:
    void add_arm(const Arm& arm);
    void find_solid_sectors();

    Place place_;
    std::vector<Arm> arms_;
    std::vector<bool> solid_;
};

/// Whether x lies on the closed edge.
[[nodiscard]] bool is_on(const Scene2& scene, EdgeId edge, const Place& x);

/// What there is at any place. O(n).
[[nodiscard]] Picture picture_at(const Scene2& scene, const Place& x);

/// The error for a viewpoint or an end of a path that is in the interior of B.
[[nodiscard]] Error inside_error(const Scene2& scene, const Place& x);

/// How often the rings of `body` (of the world, for none) wind round x, which lies on none of them.
/// O(n).
[[nodiscard]] int winding_number(const Scene2& scene, BodyId body, const Place& x);

/// Whether x is in the interior of the closed union B. O(n).
[[nodiscard]] bool is_interior(const Scene2& scene, const Place& x);

}  // namespace sightline::reference
