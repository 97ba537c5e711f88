// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/families2_detail.hpp"
#include "scene/families_support.hpp"
#include "sightline/scene/families.hpp"
#include "sightline/scene/transform2.hpp"

namespace sightline {
namespace {

using families::transformed;
using families_test::fingerprint;
using families_test::points_of;
using testing::HasSubstr;

std::vector<families::Transform> exact_transforms() {
    return {families::Translation{12345, -77},
            families::PowerOfTwo{-30},
            families::IntegerRotation{3, 4},
            families::IntegerRotation{-5, 12},
            families::Mirror{},
            families::Permutation{9}};
}

/// Every element kind, a world, holes and coordinates that are integers.
SceneInput2 sample() {
    SceneInput2 scene = families::random_convex({.vertices = 60}, 4);
    scene.elements.emplace_back(Polyline2{{{1, 1}, {5, 1}, {5, 0}}});
    scene.elements.emplace_back(Point2{0, 0});
    scene.elements.emplace_back(Point2{2, 3});
    return scene;
}

TEST(ExactTransforms, KeepEveryIntegerFamilyValid) {
    const std::set<std::string_view> not_integer{"denormal",   "huge",    "tiny",
                                                 "magnitudes", "slivers", "near-collinear"};
    for (const families::FamilyInfo& family : families::all2()) {
        if (not_integer.contains(family.name)) continue;
        const Result<SceneInput2> scene = families::generate2(family.name, {}, 6);
        ASSERT_TRUE(scene);
        for (const families::Transform& transform : exact_transforms()) {
            const Result<SceneInput2> result = transformed(*scene, transform);
            ASSERT_TRUE(result) << family.name << ": " << result.error().message;
            const Result<Scene2> made = Scene2::make(*result);
            EXPECT_TRUE(made) << family.name << ", " << to_string(transform) << ": "
                              << made.error().message;
        }
    }
}

TEST(ExactTransforms, HaveInverses) {
    const SceneInput2 scene = sample();
    const auto there_and_back = [&](const families::Transform& there,
                                    const families::Transform& back) {
        return fingerprint(*transformed(*transformed(scene, there), back));
    };
    const std::uint64_t same = fingerprint(scene);
    EXPECT_EQ(there_and_back(families::Translation{3, 1e6}, families::Translation{-3, -1e6}), same);
    EXPECT_EQ(there_and_back(families::PowerOfTwo{900}, families::PowerOfTwo{-900}), same);
    EXPECT_EQ(there_and_back(families::Mirror{}, families::Mirror{}), same);
    const SceneInput2 twice = *transformed(*transformed(scene, families::IntegerRotation{3, 4}),
                                           families::IntegerRotation{3, -4});
    const std::vector<Point2> points = points_of(scene);
    const std::vector<Point2> scaled = points_of(twice);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(scaled[i], (Point2{25 * points[i].x, 25 * points[i].y}));
    }
}

TEST(ExactTransforms, RotateAndMirrorTheRightWay) {
    SceneInput2 scene;
    scene.elements.emplace_back(Point2{1, 0});
    EXPECT_EQ(points_of(*transformed(scene, families::IntegerRotation{3, 4})).front(),
              (Point2{3, 4}));
    EXPECT_EQ(points_of(*transformed(scene, families::Mirror{})).front(), (Point2{-1, 0}));
    EXPECT_EQ(points_of(*transformed(scene, families::ApproxRotation{90})).front(), (Point2{0, 1}));
}

TEST(ExactTransforms, RefuseToRound) {
    SceneInput2 scene;
    scene.elements.emplace_back(Point2{0.1, 1e300});
    const auto code = [&](const families::Transform& transform) {
        const Result<SceneInput2> result = transformed(scene, transform);
        return result ? Errc::syntax : result.error().code;
    };
    EXPECT_EQ(code(families::Translation{1, 0}), Errc::bad_parameter);
    EXPECT_EQ(code(families::IntegerRotation{3, 4}), Errc::bad_parameter);
    EXPECT_EQ(code(families::PowerOfTwo{30}), Errc::bad_parameter);     // overflows
    EXPECT_EQ(code(families::PowerOfTwo{-1070}), Errc::bad_parameter);  // underflows
    EXPECT_EQ(code(families::ApproxScaling{1e10}), Errc::coordinate_too_large);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(families::ApproxRotation{nan}), Errc::bad_parameter);
    EXPECT_EQ(code(families::Translation{nan, 0}), Errc::bad_parameter);
    EXPECT_EQ(code(families::IntegerRotation{0, 0}), Errc::bad_parameter);
    EXPECT_EQ(code(families::IntegerRotation{1, INT64_MIN}), Errc::bad_parameter);
    EXPECT_THAT(transformed(scene, families::Translation{1, 0}).error().message,
                HasSubstr("approx_"));
    EXPECT_TRUE(transformed(scene, families::ApproxTranslation{1, 0}));
}

