// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of sightline/event/swath.hpp on random lines, many of them degenerate.
#include "sightline/event/swath.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "event/lines3.hpp"

namespace sightline {
namespace {

using testing::any_line3;
using testing::any_parameter;
using testing::any_point3;
using testing::is_zero;
using testing::point_at;

RC_GTEST_PROP(SurfaceLaw, ValueIsTheSideOfTheLineThroughThePoint, ()) {
    const RationalLine3 a = any_line3(), b = any_line3(), c = any_line3();
    const RationalPoint3 x = any_point3();
    RC_ASSERT(surface_of(a, b, c)(x) == side(line_through(x, a, b), c));
}

RC_GTEST_PROP(SurfaceLaw, ExchangingLinesFlipsIt, ()) {
    const RationalLine3 a = any_line3(), b = any_line3(), c = any_line3();
    const RationalPoint3 x = any_point3();
    RC_ASSERT(surface_of(b, a, c)(x) == -surface_of(a, b, c)(x));
    RC_ASSERT(surface_of(b, c, a) == surface_of(a, b, c));
}

RC_GTEST_PROP(SurfaceLaw, HoldsItsGenerators, ()) {
    const RationalPoint3 p = any_point3(), q = any_point3();
    RC_PRE(p != q);
    const Quadric3 surface = surface_of(line_through(p, q), any_line3(), any_line3());
    RC_ASSERT(is_zero(surface(point_at(p, q, any_parameter()))));
}

RC_GTEST_PROP(SurfaceLaw, TwoCoplanarLinesMakeItTwoPlanes, ()) {
    const RationalPoint3 q = any_point3(), p1 = any_point3(), p2 = any_point3();
    RC_PRE(q != p1 && q != p2);
    const RationalLine3 a = line_through(q, p1), b = line_through(q, p2), c = any_line3();
    const Plane3 common = plane_through(q, p1, p2);
    const Plane3 other = plane_through(q, c);
    const Quadric3 surface = surface_of(a, b, c);
    if (common.is_degenerate() || other.is_degenerate() || surface.is_zero()) return;
    // The ratio of the two sides is one number, wherever they are taken.
    const RationalPoint3 x = any_point3(9), y = any_point3(9);
    RC_ASSERT(surface(x) * (common.height(y) * other.height(y)) ==
              surface(y) * (common.height(x) * other.height(x)));
    RC_ASSERT(is_zero(surface(x)) == is_zero(common.height(x) * other.height(x)));
}

RC_GTEST_PROP(DirectionsLaw, ValueIsTheSideOfTheLineOfThatDirection, ()) {
    const RationalLine3 a = any_line3(), b = any_line3(), c = any_line3();
    const RationalPoint3 p = any_point3();
    const Vector3 d = vector_to(p);
    // The planes through a and b that are parallel to d.
    const Plane3 over_a{cross(a.d, d), dot(a.m, d)};
    const Plane3 over_b{cross(b.d, d), dot(b.m, d)};
    const RationalLine3 line = line_of(over_a, over_b);
    RC_ASSERT(cross(line.d, d).is_zero());
    RC_ASSERT(directions_of(a, b, c)(d) == side(line, c));
    RC_ASSERT(directions_of(a, b, c) == surface_of(a, b, c).quadratic);
}

RC_GTEST_PROP(ZerosLaw, AreTheZerosInOrder, ()) {
    const auto number = [] { return Rational(*rc::gen::inRange(-4, 5)); };
    const std::array<Rational, 3> c{number(), number(), number()};
    RC_PRE(!is_zero(c[0]) || !is_zero(c[1]) || !is_zero(c[2]));
    const auto zeros = zeros_of(c);
    for (const Surd& t : zeros) {
        RC_ASSERT((Surd(c[0]) + t * (Surd(c[1]) + t * Surd(c[2]))).sign() == Sign::zero);
    }
    const Rational discriminant = c[1] * c[1] - 4 * c[0] * c[2];
    std::size_t expected = 0;
    if (!is_zero(c[2])) {
        expected = static_cast<std::size_t>(static_cast<int>(discriminant.sign()) + 1);
    } else if (!is_zero(c[1])) {
        expected = 1;
    }
    RC_ASSERT(zeros.size() == expected);
    if (zeros.size() == 2) RC_ASSERT(zeros[0] < zeros[1]);
}

RC_GTEST_PROP(PencilLaw, LinesAlongALinePassTheCentreAndThePoint, ()) {
    const RationalPoint3 v = any_point3(), p = any_point3(), q = any_point3();
    RC_PRE(!cross(p - v, q - v).is_zero());
    const Swath swath = Swath::pencil({vector_to(v), 1}, line_through(p, q));
    RC_ASSERT(swath.kind() == SwathKind::pencil);
    RC_ASSERT(swath.all_pass(v));
    RC_ASSERT(swath.all_meet(line_through(p, q)));
    RC_ASSERT(swath.all_in(plane_through(v, p, q)));
    const LineCurve3 curve = swath.along(p, q);
    RC_ASSERT(curve.degree() == 1);
    const Rational t = any_parameter();
    const RationalPoint3 at = point_at(p, q, t);
    RC_ASSERT(scaled(curve.at(t)) == scaled(line_through(v, at)));
    RC_ASSERT(swath.contains(curve.at(t)));
    RC_ASSERT(scaled(curve.at_infinity()) == scaled(line_along(v, q - p)));
    RC_ASSERT(is_zero(swath.surface()(at)));
    const RationalPoint3 x = any_point3();
    RC_ASSERT(is_zero(swath.surface()(x)) == is_zero(plane_through(v, p, q).height(x)));
}

RC_GTEST_PROP(PencilLaw, ParallelsAreOneDirectionInAPlane, ()) {
    const Vector3 d = vector_to(any_point3());
    const RationalPoint3 p = any_point3(), q = any_point3();
    RC_PRE(!cross(q - p, d).is_zero());
    const Swath swath = Swath::pencil({d, 0}, line_through(p, q));
    RC_ASSERT(swath.kind() == SwathKind::parallel);
    const LineCurve3 curve = swath.along(p, q);
    const Rational t = any_parameter();
    RC_ASSERT(scaled(curve.at(t)) == scaled(line_along(point_at(p, q, t), d)));
    RC_ASSERT(swath.contains(curve.at(t)));
    RC_ASSERT(!swath.contains(line_through(p, q)));
    RC_ASSERT(!curve.at_infinity().is_line());
    RC_ASSERT(swath.all_in(plane_through(p, q, p + d)));
    RC_ASSERT(swath == Swath::pencil({Rational(-2) * d, 0}, line_through(q, p)));
}

/// Three lines without a common plane in pairs.
std::array<RationalLine3, 3> skew_lines() {
    std::array<RationalLine3, 3> l{any_line3(), any_line3(), any_line3()};
    while (is_zero(side(l[0], l[1])) || is_zero(side(l[1], l[2])) || is_zero(side(l[2], l[0]))) {
        for (RationalLine3& line : l) line = any_line3();
    }
    return l;
}

RC_GTEST_PROP(RegulusLaw, LinesAlongAGeneratorMeetAllThree, ()) {
    RationalPoint3 p, q;
    std::array<RationalLine3, 3> l;
    do {
        p = any_point3();
        q = any_point3();
        if (p == q) continue;
        l = {line_through(p, q), any_line3(), any_line3()};
    } while (p == q || is_zero(side(l[0], l[1])) || is_zero(side(l[1], l[2])) ||
             is_zero(side(l[2], l[0])));
    const Swath swath = Swath::regulus(l[1], l[0], l[2]);
    const LineCurve3 curve = swath.along(p, q);
    RC_ASSERT(curve.degree() == 2);
    const Rational t = any_parameter();
    const RationalLine3 line = curve.at(t);
    RC_ASSERT(is_zero(dot(line.d, line.m)));
    RC_ASSERT(!line.d.is_zero() || !line.m.is_zero());
    for (const RationalLine3& generator : l) RC_ASSERT(is_zero(side(line, generator)));
    if (line.d.is_zero()) return;  // the parameter of the line at infinity
    RC_ASSERT(is_on(line, point_at(p, q, t)));
    RC_ASSERT(swath.contains(line));
    RC_ASSERT(is_zero(swath.surface()(foot_of_origin(line))));
    RC_ASSERT(is_zero(swath.surface()(foot_of_origin(line) + line.d)));
    RC_ASSERT(is_zero(swath.directions()(line.d)));
    // Any line through two of its lines' points on the first two generators that meets the third.
    RC_ASSERT(scaled(line) == scaled(line_through(point_at(p, q, t), l[1], l[2])));
}

RC_GTEST_PROP(RegulusLaw, GeneratorsAreInterchangeable, ()) {
    const auto [a, b, c] = skew_lines();
    const Swath swath = Swath::regulus(a, b, c);
    RC_ASSERT(Swath::regulus(c, a, -b) == swath);
    RC_ASSERT(!swath.contains(a));
    RC_ASSERT(swath.all_meet(a) && swath.all_meet(b) && swath.all_meet(c));
    // The lines of the family generate the opposite family, and that one the first again.
    const LineCurve3 curve = swath.along(foot_of_origin(a), foot_of_origin(a) + a.d);
    std::vector<RationalLine3> lines;
    for (int t = 1; lines.size() < 3; ++t) {
        if (curve.at(Rational(t)).is_line()) lines.push_back(curve.at(Rational(t)));
    }
    const Swath opposite = Swath::regulus(lines[0], lines[1], lines[2]);
    RC_ASSERT(opposite.contains(a) && opposite.contains(b) && opposite.contains(c));
    RC_ASSERT(!(opposite == swath));
    RC_ASSERT(opposite.surface().is_zero() == false);
    const RationalPoint3 x = any_point3(9), y = any_point3(9);
    RC_ASSERT(opposite.surface()(x) * swath.surface()(y) ==
              opposite.surface()(y) * swath.surface()(x));
    // A fourth line of the opposite family is as good a generator.
    const LineCurve3 across =
        opposite.along(foot_of_origin(lines[0]), foot_of_origin(lines[0]) + lines[0].d);
    const RationalLine3 fourth = across.at(any_parameter());
    if (!fourth.is_line()) return;
    RC_ASSERT(swath.all_meet(fourth));
    const RationalPoint3 p = foot_of_origin(fourth);
    const RationalLine3 through = swath.along(p, p + fourth.d).at(any_parameter());
    RC_ASSERT(through.d.is_zero() || swath.contains(through));
}

RC_GTEST_PROP(RegulusLaw, SidesOfTheSurfaceAreSidesOfTheThirdLine, ()) {
    const auto [a, b, c] = skew_lines();
    const Swath swath = Swath::regulus(a, b, c);
    const RationalPoint3 x = any_point3();
    const RationalLine3 line = line_through(x, a, b);
    if (!line.is_line()) return;
    RC_ASSERT(swath.surface()(x).sign() == side(line, c).sign());
    RC_ASSERT(swath.contains(line) == is_zero(swath.surface()(x)));
}

RC_GTEST_PROP(LineThroughLaw, PointOfASwathHasItsLineAndNoOtherPointOne, ()) {
    const auto [a, b, c] = skew_lines();
    const RationalPoint3 v = any_point3();
    for (const Swath& swath : {Swath::regulus(a, b, c), Swath::pencil({c.d, 0}, a)}) {
        const auto through = swath.line_through(v);
        if (through) RC_ASSERT(swath.contains(*through) && is_on(*through, v));
        if (!is_zero(swath.surface()(v))) RC_ASSERT(!through.has_value());
        const RationalPoint3 on_a = foot_of_origin(a);
        const RationalLine3 line = swath.along(on_a, on_a + a.d).at(any_parameter());
        if (line.d.is_zero()) continue;
        const RationalPoint3 p = foot_of_origin(line);
        const auto again = swath.line_through(p);
        RC_ASSERT(again.has_value());
        RC_ASSERT(*again == scaled(line));
        const auto at_a = swath.line_through(on_a);
        if (at_a) RC_ASSERT(is_on(*at_a, on_a));
    }
}

RC_GTEST_PROP(LinesMeetingLaw, FourthLineLeavesAtMostTwoLines, ()) {
    const auto [a, b, c] = skew_lines();
    const RationalLine3 l = any_line3();
    const Swath swath = Swath::regulus(a, b, c);
    const auto lines = swath.lines_meeting(l);
    RC_ASSERT(lines.has_value() == !swath.all_meet(l));
    if (!lines) return;
    RC_ASSERT(lines->size() <= 2);
    for (const SurdLine3& line : *lines) {
        RC_ASSERT(line.is_line());
        RC_ASSERT(swath.contains(line));
        for (const RationalLine3& k : {a, b, c, l}) {
            RC_ASSERT(side(line, to_surd(k)).sign() == Sign::zero);
        }
    }
    // Formula 5: the discriminant of the four lines says how many there are, if none is at infinity.
    const std::array<RationalLine3, 4> all{a, b, c, l};
    const auto s = [&](std::size_t i, std::size_t j) { return side(all[i], all[j]); };
    const Rational p = s(0, 1) * s(2, 3), q = s(0, 2) * s(1, 3), r = s(0, 3) * s(1, 2);
    const Rational discriminant = p * p + q * q + r * r - 2 * p * q - 2 * q * r - 2 * r * p;
    if (discriminant.sign() == Sign::negative) RC_ASSERT(lines->empty());
    if (discriminant.sign() == Sign::zero) RC_ASSERT(lines->size() <= 1);
}

}  // namespace
}  // namespace sightline
