// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/cell3.hpp"
#include "reference/exact3.hpp"
#include "reference/line_picture3.hpp"

namespace sightline::reference::detail {

/// A one-parameter family of lines: through source + s·(target - source) of an edge, the base, and a fixed
/// point (a pencil), or two more edges' lines (a regulus; no two of the three meet).
class LineFamily {
public:
    /// The point is not on the base's line.
    LineFamily(const ExactScene& scene, EdgeId base, RationalTriple point);
    /// A pencil whose base need not be met: it only gives the lines parameters.
    LineFamily(const ExactScene& scene, ExactEdge base, RationalTriple point);
    LineFamily(const ExactScene& scene, EdgeId base, EdgeId second, EdgeId third);

    [[nodiscard]] ExactLine line_at(const Surd& s) const;
    /// The s in [0, 1], ascending, between which its lines meet all generators: pairs of ends.
    [[nodiscard]] std::vector<std::array<Rational, 2>> live() const;
    /// The s strictly between two at which the line meets an edge that not all lines of the family meet, or a
    /// point where features fix it; ascending.
    [[nodiscard]] std::vector<Surd> events(const Rational& first, const Rational& last) const;

    [[nodiscard]] const std::optional<RationalTriple>& point() const { return point_; }
    [[nodiscard]] const ExactEdge& base() const { return base_; }
    /// The edges that all lines meet: the base, and those of a regulus.
    [[nodiscard]] const std::vector<EdgeId>& edges() const { return edges_; }
    /// Whether lines with this freedom, one of which is of the family and meets its generators, are its lines.
    [[nodiscard]] bool is_family_of(const Freedom& freedom) const;

private:
    /// s ↦ constant + s·slope.
    struct Linear {
        Rational constant;
        Rational slope;
    };
    [[nodiscard]] RationalTriple base_point(const Rational& s) const {
        return plus(base().source, times(s, base().direction));
    }
    /// How far a point is from the plane of the base's point and a line.
    [[nodiscard]] Linear distance(const ExactEdge& line, const RationalTriple& p) const;
    [[nodiscard]] std::array<RationalTriple, 2> rational_line(const Rational& s) const;
    [[nodiscard]] Rational side(const Rational& s, const ExactEdge& e) const;
    void add_meetings(const ExactEdge& e, std::vector<Surd>& events) const;
    void add_point(const RationalTriple& p, std::vector<Surd>& events) const;

    const ExactScene* scene_;
    ExactEdge base_;
    std::vector<EdgeId> edges_;
    std::optional<RationalTriple> point_;
    Plane plane_;  ///< of a pencil
};

}  // namespace sightline::reference::detail
