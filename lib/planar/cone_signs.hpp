// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "planar/triangulation.hpp"
#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/tally.hpp"

namespace sightline::detail {

/// From where cones of sight start: a place of the triangulation, or any point in its frame.
struct Viewpoint {
    Point2 position;         ///< rounded when `exact` is given or the place constructed
    Place place = no_index;  ///< when it is a place of the triangulation
    const RationalPoint2* exact =
        nullptr;  ///< when it is no place and its coordinates are no doubles
};

/// One boundary ray of a cone of sight: the direction in doubles for the filter, and its generator for
/// exactness.
struct Limit {
    /// How `place` generates the ray; axis directions have no place.
    enum class Kind : std::uint8_t { towards, away_from, up, down, left, right };

    double x = 0;
    double y = 0;
    Place place = no_index;  ///< the last vertex met on the ray, or the generator
    Kind kind = Kind::towards;
    bool touches = false;  ///< the near edge's end on this side lies on the ray
    bool armed =
        false;  ///< the ray may go on where the cone ends: it has to be followed on its own
    bool silent = false;  ///< what lies on the ray is not reported
};

/// Signs of orientation(viewpoint, limit, place) under one arithmetic, counted by deciding tier.
class ConeSigns {
public:
    ConeSigns(const Triangulation& t, Arithmetic arithmetic);

    /// A determinant beyond ± this needs no second look, for any places seen from there.
    [[nodiscard]] double bound(const Viewpoint& from) const;
    /// Positive when p lies left of the ray. Called when the first filter has not decided.
    [[nodiscard]] Sign side(const Viewpoint& from, const Limit& limit, Place p);
    /// The same, first filter included.
    [[nodiscard]] Sign certain_side(const Viewpoint& from, const Limit& limit, Place p) {
        const Point2& q = t_.position(p);
        const double det = limit.x * (q.y - from.position.y) - limit.y * (q.x - from.position.x);
        ++calls_;
        const double bound = this->bound(from);
        if (det > bound) return Sign::positive;
        if (det < -bound) return Sign::negative;
        return side(from, limit, p);
    }
    [[nodiscard]] RationalPoint2 exact_position(const Viewpoint& from) const;
    /// Counts determinants that were evaluated, decided by the first filter or not.
    void count(std::uint64_t calls) noexcept { calls_ += calls; }
    void add_to(Tally& tally) const noexcept;

private:
    [[nodiscard]] CertifiedSign decide(const Viewpoint& from, const Limit& limit, Place p) const;
    [[nodiscard]] CertifiedSign by_tier(const Viewpoint& from, const Point2& b,
                                        const Point2& c) const;

    const Triangulation& t_;
    Arithmetic arithmetic_;
    std::uint64_t calls_ = 0;
    Tally late_;  ///< of the calls that the first filter has not decided
};

}  // namespace sightline::detail
