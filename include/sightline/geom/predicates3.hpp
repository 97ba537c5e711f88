// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>

#include "sightline/arith/arithmetic.hpp"
#include "sightline/arith/sign.hpp"
#include "sightline/arith/tally.hpp"
#include "sightline/geom/point.hpp"

/// The predicates of space. Exact for all finite inputs, denormals and 1e±300 included.
/// The free functions are filtered; Predicates3 offers the same ones under any Arithmetic.

namespace sightline {

/// On which side of the plane abc the point d lies.
///
/// positive: on the side from which a, b, c are counter-clockwise; zero: in the plane, or abc is no
/// triangle.
///
/// Laws
///  (1) exchanging two of the four points flips the sign
///  (2) adding one vector to all points changes nothing, when the sums are exact
///  (3) multiplying all coordinates by a power of two changes nothing, when the products are exact
///  (4) exchanging x and y in all points flips the sign
///  (5) zero when two of the points are equal
///
/// Cost: 9 products when the filter decides; else intervals, else exact products.
[[nodiscard]] Sign orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
[[nodiscard]] Sign orientation(const RationalPoint3& a, const RationalPoint3& b,
                               const RationalPoint3& c, const RationalPoint3& d);

/// How the line r→s passes the line p→q: the sign of side() of their Plücker vectors.
///
/// positive: it turns counter-clockwise round p→q, seen from q. zero: the lines meet or are
/// parallel, or one of them is a single point.
///
/// Laws
///  (1) side_of_line(r, s, p, q) ==  side_of_line(p, q, r, s)
///  (2) side_of_line(q, p, r, s) == -side_of_line(p, q, r, s)
///  (3) side_of_line(p, q, r, s) ==  orientation(p, q, r, s)
///  (4) moving a point along its line does not change the sign, unless it passes the other
[[nodiscard]] Sign side_of_line(const Point3& p, const Point3& q, const Point3& r, const Point3& s);
[[nodiscard]] Sign side_of_line(const RationalPoint3& p, const RationalPoint3& q,
                                const RationalPoint3& r, const RationalPoint3& s);

/// How a line passes a closed triangle.
struct LineTriangle {
    enum class Kind : std::uint8_t {
        misses,          ///< no common point
        crosses_inside,  ///< meets the inside in one point
        through_edge,    ///< meets one edge inside of it
        through_vertex,  ///< meets the triangle in a corner
        in_plane,        ///< lies in the plane of the triangle
    };
    Kind kind = Kind::misses;
    /// Of through_edge: the edge opposite to corner 0, 1, 2. Of through_vertex: the corner.
    std::uint8_t index = 0;
    /// positive: the line leaves on the side from which the corners are counter-clockwise; zero: it
    /// misses or lies in the plane.
    Sign direction = Sign::zero;

    friend bool operator==(const LineTriangle&, const LineTriangle&) = default;
    friend std::ostream& operator<<(std::ostream& out, const LineTriangle& relation);
};

[[nodiscard]] const char* name_of(LineTriangle::Kind kind) noexcept;

/// How the line p→q passes the triangle abc. Contract: p ≠ q; a, b, c are not collinear.
///
/// Laws
///  (1) line_triangle(q, p, a, b, c) differs in the direction only
///  (2) rotating a, b, c rotates the index and changes nothing else
///  (3) exchanging a and b flips the direction and exchanges the indices 0 and 1
///  (4) in_plane exactly when both p and q have orientation zero
[[nodiscard]] LineTriangle line_triangle(const Point3& p, const Point3& q, const Point3& a,
                                         const Point3& b, const Point3& c);
[[nodiscard]] LineTriangle line_triangle(const RationalPoint3& p, const RationalPoint3& q,
                                         const RationalPoint3& a, const RationalPoint3& b,
                                         const RationalPoint3& c);

/// How a directed line passes an oriented plane.
enum class LinePlane : std::uint8_t {
    forward,   ///< crosses it, to the side from which a, b, c are counter-clockwise
    backward,  ///< crosses it to the other side
    parallel,  ///< no common point
    inside,    ///< lies in it
};

[[nodiscard]] const char* name_of(LinePlane relation) noexcept;
std::ostream& operator<<(std::ostream& out, LinePlane relation);

/// How the line p→q passes the plane abc. Contract: p ≠ q; a, b, c are not collinear.
///
/// Laws
///  (1) exchanging p and q exchanges forward and backward and changes nothing else
///  (2) exchanging a and b does the same
///  (3) inside exactly when both p and q have orientation zero
[[nodiscard]] LinePlane line_plane(const Point3& p, const Point3& q, const Point3& a,
                                   const Point3& b, const Point3& c);
[[nodiscard]] LinePlane line_plane(const RationalPoint3& p, const RationalPoint3& q,
                                   const RationalPoint3& a, const RationalPoint3& b,
                                   const RationalPoint3& c);

/// The predicates under an arithmetic chosen at run time, each sign counted under the tier that
/// decided it (a plain double counts as `filter`).
///
/// Under `filtered` and `exact` every answer is that of the free function. Under `interval` an
/// undecided sign is taken as zero and counted; under `double_` it is the sign of whatever comes
/// out; both may be wrong, and contradict the laws. A value; the tally, if any, must outlive it.
class Predicates3 {
public:
    explicit Predicates3(Arithmetic arithmetic = Arithmetic::filtered, Tally* tally = nullptr)
        : arithmetic_(arithmetic), tally_(tally) {}

    [[nodiscard]] Arithmetic arithmetic() const noexcept { return arithmetic_; }
    [[nodiscard]] Tally* tally() const noexcept { return tally_; }

    [[nodiscard]] Sign orientation(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) const;
    [[nodiscard]] Sign side_of_line(const Point3& p, const Point3& q, const Point3& r,
                                    const Point3& s) const;
    [[nodiscard]] LineTriangle line_triangle(const Point3& p, const Point3& q, const Point3& a,
                                             const Point3& b, const Point3& c) const;
    [[nodiscard]] LinePlane line_plane(const Point3& p, const Point3& q, const Point3& a,
                                       const Point3& b, const Point3& c) const;

private:
    Arithmetic arithmetic_;
    Tally* tally_;
};

}  // namespace sightline
