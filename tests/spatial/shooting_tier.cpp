// SPDX-License-Identifier: GPL-3.0-or-later
// What doubles decide about rays is certain; and they decide what is not close.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "sightline/geom/predicates3.hpp"
#include "sightline/spatial/shooting.hpp"
#include "spatial/ray_filter.hpp"
#include "support/arbitrary3.hpp"
#include "support/scenes3.hpp"

namespace sightline {
namespace {

using detail::Corners;
using detail::pass;
using detail::Passage;
using detail::Ray;

/// Rays aimed at a triangle's inside, border or corners, missed by a few units in the last place, near
/// the origin and far from it.
class Aims {
public:
    explicit Aims(std::uint64_t seed) : random_(seed) {
        offset_ = seed % 3 == 0 ? 0 : std::ldexp(1.0, static_cast<int>(random_() % 40));
        for (Point3& c : corners) c = point();
        p = point();
        const double s = quarter();
        const double t = quarter() * (1 - s);
        const auto mix = [&](double a, double b, double c) {
            return nudged(a + s * (b - a) + t * (c - a));
        };
        const auto& [a, b, c] = corners;
        const Point3 aim{mix(a.x, b.x, c.x), mix(a.y, b.y, c.y), mix(a.z, b.z, c.z)};
        // At the triangle, or beyond it.
        const double reach = random_() % 2 == 0 ? 1 : 3;
        q = {p.x + reach * (aim.x - p.x), p.y + reach * (aim.y - p.y), p.z + reach * (aim.z - p.z)};
    }

    [[nodiscard]] Corners numbers() const {
        Corners result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = {corners[k].x, corners[k].y, corners[k].z};
        return result;
    }

    std::array<Point3, 3> corners;
    Point3 p;
    Point3 q;

private:
    double quarter() { return static_cast<double>(random_() % 5) / 4; }
    double nudged(double x) {
        for (auto i = random_() % 3; i > 0; --i) x = std::nextafter(x, x + 1);
        return x;
    }
    double coordinate() { return offset_ + std::ldexp(static_cast<double>(random_() >> 11), -50); }
    Point3 point() { return {coordinate(), coordinate(), coordinate()}; }