TEST(Permuted, SaysWhichVertexWentWhere) {
    const SceneInput2 scene = sample();
    const std::vector<Point2> before = points_of(scene);
    bool moved = false;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const families::PermutedScene2 result = families::permuted(scene, seed);
        const std::vector<Point2> after = points_of(result.scene);
        ASSERT_EQ(after.size(), before.size());
        ASSERT_EQ(result.old_vertex.size(), before.size());
        std::set<std::uint32_t> used;
        for (std::size_t i = 0; i < after.size(); ++i) {
            ASSERT_LT(result.old_vertex[i], before.size());
            EXPECT_EQ(after[i], before[result.old_vertex[i]]);
            used.insert(result.old_vertex[i]);
        }
        EXPECT_EQ(used.size(), before.size());
        EXPECT_TRUE(std::holds_alternative<Polygon2>(result.scene.elements.front()))
            << "the world leads";
        EXPECT_TRUE(result.scene.world);
        EXPECT_TRUE(Scene2::make(result.scene));
        moved = moved || fingerprint(result.scene) != fingerprint(scene);
    }
    EXPECT_TRUE(moved);
}

TEST(Permuted, KeepsLinesWithTheirElements) {
    SceneInput2 scene;
    for (int i = 0; i < 30; ++i) {
        scene.elements.emplace_back(Point2{static_cast<double>(i), 0});
        scene.lines.push_back(static_cast<std::uint32_t>(100 + i));
    }
    const SceneInput2 result = families::permuted(scene, 3).scene;
    ASSERT_EQ(result.lines.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_EQ(std::get<Point2>(result.elements[i]).x + 100, result.lines[i]);
    }
}

TEST(ApproxRotation, IsWithinAFewUlpsAndExactAtRightAngles) {
    for (int degrees = -720; degrees <= 720; ++degrees) {
        const auto v = families::detail::approx_cos_sin(degrees + 0.3);
        const long double angle = (degrees + 0.3) * 3.14159265358979323846264L / 180;
        EXPECT_NEAR(v.cosine, static_cast<double>(std::cos(angle)), 1e-15);
        EXPECT_NEAR(v.sine, static_cast<double>(std::sin(angle)), 1e-15);
    }
    const SceneInput2 scene = sample();
    EXPECT_EQ(fingerprint(*transformed(scene, families::ApproxRotation{360})), fingerprint(scene));
    const SceneInput2 half = *transformed(scene, families::ApproxRotation{180});
    EXPECT_EQ(points_of(half).front().x, -points_of(scene).front().x);
}

TEST(Nudge, MovesCoordinatesByAtMostOneUlp) {
    const std::vector<Point2> before = points_of(sample());
    const SceneInput2 result = *transformed(sample(), families::Nudge{.seed = 4, .per_mille = 400});
    const std::vector<Point2> after = points_of(result);
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_TRUE(after[i].x == before[i].x ||
                    std::nextafter(before[i].x, after[i].x) == after[i].x);
        EXPECT_TRUE(after[i].y == before[i].y ||
                    std::nextafter(before[i].y, after[i].y) == after[i].y);
        moved += (after[i].x != before[i].x ? 1U : 0U) + (after[i].y != before[i].y ? 1U : 0U);
    }
    EXPECT_GT(moved, before.size() / 2);
    EXPECT_LT(moved, before.size() * 3 / 2);
    EXPECT_EQ(fingerprint(*transformed(sample(), families::Nudge{1, 0})), fingerprint(sample()));
}

TEST(Transform, SaysWhatItIs) {
    EXPECT_EQ(to_string(families::Transform(families::ApproxRotation{17.3})),
              "approx rotation by 17.3 degrees");
    EXPECT_EQ(to_string(families::Transform(families::Translation{1e8, -0.5})),
              "translation by 1e+08, -0.5");
    EXPECT_EQ(to_string(families::Transform(families::PowerOfTwo{-3})), "scaling by 2^-3");
    for (const families::Transform& transform : exact_transforms())
        EXPECT_TRUE(is_exact(transform));
    EXPECT_FALSE(is_exact(families::ApproxScaling{2}));
    EXPECT_FALSE(is_exact(families::Nudge{}));
}

}  // namespace
}  // namespace sightline
