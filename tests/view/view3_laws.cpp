// SPDX-License-Identifier: GPL-3.0-or-later
// Views do not depend on where a scene lies, how large it is, how its faces are cut, and hardly on its handedness.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "sightline/scene/transform3.hpp"
#include "view/view3_support.hpp"

namespace sightline::testing {
namespace {

using Move = std::function<Result<SceneInput3>(const SceneInput3&)>;
using MovePoint = std::function<RationalPoint3(const RationalPoint3&)>;

/// The maps of views of a random scene, and of the moved scene from the moved viewpoint.
std::optional<std::pair<ViewMap3, ViewMap3>> two_views(std::uint64_t seed, const Move& move,
                                                       const MovePoint& move_point,
                                                       const MovePoint& move_direction) {
    const SceneInput3 input = random_scene3(seed);
    const auto moved = move(input);
    if (!moved) return std::nullopt;
    const Scene3 a = scene3(input);
    const Scene3 b = scene3(*moved);
    std::mt19937_64 bits(seed);
    const Viewpoint3 from = random_viewpoint(bits, 2 + static_cast<int>(seed % 5));
    const Viewpoint3 other{
        from.at_infinity ? move_direction(from.coordinates) : move_point(from.coordinates),
        from.at_infinity};
    const auto x = look(PointVisibility3(a), from);
    const auto y = look(PointVisibility3(b), other);
    RC_ASSERT(x.has_value() == y.has_value());
    if (!x) return std::nullopt;
    return std::pair{x->map, y->map};
}

std::uint64_t any_seed() { return *rc::gen::inRange<std::uint64_t>(0, 100'000); }
RationalPoint3 same(const RationalPoint3& p) { return p; }

RC_GTEST_PROP(View3Law, MovingTheSceneAndTheViewpointChangesNothing, ()) {
    const auto maps = two_views(
        any_seed(), [](const SceneInput3& s) { return families::translated3(s, 5, -16, 0.25); },
        [](const RationalPoint3& p) {
            return RationalPoint3{p.x + 5, p.y - 16, p.z + Rational(1) / 4};
        },
        same);
    if (maps) RC_ASSERT(maps->first == maps->second);
}

RC_GTEST_PROP(View3Law, APowerOfTwoChangesNothing, ()) {
    const int exponent = *rc::gen::inRange(-300, 300);
    const Rational factor(std::ldexp(1.0, exponent));
    const auto maps = two_views(
        any_seed(), [&](const SceneInput3& s) { return families::scaled3(s, exponent); },
        [&](const RationalPoint3& p) {
            return RationalPoint3{factor * p.x, factor * p.y, factor * p.z};
        },
        same);
    if (maps) RC_ASSERT(maps->first == maps->second);
}

RC_GTEST_PROP(View3Law, TurningTheAxesChangesNothing, ()) {
    const auto turn = [](const RationalPoint3& p) { return RationalPoint3{p.y, p.z, p.x}; };
    const auto maps = two_views(
        any_seed(),
        [](const SceneInput3& s) -> Result<SceneInput3> {
            return families::with_axes_permuted3(s, {1, 2, 0});
        },
        turn, turn);
    if (maps) RC_ASSERT(maps->first == maps->second);
}

RC_GTEST_PROP(View3Law, CuttingFacesIntoTrianglesChangesNothing, ()) {
    const auto maps = two_views(
        any_seed(),
        [](const SceneInput3& s) -> Result<SceneInput3> { return families::triangulated3(s); },
        same, same);
    if (maps) RC_ASSERT(maps->first == maps->second);
}

RC_GTEST_PROP(View3Law, AMirrorExchangesLeftAndRight, ()) {
    const auto mirror = [](const RationalPoint3& p) { return RationalPoint3{-p.x, p.y, p.z}; };
    const auto maps = two_views(
        any_seed(),
        [](const SceneInput3& s) -> Result<SceneInput3> { return families::mirrored3(s); }, mirror,
        mirror);
    if (!maps) return;
    auto mirrored = reference::labels_of({{}, {}, maps->second});
    for (auto& arc : mirrored.arcs) {
        std::swap(arc.left, arc.right);
        std::swap(arc.left_kind, arc.right_kind);
    }
    std::sort(mirrored.arcs.begin(), mirrored.arcs.end());
    RC_ASSERT(reference::labels_of({{}, {}, maps->first}) == mirrored);
}

RC_GTEST_PROP(View3Law, FilteredAndExactArithmeticAgree, ()) {
    const std::uint64_t seed = any_seed();
    const Scene3 scene = scene3(random_scene3(seed));
    const PointVisibility3 visibility(scene);
    std::mt19937_64 bits(seed);
    const Viewpoint3 from = random_viewpoint(bits, 2 + static_cast<int>(seed % 5));
    View3Options options;
    const auto filtered = look(visibility, from, options);
    options.arithmetic = Arithmetic::exact;
    const auto exact = look(visibility, from, options);
    RC_ASSERT(filtered.has_value() == exact.has_value());
    if (filtered) RC_ASSERT(filtered->map == exact->map);
}

}  // namespace
}  // namespace sightline::testing
