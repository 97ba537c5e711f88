// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Lines through a point in a plane, and lines in a plane, that meet things in that plane. Private.

#include <vector>

#include "event/circle.hpp"
#include "sightline/event/transversals.hpp"

namespace sightline::detail {

/// What solving a part of the problem gives: isolated candidates, unscaled, and components.
struct Findings {
    std::vector<RationalLine3> lines;
    std::vector<TransversalComponent> components;

    void add(Findings&& other);
};

/// A positive multiple of the plane, or a negative one, whose first nonzero normal coordinate is 1.
[[nodiscard]] Plane3 scaled(const Plane3& plane);

[[nodiscard]] bool lies_in(const Plane3& plane, const RationalLine3& line);
[[nodiscard]] bool lies_in(const Plane3& plane, const TransversalElement& element);

/// Whether a point belongs to the element.
[[nodiscard]] bool holds(const TransversalElement& element, const RationalPoint3& p);

/// The pencil of lines through a point in a plane, with its directions as parameters.
class Pencil {
public:
    Pencil(RationalPoint3 center, const Plane3& plane);

    [[nodiscard]] RationalLine3 line(const CirclePoint& at) const;
    [[nodiscard]] CirclePoint parameter_of(const Vector3& direction) const;
    /// To meet an element in the plane whose carrier does not hold the centre.
    [[nodiscard]] CircleConstraint constraint(const TransversalElement& element) const;
    [[nodiscard]] TransversalRange range(const CircleArc& arc) const;
    [[nodiscard]] TransversalComponent component(const std::vector<CircleArc>& arcs) const;
    [[nodiscard]] const RationalPoint3& center() const noexcept { return center_; }

private:
    [[nodiscard]] LinearForm across(const Vector3& v) const;

    RationalPoint3 center_;
    Plane3 plane_;
    Vector3 first_;
    Vector3 second_;
};

/// The lines through a point in a plane that meet elements in that plane.
[[nodiscard]] CircleSet lines_of_pencil(const Pencil& pencil,
                                        const std::vector<TransversalElement>& elements);

/// The same as findings.
[[nodiscard]] Findings solve_pencil(const Pencil& pencil,
                                    const std::vector<TransversalElement>& elements);

/// The lines in a plane that meet segments and lines in it, on distinct lines; two at least.
[[nodiscard]] Findings solve_plane(const Plane3& plane,
                                   const std::vector<TransversalElement>& elements);

/// A range with `from` <= `to`.
[[nodiscard]] TransversalRange ordered(TransversalRange range);

}  // namespace sightline::detail
