// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/sign.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/line2.hpp"
#include "sightline/geom/point.hpp"
#include "sightline/geom/polygon2.hpp"

/// The predicates of the plane. Exact for all finite inputs, denormals and 1e±300 included.
/// The free functions are filtered; Predicates2 offers the same ones under any Arithmetic.
///
/// Where points are constructed (RationalPoint2, ImplicitPoint2) the laws are the same.

namespace sightline {

/// On which side of the directed line a→b the point c lies.
///
/// positive: left of it; negative: right of it; zero: on it, or a == b.
///
/// Laws
///  (1) orientation(b, c, a) ==  orientation(a, b, c)
///  (2) orientation(b, a, c) == -orientation(a, b, c)
///  (3) adding one vector to a, b and c changes nothing, when the sums are exact
///  (4) multiplying all coordinates by a power of two changes nothing, when the products are exact
///  (5) exchanging x and y in all three points flips the sign
///  (6) zero when two of the points are equal
///
/// Cost: 2 products when the filter decides; else intervals, else exact products, some 30 times as
/// much (numbers in docs/exactness.md). \cite shewchuk_1997
[[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] Sign orientation(const RationalPoint2& a, const RationalPoint2& b,
                               const RationalPoint2& c);
[[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const RationalPoint2& c);
[[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const ImplicitPoint2& c);
[[nodiscard]] Sign orientation(const Point2& a, const ImplicitPoint2& b, const ImplicitPoint2& c);
[[nodiscard]] Sign orientation(const ImplicitPoint2& a, const ImplicitPoint2& b,
                               const ImplicitPoint2& c);

/// The order of p and q in the direction from a to b; they need not lie on that line.
///
/// negative: p comes first; positive: q comes first; zero: level, or a == b.
///
/// Laws
///  (1) order_along(a, b, q, p) == -order_along(a, b, p, q)
///  (2) order_along(b, a, p, q) == -order_along(a, b, p, q)
///  (3) order_along(p, q, a, b) ==  order_along(a, b, p, q)
///  (4) order_along(a, b, a, b) is negative, unless a == b
///  (5) adding one vector to a and b, or to p and q, changes nothing, when the sums are exact
[[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const Point2& p, const Point2& q);
[[nodiscard]] Sign order_along(const RationalPoint2& a, const RationalPoint2& b,
                               const RationalPoint2& p, const RationalPoint2& q);
[[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const Point2& p,
                               const ImplicitPoint2& q);
[[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const ImplicitPoint2& p,
                               const ImplicitPoint2& q);

/// The order in which a ray from `center`, turning counter-clockwise for one turn from the
/// direction of `reference`, meets p and q.
///
/// negative: p first; positive: q first; zero: the same direction. Contract: reference, p and q
/// differ from center.
///
/// Laws
///  (1) order_of_directions(c, r, q, p) == -order_of_directions(c, r, p, q)
///  (2) order_of_directions(c, r, p, q) is zero exactly when the directions of p and q are equal
///  (3) nothing comes before r: order_of_directions(c, r, r, p) is not positive
///  (4) with (1) and (2), it is a total preorder: transitive
///  (5) order_of_directions(c, p, q, r) is negative for p, q, r that turn left in this order and in
///      all rotations of it
[[nodiscard]] Sign order_of_directions(const Point2& center, const Point2& reference,
                                       const Point2& p, const Point2& q);
[[nodiscard]] Sign order_of_directions(const RationalPoint2& center, const Point2& reference,
                                       const Point2& p, const Point2& q);

/// Where a point lies with regard to a cone.
enum class ConePosition : std::uint8_t { outside, on_first, inside, on_second, at_apex };

[[nodiscard]] const char* name_of(ConePosition position) noexcept;
std::ostream& operator<<(std::ostream& out, ConePosition position);

/// Where p lies with regard to the cone that a ray from `apex` sweeps, turning counter-clockwise
/// from the direction of `first` to that of `second`. The cone may be reflex.
///
/// Degeneracy: when first and second have the same direction the cone is a full turn, cut along
/// that ray (the angle at the end of a wall). Contract: first and second differ from apex.
///
/// Laws
///  (1) exchanging first and second exchanges inside with outside and on_first with on_second,
///      unless their directions are equal
///  (2) first is on_first, the apex at_apex, and second on_second unless the cone is a full turn
///  (3) for a cone of less than half a turn, inside is left of first and right of second
[[nodiscard]] ConePosition cone_position(const Point2& apex, const Point2& first,
                                         const Point2& second, const Point2& p);
[[nodiscard]] ConePosition cone_position(const RationalPoint2& apex, const Point2& first,
                                         const Point2& second, const Point2& p);

/// Whether p lies strictly inside the cone of cone_position().
[[nodiscard]] bool is_in_cone(const Point2& apex, const Point2& first, const Point2& second,
                              const Point2& p);

/// How two closed segments meet.
enum class SegmentCrossing : std::uint8_t {
    none,                      ///< they have no point in common
    end_to_end,                ///< one common point, an end of both
    first_ends_inside_second,  ///< one common point, an end of the first, inside the second
    second_ends_inside_first,  ///< one common point, an end of the second, inside the first
    proper,                    ///< one common point, inside both
    overlap,                   ///< a common segment of positive length
};

[[nodiscard]] const char* name_of(SegmentCrossing crossing) noexcept;
std::ostream& operator<<(std::ostream& out, SegmentCrossing crossing);

/// How the closed segments s and t meet. A segment may be a single point: that is both its ends.
///
/// Laws
///  (1) exchanging s and t exchanges first_ends_… and second_ends_… and changes nothing else
///  (2) reversing s or t changes nothing
///  (3) a segment with itself: overlap, or end_to_end when it is a point
[[nodiscard]] SegmentCrossing crossing(const Segment2& s, const Segment2& t);

/// Whether p lies on the closed segment s.
[[nodiscard]] bool is_on(const Segment2& s, const Point2& p);

/// Lexicographic order of two places, x first: negative when p is less.
[[nodiscard]] Sign compare_xy(const ImplicitPoint2& p, const ImplicitPoint2& q);
[[nodiscard]] Sign compare_xy(const ImplicitPoint2& p, const Point2& q);

/// The predicates under an arithmetic chosen at run time, each sign counted under the tier that
/// decided it (a plain double counts as `filter`).
///
/// Under `filtered` and `exact` every answer is that of the free function. Under `interval` an
/// undecided sign is taken as zero and counted; under `double_` it is the sign of whatever comes
/// out; both may be wrong, and contradict the laws. A value; the tally, if any, must outlive it.
class Predicates2 {
public:
    explicit Predicates2(Arithmetic arithmetic = Arithmetic::filtered, Tally* tally = nullptr)
        : arithmetic_(arithmetic), tally_(tally) {}

    [[nodiscard]] Arithmetic arithmetic() const noexcept { return arithmetic_; }
    [[nodiscard]] Tally* tally() const noexcept { return tally_; }

    [[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const Point2& c) const;
    [[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const RationalPoint2& c) const;
    [[nodiscard]] Sign orientation(const Point2& a, const Point2& b, const ImplicitPoint2& c) const;
    [[nodiscard]] Sign orientation(const Point2& a, const ImplicitPoint2& b,
                                   const ImplicitPoint2& c) const;
    [[nodiscard]] Sign orientation(const ImplicitPoint2& a, const ImplicitPoint2& b,
                                   const ImplicitPoint2& c) const;
    [[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const Point2& p,
                                   const Point2& q) const;
    [[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const Point2& p,
                                   const ImplicitPoint2& q) const;
    [[nodiscard]] Sign order_along(const Point2& a, const Point2& b, const ImplicitPoint2& p,
                                   const ImplicitPoint2& q) const;
    [[nodiscard]] Sign order_of_directions(const Point2& center, const Point2& reference,
                                           const Point2& p, const Point2& q) const;
    [[nodiscard]] Sign order_of_directions(const RationalPoint2& center, const Point2& reference,
                                           const Point2& p, const Point2& q) const;
    [[nodiscard]] ConePosition cone_position(const Point2& apex, const Point2& first,
                                             const Point2& second, const Point2& p) const;
    [[nodiscard]] ConePosition cone_position(const RationalPoint2& apex, const Point2& first,
                                             const Point2& second, const Point2& p) const;
    [[nodiscard]] SegmentCrossing crossing(const Segment2& s, const Segment2& t) const;
    [[nodiscard]] bool is_on(const Segment2& s, const Point2& p) const;
    [[nodiscard]] Sign compare_xy(const ImplicitPoint2& p, const ImplicitPoint2& q) const;
    [[nodiscard]] Sign compare_xy(const ImplicitPoint2& p, const Point2& q) const;

private:
    Arithmetic arithmetic_;
    Tally* tally_;
};

}  // namespace sightline
