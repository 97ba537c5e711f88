// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string_view>
#include <vector>

#include "sightline/geom/plucker.hpp"

/// One-parameter families of lines, the loci of visual events (docs/structures/visual-events.md):
/// pencils (lines of a plane through a point) and reguli (lines that meet three skew lines). Lines are
/// unbounded and undirected here, and nothing is said about what blocks them.

namespace sightline {

/// dᵀ Q d: zero on a cone of directions.
struct QuadraticForm3 {
    Rational xx, yy, zz, yz, zx, xy;  ///< the mixed ones are coefficients of y z, z x, x y

    [[nodiscard]] Rational operator()(const Vector3& d) const {
        return d.x * (xx * d.x + xy * d.y) + d.y * (yy * d.y + yz * d.z) +
               d.z * (zz * d.z + zx * d.x);
    }
    [[nodiscard]] bool is_zero() const;

    friend bool operator==(const QuadraticForm3&, const QuadraticForm3&) = default;
    friend std::ostream& operator<<(std::ostream& out, const QuadraticForm3& form);
};

/// x ↦ xᵀ Q x + linear·x + constant: zero on a quadric, or on a plane when Q is zero.
struct Quadric3 {
    QuadraticForm3 quadratic;
    Vector3 linear;
    Rational constant;

    [[nodiscard]] Rational operator()(const RationalPoint3& x) const {
        const Vector3 v = vector_to(x);
        return quadratic(v) + dot(linear, v) + constant;
    }
    /// Whether it is zero everywhere.
    [[nodiscard]] bool is_zero() const;

    friend bool operator==(const Quadric3&, const Quadric3&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Quadric3& quadric);
};

/// The surface that three lines span, det[m₁ − x × u₁, m₂ − x × u₂, m₃ − x × u₃].
///
/// Laws
///  (1) its value at x is side(L, third), where L is the line through x that meets the first and the
///      second, directed along the product of the normals of plane_through(x, first) and
///      plane_through(x, second)
///  (2) exchanging two lines changes its sign, rotating all three nothing
///  (3) two of the lines in one plane: the product of that plane and of the plane through their
///      common point and the third line; all three in one plane or through one point: zero everywhere
[[nodiscard]] Quadric3 surface_of(const RationalLine3& first, const RationalLine3& second,
                                  const RationalLine3& third);

/// dᵀ Q d for the directions of lines that meet three lines,
/// (d·m₁) d·(u₂×u₃) + (d·m₂) d·(u₃×u₁) + (d·m₃) d·(u₁×u₂). It is the quadratic part of surface_of.
///
/// Law: its value at d is side(L, third), where L is the line of direction d that meets the first and
/// the second, directed along d times d·(u₁×u₂).
[[nodiscard]] QuadraticForm3 directions_of(const RationalLine3& first, const RationalLine3& second,
                                           const RationalLine3& third);

/// The real zeros of c[0] + c[1] t + c[2] t², ascending, a double one once. Contract: not all
/// coefficients are zero.
[[nodiscard]] std::vector<Surd> zeros_of(const std::array<Rational, 3>& c);

/// Lines whose Plücker vectors are polynomials in t of degree at most 2: coefficients of 1, t, t².
struct LineCurve3 {
    std::array<RationalLine3, 3> coefficients;

    /// Not a line (d = 0) for the parameter of a line at infinity.
    [[nodiscard]] RationalLine3 at(const Rational& t) const;
    [[nodiscard]] SurdLine3 at(const Surd& t) const;
    /// The line for t = ∞: the leading coefficient that is not zero.
    [[nodiscard]] const RationalLine3& at_infinity() const;
    [[nodiscard]] int degree() const;
    /// side(at(t), l) as a polynomial in t: zero where the line meets l, or is parallel to it.
    [[nodiscard]] std::array<Rational, 3> side(const RationalLine3& l) const;
    /// normal·d(t) as a polynomial in t: zero where the line is parallel to the plane.
    [[nodiscard]] std::array<Rational, 3> rise(const Vector3& normal) const;
};

/// A point, or where parallels meet.
using ProjectivePoint3 = HomogeneousPoint3<Rational>;

/// Whether l passes through p; parallels pass through their point at infinity.
[[nodiscard]] bool is_on(const RationalLine3& l, const ProjectivePoint3& p);
[[nodiscard]] bool is_on(const SurdLine3& l, const ProjectivePoint3& p);

enum class SwathKind : std::uint8_t {
    pencil,  ///< the lines through a point in a plane: EV, FE, Fv, and EEE with two coplanar edges
    parallel,  ///< the lines of one direction in a plane: a pencil whose point is at infinity
    regulus,   ///< the lines that meet three skew lines: EEE in general
};

[[nodiscard]] std::string_view name_of(SwathKind kind) noexcept;
std::ostream& operator<<(std::ostream& out, SwathKind kind);

/// A one-parameter family of lines: a pencil or a regulus.
///
/// A value; equal exactly when it is the same set of lines, however it was generated: the vectors of
/// its lines span a space of dimension 2 or 3, kept in reduced echelon form.
class Swath {
public:
    /// The lines through p that meet l (EV): those of the plane of p and l. Contract: p is not on l.
    [[nodiscard]] static Swath pencil(const ProjectivePoint3& p, const RationalLine3& l);
    /// The lines of the plane through p. Contract: p lies in the plane.
    [[nodiscard]] static Swath pencil(const ProjectivePoint3& p, const Plane3& plane);
    /// The lines that meet three lines (EEE). Contract: no two of the three have side zero.
    [[nodiscard]] static Swath regulus(const RationalLine3& a, const RationalLine3& b,
                                       const RationalLine3& c);