    std::mt19937_64 random_;
    double offset_ = 0;
};

/// The exact parameter at which the line meets the triangle's plane.
Rational parameter_of(const Aims& aims) {
    const Vector3 d = to_rational(aims.q) - to_rational(aims.p);
    const Vector3 a = to_rational(aims.corners[0]) - to_rational(aims.p);
    const Vector3 b = to_rational(aims.corners[1]) - to_rational(aims.p);
    const Vector3 c = to_rational(aims.corners[2]) - to_rational(aims.p);
    const Vector3 n = cross(b - a, c - a);
    return dot(n, a) / dot(n, d);
}

RC_GTEST_PROP(RayFilterTier, WhatIsSureIsTrue, (std::uint64_t seed)) {
    const Aims aims(seed);
    RC_PRE(aims.p != aims.q);
    const bool is_segment = *rc::gen::arbitrary<bool>();
    const Passage got = pass<true>(Ray(aims.p, aims.q, is_segment), aims.numbers());
    if (got.kind == Passage::Kind::unsure) return;
    const auto& [a, b, c] = aims.corners;
    RC_PRE(orientation(a, b, c, {0.123, 0.456, -7}) != Sign::zero);
    const LineTriangle exact = line_triangle(aims.p, aims.q, a, b, c);
    const bool crosses = exact.kind == LineTriangle::Kind::crosses_inside;
    if (got.kind == Passage::Kind::crosses) {
        RC_ASSERT(crosses);
        const Rational t = parameter_of(aims);
        RC_ASSERT(Rational(got.low) <= t && t <= Rational(got.high));
        RC_ASSERT(Rational(0) < t && (!is_segment || t < Rational(1)));
    } else if (exact.kind != LineTriangle::Kind::misses) {
        RC_ASSERT(exact.kind != LineTriangle::Kind::in_plane);
        const Rational t = parameter_of(aims);
        RC_ASSERT(t < Rational(0) || (is_segment && Rational(1) < t));
    }
}

TEST(RayFilterTier, DecidesWhatIsNotClose) {
    int unsure = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        std::mt19937_64 random(seed);
        const auto point = [&] {
            const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
            return Point3{unit(), unit(), unit()};
        };
        Corners c;
        for (auto& corner : c) {
            const Point3 p = point();
            corner = {p.x, p.y, p.z};
        }
        const Point3 p = point();
        const Point3 q = point();
        if (pass<true>(Ray(p, q, false), c).kind == Passage::Kind::unsure) ++unsure;
    }
    EXPECT_EQ(unsure, 0);
}

RC_GTEST_PROP(RayFilterLaw, ARayEntersEveryBoxAtItsPoints, (std::uint64_t seed)) {
    const Aims aims(seed);
    RC_PRE(aims.p != aims.q);
    const Ray ray(aims.p, aims.q, false);
    const Rational t(*rc::gen::inRange(0, 60), 16);
    const RationalPoint3 x = to_rational(aims.p) + t * (to_rational(aims.q) - to_rational(aims.p));
    Box3 box;
    const std::array<Rational, 3> coordinates{x.x, x.y, x.z};
    for (std::size_t i = 0; i < 3; ++i) {
        const Interval hull = enclosure(coordinates[i]);
        box.low[i] = *rc::gen::arbitrary<bool>() ? hull.lower : hull.lower - 1;
        box.high[i] = *rc::gen::arbitrary<bool>() ? hull.upper : hull.upper + 1;
    }
    const double near = ray.enters(box);
    RC_ASSERT(near < Box3::infinite);
    RC_ASSERT(Rational(near) <= t);
}

TEST(SegmentShooterTier, OneUlpBesideAnEdgeIsToldFromTheEdge) {
    const Scene3 scene = testing::scene3("box 0 0 0, 1 1 1");
    SegmentShooter shooter(scene);
    const Point3 p{-3, 0.1, 0.7};
    // Level with the top edges: grazes; one unit below: blocked; above: passes.
    const double below = std::nextafter(1.0, 0.0);
    const double above = std::nextafter(1.0, 2.0);
    const auto aimed = [&](double z) {
        return shooter.is_free(p, Point3{0 + 3, 0.1 + 0.1, 0.7 + 2 * (z - 0.7)});
    };
    EXPECT_TRUE(shooter.is_free(Point3{-3, 0.1, 1}, Point3{3, 0.2, 1}));
    EXPECT_FALSE(shooter.is_free(Point3{-3, 0.1, below}, Point3{3, 0.2, below}));
    EXPECT_TRUE(shooter.is_free(Point3{-3, 0.1, above}, Point3{3, 0.2, above}));
    EXPECT_FALSE(aimed(0.9));
}

// The same scene and points times a power of two: the same answers, out of the filter's range as well.
RC_GTEST_PROP(SegmentShooterLaw, ScalingByAPowerOfTwoChangesNothing, (const SceneInput3& input)) {
    const int exponent = *rc::gen::element(-1060, -700, -300, 250, 450);
    const auto scaled = [&](const Point3& p) {
        return Point3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent),
                      std::ldexp(p.z, exponent)};
    };
    SceneInput3 other = input;
    for (MeshInput3& mesh : other.meshes) {
        for (Point3& p : mesh.vertices) p = scaled(p);
    }
    const Scene3 scene = testing::scene3(input);
    const Scene3 scaled_scene = testing::scene3(other);
    SegmentShooter shooter(scene);
    SegmentShooter scaled_shooter(scaled_scene);
    for (int i = 0; i < 5; ++i) {
        const auto p = *rc::gen::arbitrary<Point3>();
        const auto q = *rc::gen::arbitrary<Point3>();
        if (p == q) continue;
        const bool free = shooter.is_free(p, q);
        RC_ASSERT(scaled_shooter.is_free(scaled(p), scaled(q)) == free);
        if (!free) continue;
        RC_ASSERT(scaled_shooter.first_faces(scaled(p), scaled(q)) == shooter.first_faces(p, q));
    }
}

TEST(SegmentShooterTier, CountsWhatItCut) {
    const Scene3 scene = testing::scene3("box 0 0 0, 4 4 4");
    SegmentShooter shooter(scene);
    EXPECT_FALSE(shooter.is_free(Point3{-1, 1, 1.5}, Point3{5, 2, 3}));
    EXPECT_EQ(shooter.counts(), (ShootingCounts{.shots = 1}));
    EXPECT_TRUE(shooter.is_free(Point3{-1, 1, 4}, Point3{5, 2, 4}));
    EXPECT_EQ(shooter.counts().shots, 2U);
    EXPECT_EQ(shooter.counts().cut_lines, 1U);
    EXPECT_GT(shooter.counts().unsure_triangles, 0U);
    SegmentShooter copy = shooter;
    EXPECT_FALSE(copy.is_free(Point3{-1, 1, 1.5}, Point3{5, 2, 3}));
    EXPECT_EQ(copy.counts().shots, 3U);
    EXPECT_EQ(shooter.counts().shots, 2U) << "copies are independent";
}

TEST(SegmentShooter, RefusesSegmentsThatAreAPoint) {
    const Scene3 scene = testing::scene3("box 0 0 0, 4 4 4");
    SegmentShooter shooter(scene);
    EXPECT_THROW(static_cast<void>(shooter.is_free(Point3{9, 9, 9}, Point3{9, 9, 9})),
                 ContractViolation);
    EXPECT_THROW(static_cast<void>(shooter.first_hit(to_rational(Point3{9, 9, 9}), Vector3{})),
                 ContractViolation);
}

}  // namespace
}  // namespace sightline
