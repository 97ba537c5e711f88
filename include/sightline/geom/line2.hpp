// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <ostream>

#include "sightline/arith/sign.hpp"
#include "sightline/geom/point.hpp"

namespace sightline {

/// A directed line, kept as the two different points that define it.
/// Equality is that of the generators; is_same_line() compares lines as sets of points.
struct Line2 {
    Point2 source;
    Point2 target;

    friend bool operator==(const Line2&, const Line2&) = default;
    friend std::partial_ordering operator<=>(const Line2&, const Line2&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Line2& line);
};

[[nodiscard]] inline Line2 reversed(const Line2& line) { return {line.target, line.source}; }

/// How the directions of two lines turn: positive when m points to the left of l, zero when
/// parallel. Exact.
[[nodiscard]] Sign turn(const Line2& l, const Line2& m);

/// Whether both are the same set of points. Exact.
[[nodiscard]] bool is_same_line(const Line2& l, const Line2& m);

/// The point in which two lines that are not parallel meet, kept as these lines.
///
/// Predicates work on the generators; coordinates exist only on request. Equality and order of the
/// objects are those of the generators: to compare places, use compare_xy().
/// Made by intersection() only, and therefore always a point.
class ImplicitPoint2 {
public:
    /// The two lines; the second is reversed if need be, so that turn(first, second) is positive.
    [[nodiscard]] const Line2& first() const noexcept { return first_; }
    [[nodiscard]] const Line2& second() const noexcept { return second_; }

    friend bool operator==(const ImplicitPoint2&, const ImplicitPoint2&) = default;
    friend std::partial_ordering operator<=>(const ImplicitPoint2&,
                                             const ImplicitPoint2&) = default;
    friend std::ostream& operator<<(std::ostream& out, const ImplicitPoint2& p);
    friend std::optional<ImplicitPoint2> intersection(const Line2& l, const Line2& m);

private:
    ImplicitPoint2(const Line2& first, const Line2& second) : first_(first), second_(second) {}

    Line2 first_;
    Line2 second_;
};

/// The common point of two lines; empty when they are parallel or not lines.
[[nodiscard]] std::optional<ImplicitPoint2> intersection(const Line2& l, const Line2& m);

/// The coordinates of p; exact.
[[nodiscard]] RationalPoint2 to_rational(const ImplicitPoint2& p);

/// The doubles nearest to p's coordinates, for drawing.
[[nodiscard]] Point2 approx_point(const ImplicitPoint2& p);

}  // namespace sightline