    [[nodiscard]] SwathKind kind() const noexcept { return kind_; }
    [[nodiscard]] bool is_regulus() const noexcept { return kind_ == SwathKind::regulus; }

    /// The point of a pencil, scaled. Contract: not a regulus.
    [[nodiscard]] const ProjectivePoint3& centre() const;
    /// The plane of a pencil. Contract: not a regulus.
    [[nodiscard]] const Plane3& plane() const;
    /// Three lines of the opposite ruling: those that made the regulus. Contract: a regulus.
    [[nodiscard]] const std::array<RationalLine3, 3>& generators() const;

    [[nodiscard]] bool contains(const RationalLine3& l) const;
    [[nodiscard]] bool contains(const SurdLine3& l) const;
    /// Whether every line of the family meets l, or is parallel to it.
    [[nodiscard]] bool all_meet(const RationalLine3& l) const;
    /// Whether every line of the family passes through p.
    [[nodiscard]] bool all_pass(const RationalPoint3& p) const;
    /// Whether every line of the family lies in the plane.
    [[nodiscard]] bool all_in(const Plane3& p) const;

    /// The line through p + t (q − p), for each t. Contract: p ≠ q, and the line pq meets every line
    /// of the family and is none of them; in a pencil it does not pass through the centre.
    ///
    /// Laws
    ///  (1) at(t) passes through p + t (q − p), is in the family, and is a line unless parallel ones
    ///      of the generators make it one at infinity
    ///  (2) of degree 1 for pencils, 2 for reguli
    [[nodiscard]] LineCurve3 along(const RationalPoint3& p, const RationalPoint3& q) const;

    /// The points of its lines: a quadric, or a plane (no quadratic part). Viewpoints where the value
    /// has one sign see the event from one side (docs/structures/visual-events.md).
    [[nodiscard]] Quadric3 surface() const;
    /// The quadratic part of a regulus' surface: zero for the directions of its lines. Contract: a regulus. A
    /// pencil's directions d are those with plane().normal·d == 0.
    [[nodiscard]] QuadraticForm3 directions() const;

    /// The lines of the family that meet l or are parallel to it, ascending in the order of scaled
    /// vectors; empty optional when all do.
    [[nodiscard]] std::optional<std::vector<SurdLine3>> lines_meeting(const RationalLine3& l) const;
    /// The line of the family through p, scaled, if there is one; contract: not all pass through p.
    [[nodiscard]] std::optional<RationalLine3> line_through(const RationalPoint3& p) const;

    friend bool operator==(const Swath& a, const Swath& b) { return a.span_ == b.span_; }
    friend std::ostream& operator<<(std::ostream& out, const Swath& swath);

private:
    using Row = std::array<Rational, 6>;
    Swath() = default;
    void set_span(std::vector<Row> rows);
    /// Any curve over the whole family, with lines at all but finitely many t.
    [[nodiscard]] LineCurve3 curve() const;

    SwathKind kind_{};
    std::vector<Row> span_;  // reduced echelon form
    ProjectivePoint3 centre_{};
    Plane3 plane_{};
    std::array<RationalLine3, 3> generators_{};
};

/// What meets given points and lines, as a whole: the isolated lines and the families of one
/// parameter. Lines that are parallel to a given line count as meeting it.
struct LineFamilies {
    std::vector<SurdLine3> isolated;  ///< scaled, ascending, and in no family
    std::vector<Swath> swaths;
    /// Whether there is a family of two or more parameters; the swaths then are those besides it.
    bool has_larger = false;
};

/// All lines through the given points that meet the given lines. Equal points and equal lines count
/// once.
///
/// By points: none and three lines: a regulus when they are pairwise skew; two pencils when two of them
/// lie in a plane (the one round their common point, which may be at infinity, in the plane of that
/// point and the third; and the one in their plane round the third's point in it); something larger when
/// all three lie in a plane or pass through a point. One point: pencils, where all lines not through it
/// lie in one plane with it. Two points: their line. Each further line leaves isolated lines of a family:
/// at most two.
///
/// Cost: a few dozen products of rationals a line and family.
[[nodiscard]] LineFamilies families_meeting(const std::vector<RationalPoint3>& points,
                                            const std::vector<RationalLine3>& lines);

}  // namespace sightline
