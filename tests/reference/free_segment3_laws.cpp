// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "sightline/reference/free_segment3.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

using reference::first_hit;
using reference::is_free;
using reference::is_interior;

RationalPoint3 lattice_point() {
    const auto half = [] { return Rational(*rc::gen::inRange(-2, 14), 2); };
    const Rational x = half();
    const Rational y = half();
    return {x, y, half()};
}

RationalPoint3 between(const RationalPoint3& p, const RationalPoint3& q, const Rational& t) {
    return p + t * (q - p);
}

RC_GTEST_PROP(FreeSegment3Law, SeeingIsMutual, (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const RationalPoint3 p = lattice_point();
    const RationalPoint3 q = lattice_point();
    RC_ASSERT(is_free(scene, p, q) == is_free(scene, q, p));
}

RC_GTEST_PROP(FreeSegment3Law, PiecesOfFreeSegmentsAreFree, (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const RationalPoint3 p = lattice_point();
    const RationalPoint3 q = lattice_point();
    RC_PRE(is_free(scene, p, q));
    for (int i = 0; i <= 4; ++i) {
        for (int j = i; j <= 4; ++j) {
            RC_ASSERT(is_free(scene, between(p, q, Rational(i, 4)), between(p, q, Rational(j, 4))));
        }
    }
}

RC_GTEST_PROP(FreeSegment3Law, ARayIsFreeUpToItsEndAndNotBeyond, (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const RationalPoint3 p = lattice_point();
    const RationalPoint3 q = lattice_point();
    RC_PRE(p != q && !is_interior(scene, p));
    const FreeEnd3 end = first_hit(scene, p, q - p);
    const RationalPoint3 far = p + Rational(100) * (q - p);
    RC_ASSERT(end.point.has_value() != is_free(scene, p, far));
    RC_ASSERT(end.point.has_value() != end.faces.empty());
    if (end.point) {
        RC_ASSERT(is_free(scene, p, *end.point));
        RC_ASSERT(!is_free(scene, p, between(*end.point, far, Rational(1, 1000))));
    }
}

RC_GTEST_PROP(FreeSegment3Law, MaximalSegmentsAreWhatRaysFromTheirPointsReach,
              (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const RationalPoint3 p = lattice_point();
    const RationalPoint3 q = lattice_point();
    RC_PRE(p != q && is_free(scene, p, q));
    const FreeEnd3 ahead = first_hit(scene, p, q - p);
    const FreeEnd3 behind = first_hit(scene, q, p - q);
    const auto segments = reference::maximal_segments(scene, line_through(p, q));
    RC_ASSERT(std::any_of(segments.begin(), segments.end(), [&](const SegmentLabel& s) {
        return s.ends[0] == behind.faces && s.ends[1] == ahead.faces;
    }));
    const auto reversed = reference::maximal_segments(scene, line_through(q, p));
    RC_ASSERT(reversed.size() == segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const SegmentLabel& there = segments[i];
        const SegmentLabel& back = reversed[segments.size() - 1 - i];
        RC_ASSERT(there.support == back.support);
        RC_ASSERT(there.ends[0] == back.ends[1] && there.ends[1] == back.ends[0]);
    }
}

// No leak: a ray that is aimed exactly at a vertex or a point of an edge of a room, from anywhere in it,
// stays in it.
RC_GTEST_PROP(FreeSegment3Law, NothingLeavesAClosedRoom, ()) {
    const Scene3 scene = testing::degenerate_scene3(
        *rc::gen::element<std::string>("room_with_box", "room_with_box_on_floor"));
    const RationalPoint3 p{Rational(*rc::gen::inRange(0, 81), 10),
                           Rational(*rc::gen::inRange(0, 81), 10),
                           Rational(*rc::gen::inRange(0, 81), 10)};
    RC_PRE(!is_interior(scene, p));
    const auto& e = scene.edges()[*rc::gen::inRange<std::size_t>(0, scene.edges().size())];
    const RationalPoint3 aim = between(to_rational(scene[e.source]), to_rational(scene[e.target]),
                                       Rational(*rc::gen::inRange(0, 9), 8));
    RC_PRE(aim != p);
    const FreeEnd3 end = first_hit(scene, p, aim - p);
    RC_ASSERT(end.point.has_value());
    for (const Rational& x : {end.point->x, end.point->y, end.point->z}) {
        RC_ASSERT(Rational(0) <= x && x <= Rational(8));
    }
}

}  // namespace
}  // namespace sightline
