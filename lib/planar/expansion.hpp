// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "planar/cone_signs.hpp"
#include "planar/crossings.hpp"

namespace sightline::detail {

/// A cone of sight about to enter a triangle.
struct Cone {
    std::uint32_t crossing = no_index;
    Limit left;
    Limit right;
};

/// Triangular expansion (Bungiu et al. 2014): follows the cones of sight of one viewpoint through the
/// free triangles, each cone narrower than 180°, from right to left. The visitor is told
///   vertex(crossing)           the apex lies strictly inside a cone: visible, and nothing before it
///   on_limit(crossing, limit)  the apex lies on the cone's boundary ray, which is free up to there
///   follow(limit)              the ray may go on, at width zero, beyond limit.place
///   blocked(half-edge, cone)   what ends a cone, in angular order (only when Visitor::wants_blocked)
///
/// Why rays of width zero are not lost: a place where B has one sector is passed on the side that is
/// free, and there the cone goes on and touches the ray. So a ray outlives its cones only at a pinch
/// (several sectors of B) or at the second and later vertices on it: those limits are `armed`.
template <typename Visitor>
class Expansion {
public:
    Expansion(const Crossings& crossings, ConeSigns& signs, Visitor& visitor)
        : crossings_(crossings), signs_(signs), visitor_(visitor) {
        stack_.reserve(64);
    }

    /// Changes the viewpoint.
    void look_from(const Viewpoint& from) {
        from_ = from;
        bound_ = signs_.bound(from);
    }
    /// Reports everything inside the cone.
    void expand(const Cone& start);

private:
    static constexpr std::uint32_t blocked_bit = 0x80000000U;

    void enter(Cone& cone);
    void enter_carefully(const Crossing& c, double dx, double dy, Cone& cone);
    void split(const Crossing& c, double dx, double dy, Cone& cone);
    void leave(const Crossing& c, bool right, Cone& cone);
    /// The edge on the cone's left or right through which it would leave the triangle that it entered.
    [[nodiscard]] static HalfEdge exit_edge(const Cone& cone, bool right) {
        if constexpr (!Visitor::wants_blocked) return no_index;
        const HalfEdge h = Crossings::half_edge(cone.crossing);
        return right ? next(h) : prev(h);
    }
    void stop(HalfEdge exit, Cone& cone) {
        if (cone.left.touches && cone.left.armed) visitor_.follow(cone.left);
        if (cone.right.touches && cone.right.armed) visitor_.follow(cone.right);
        if constexpr (Visitor::wants_blocked) visitor_.blocked(exit, cone);
        cone.crossing = no_index;
    }

    const Crossings& crossings_;
    ConeSigns& signs_;
    Visitor& visitor_;
    double bound_ = 0;
    std::uint64_t unasked_ = 0;  ///< signs that careful steps had no need of
    Viewpoint from_;
    std::vector<Cone> stack_;
};

template <typename Visitor>
void Expansion<Visitor>::expand(const Cone& start) {
    std::uint64_t steps = 0;
    Cone cone = start;
    while (true) {
        while (cone.crossing != no_index) {
            ++steps;
            enter(cone);
        }
        if (stack_.empty()) break;
        cone = stack_.back();
        stack_.pop_back();
        if constexpr (Visitor::wants_blocked) {
            if ((cone.crossing & blocked_bit) != 0) stop(cone.crossing & ~blocked_bit, cone);
        }
    }
    signs_.count(2 * steps - unasked_);
    unasked_ = 0;
}

template <typename Visitor>
inline void Expansion<Visitor>::enter(Cone& cone) {
    const Crossing& c = crossings_[cone.crossing];
    // One of the exits is next; which one is known only after the determinants.
    if (c.exits[0] != no_index) __builtin_prefetch(&crossings_[c.exits[0]]);
    if (c.exits[1] != no_index) __builtin_prefetch(&crossings_[c.exits[1]]);
    const double dx = c.x - from_.position.x;
    const double dy = c.y - from_.position.y;
    const double left = cone.left.x * dy - cone.left.y * dx;
    const double right = cone.right.x * dy - cone.right.y * dx;
    // Branches, not selections: a predicted exit lets the next triangle load early, which is worth more
    // than the mispredictions (measured: selections cost 20 to 50 % more).
    if (left < -bound_ && right > bound_) {
        split(c, dx, dy, cone);
    } else if (left > bound_) {
        cone.left.touches = false;
        leave(c, true, cone);
    } else if (right < -bound_) {
        cone.right.touches = false;
        leave(c, false, cone);
    } else {
        enter_carefully(c, dx, dy, cone);
    }
}

// Zero is an answer here: the apex lies on a boundary ray.
template <typename Visitor>
[[gnu::noinline]] void Expansion<Visitor>::enter_carefully(const Crossing& c, double dx, double dy,
                                                           Cone& cone) {
    const Sign left = signs_.side(from_, cone.left, c.apex);
    if (left != Sign::negative) {
        ++unasked_;
        cone.left.touches = left == Sign::zero;
        if (left == Sign::zero) visitor_.on_limit(c, cone.left);
        leave(c, true, cone);
        return;
    }
    const Sign right = signs_.side(from_, cone.right, c.apex);
    if (right != Sign::positive) {
        cone.right.touches = right == Sign::zero;
        if (right == Sign::zero) visitor_.on_limit(c, cone.right);
        leave(c, false, cone);
        return;
    }
    split(c, dx, dy, cone);
}

template <typename Visitor>
inline void Expansion<Visitor>::split(const Crossing& c, double dx, double dy, Cone& cone) {
    visitor_.vertex(c);
    const Limit middle{dx, dy, c.apex, Limit::Kind::towards, true, false, false};
    if (c.exits[0] != no_index) {
        stack_.push_back({c.exits[0], cone.left, middle});
    } else if constexpr (Visitor::wants_blocked) {
        stack_.push_back({blocked_bit | exit_edge(cone, false), cone.left, middle});
    } else if (cone.left.touches && cone.left.armed) {
        visitor_.follow(cone.left);
    }
    cone.left = middle;
    leave(c, true, cone);
}

template <typename Visitor>
inline void Expansion<Visitor>::leave(const Crossing& c, bool right, Cone& cone) {
    if (c.exits[right] != no_index)
        cone.crossing = c.exits[right];
    else
        stop(exit_edge(cone, right), cone);
}

}  // namespace sightline::detail
