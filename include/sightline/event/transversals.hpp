// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <vector>

#include "sightline/geom/plucker.hpp"

/// All lines that meet four given things: isolated lines, and every family of lines as such.
///
/// Rules for degenerate cases (docs/structures/transversals.md)
///  (1) To meet is to share a point of space. A line parallel to an element does not meet it, unless
///      it is the element's own line. Segments are closed.
///  (2) A segment of length zero is a point. Collinear segments that overlap count as their common
///      piece, or point; those that don't are met together by one line only, their own.
///  (3) A line is listed as a line when it is isolated: no other line near it meets all elements.
///      Every other line belongs to a component.
///  (4) A component is what the elements leave of one pencil, regulus, plane, bundle or congruence.
///      Pieces of a pencil that lie in the closure of a plane's or bundle's component are not
///      listed again.
///  (5) When finitely many lines meet the four carriers (there are at most two), `root` numbers
///      those by the order of their scaled Plücker vectors, also when one of the two misses an
///      element; a double line has root 0. Otherwise the listed lines are numbered from 0.

namespace sightline {

/// A closed segment with rational ends; may be a single point.
struct RationalSegment3 {
    RationalPoint3 source;
    RationalPoint3 target;

    friend bool operator==(const RationalSegment3&, const RationalSegment3&) = default;
};

/// Something that a line may have to meet: a whole line, a closed segment, or a point.
class TransversalElement {
public:
    enum class Kind : std::uint8_t { line, segment, point };

    /// The line through two points. Contract: they differ.
    [[nodiscard]] static TransversalElement line(const RationalPoint3& a, const RationalPoint3& b);
    /// The closed segment; a point when its ends are equal.
    [[nodiscard]] static TransversalElement segment(const RationalPoint3& a,
                                                    const RationalPoint3& b);
    [[nodiscard]] static TransversalElement segment(const RationalSegment3& s) {
        return segment(s.source, s.target);
    }
    [[nodiscard]] static TransversalElement point(const RationalPoint3& p);

    [[nodiscard]] Kind kind() const noexcept { return kind_; }
    [[nodiscard]] const RationalPoint3& source() const noexcept { return a_; }
    [[nodiscard]] const RationalPoint3& target() const noexcept { return b_; }
    /// The line through it; not a line for points.
    [[nodiscard]] RationalLine3 carrier() const { return line_through(a_, b_); }

    friend bool operator==(const TransversalElement&, const TransversalElement&) = default;

private:
    TransversalElement(Kind kind, RationalPoint3 a, RationalPoint3 b)
        : kind_(kind), a_(std::move(a)), b_(std::move(b)) {}
    Kind kind_;
    RationalPoint3 a_;
    RationalPoint3 b_;
};

/// Whether a line shares a point with an element: rule (1), for lines of any field.
[[nodiscard]] bool meets(const SurdLine3& line, const TransversalElement& element);
[[nodiscard]] bool meets(const RationalLine3& line, const TransversalElement& element);

/// An isolated line that meets all elements.
struct TransversalLine {
    SurdLine3 line;         ///< scaled
    std::uint8_t root = 0;  ///< rule (5)

    friend bool operator==(const TransversalLine&, const TransversalLine&) = default;
};

/// A connected piece of a one-parameter family: the lines met when one moves from `from` through
/// `through` to `to`. from <= to; an end is missing when it is not included (only a line that is
/// parallel to an element is left out so; on a paraboloid it may be the one at infinity, d = 0). In
/// a pencil `through` is the sum or difference of the ends' scaled directions; at right angles to
/// both when they are one.
struct TransversalRange {
    RationalLine3 from;
    RationalLine3 through;
    RationalLine3 to;
    bool has_from = true;
    bool has_to = true;

    friend bool operator==(const TransversalRange&, const TransversalRange&) = default;
};

/// A family of lines that meet all elements, none of them isolated.
struct TransversalComponent {
    enum class Kind : std::uint8_t {
        pencil,      ///< lines through `point` in `plane`, in `ranges`
        regulus,     ///< lines that meet three skew lines, in `ranges`
        plane,       ///< lines in `plane` that meet all elements, bounded by `extremal` lines
        bundle,      ///< all lines through `point`
        congruence,  ///< all lines that meet both of `pieces`, two skew segments
        segment,     ///< all lines that meet the one of `pieces`, which all elements contain
    };
    Kind kind = Kind::pencil;
    std::optional<RationalPoint3> point;
    std::optional<Plane3> plane;           ///< the first nonzero coordinate of its normal is 1
    std::vector<TransversalRange> ranges;  ///< ascending; none: the whole pencil or regulus
    std::vector<RationalLine3> extremal;   ///< scaled, ascending: through two ends of segments
    std::vector<TransversalElement> pieces;
    /// Of a regulus: three lines that all its lines meet.
    std::vector<RationalLine3> generators;

    friend bool operator==(const TransversalComponent&, const TransversalComponent&) = default;
};

[[nodiscard]] const char* name_of(TransversalComponent::Kind kind) noexcept;
std::ostream& operator<<(std::ostream& out, const TransversalComponent& component);

/// All lines that meet some elements.
struct Transversals {
    std::vector<TransversalLine> lines;            ///< ascending by root
    std::vector<TransversalComponent> components;  ///< by kind, then as found

    friend bool operator==(const Transversals&, const Transversals&) = default;
};

/// All lines that meet one to four elements; exact. Isolated lines, and the families that
/// dependent elements leave.
///
/// Laws
///  (1) permuting the elements changes nothing, but for `through` and generators of reguli
///  (2) translating, scaling and mirroring moves the lines alike
///  (3) repeating an element changes nothing
///  (4) every line of the result meets all elements (verify())
///
/// Cost: some hundred products of rational numbers.
/// \cite bronnimann_everett_lazard_sottile_whitesides_2005
[[nodiscard]] Transversals transversals(std::span<const TransversalElement> elements);

/// The lines with d ≠ 0 whose Plücker vectors have side zero to four lines: parallels count as
/// meeting. Ascending, at most two, one when they coincide; empty optional: infinitely many.
[[nodiscard]] std::optional<std::vector<SurdLine3>> lines_meeting(
    const std::array<RationalLine3, 4>& lines);

/// The certificate: whether it is a line at all, scaled, and shares a point with each element.
[[nodiscard]] bool verify(std::span<const TransversalElement> elements, const SurdLine3& line);

/// A point that the line and the element share. Where they share more, the element's source (of a
/// line element: its first point). Contract: meets(line, element).
[[nodiscard]] SurdVector3 witness(const SurdLine3& line, const TransversalElement& element);

/// Whether a line of the component's family lies within the component's bounds; for lines that
/// meet all elements, whether it belongs to that family.
[[nodiscard]] bool is_in_family(const TransversalComponent& component, const SurdLine3& line);

}  // namespace sightline
