// SPDX-License-Identifier: GPL-3.0-or-later
// Validity of 3D scenes against definitions that know nothing of surfaces: separating planes of convex sets, and
// the plane's own validation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "sightline/geom/predicates2.hpp"
#include "sightline/scene/scene2.hpp"
#include "sightline/scene/scene3.hpp"
#include "support/meshes.hpp"

namespace sightline {
namespace {

using Vector = std::array<long, 3>;
using Corners = std::vector<Vector>;

Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
long det(const Corners& c) { return dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]); }
Point3 point(const Vector& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

/// Whether a plane has one set on one closed side and the other on the other; the sets are convex, all their edges
/// run between corners.
bool are_separable(const Corners& a, const Corners& b) {
    std::vector<Vector> normals;
    const auto edges = [](const Corners& c) {
        std::vector<Vector> result;
        for (std::size_t i = 0; i < c.size(); ++i)
            for (std::size_t j = i + 1; j < c.size(); ++j) result.push_back(c[j] - c[i]);
        return result;
    };
    std::vector<Vector> all = edges(a);
    for (const Vector& e : edges(b)) all.push_back(e);
    for (const Vector& e : all)
        for (const Vector& f : all) normals.push_back(cross(e, f));
    for (const Vector& n : normals) {
        if (n == Vector{}) continue;
        const auto range = [&](const Corners& c) {
            std::vector<long> values;
            for (const Vector& v : c) values.push_back(dot(n, v));
            const auto [low, high] = std::minmax_element(values.begin(), values.end());
            return std::pair{*low, *high};
        };
        if (range(a).second <= range(b).first) return true;
    }
    return false;
}

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    long below(long n) { return static_cast<long>(engine_() % static_cast<unsigned long>(n)); }
    Vector vector(long n) { return {below(n), below(n), below(n)}; }
    /// A tetrahedron that looks outwards.
    Corners tetrahedron(long n) {
        for (;;) {
            Corners c{vector(n), vector(n), vector(n), vector(n)};
            if (det(c) > 0) std::swap(c[1], c[2]);
            if (det(c) < 0) return c;
        }
    }
    Corners triangle(long n) {
        for (;;) {
            Corners c{vector(n), vector(n), vector(n)};
            if (cross(c[1] - c[0], c[2] - c[0]) != Vector{}) return c;
        }
    }

private:
    std::mt19937 engine_;
};

MeshInput3 solid(const Corners& c) {
    return test::tetrahedron(point(c[0]), point(c[1]), point(c[2]), point(c[3]));
}
MeshInput3 sheet(const Corners& c) {
    return test::mesh_of({point(c[0]), point(c[1]), point(c[2])}, {{0, 1, 2}}, SurfaceKind::sheet);
}
std::string text(const Corners& c) {
    std::string result;
    for (const Vector& v : c)
        for (const long x : v) result += std::to_string(x) + " ";
    return result + "| ";
}

TEST(Scene3Differential, TwoTetrahedraAreValidWhenAPlaneSeparatesThem) {
    Random random(1);
    int valid = 0;
    for (int i = 0; i < 6000; ++i) {
        const long size = 3 + i % 4;
        const Corners a = random.tetrahedron(size);
        const Corners b = random.tetrahedron(size);
        const Result<Scene3> scene = test::make_scene3({solid(a), solid(b)});
        const bool expected = are_separable(a, b) || are_separable(b, a);
        ASSERT_EQ(scene.has_value(), expected)
            << text(a) << text(b) << (scene ? "" : scene.error().message);
        valid += expected ? 1 : 0;
    }
    EXPECT_GT(valid, 500);
}

TEST(Scene3Differential, ThreeTetrahedraAreValidWhenEachTwoAre) {
    Random random(2);
    int valid = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<Corners> all;
        for (int k = 0; k < 3; ++k) all.push_back(random.tetrahedron(3));
        bool expected = true;
        for (int k = 0; k < 3; ++k) {
            const Corners &a = all[std::size_t(k)], &b = all[std::size_t((k + 1) % 3)];
            expected = expected && (are_separable(a, b) || are_separable(b, a));
        }
        const Result<Scene3> scene =
            test::make_scene3({solid(all[0]), solid(all[1]), solid(all[2])});
        ASSERT_EQ(scene.has_value(), expected)
            << text(all[0]) << text(all[1]) << text(all[2]) << (scene ? "" : scene.error().message);
        valid += expected ? 1 : 0;
    }
    EXPECT_GT(valid, 20);
}

TEST(Scene3Differential, ASheetIsValidWhenItMeetsNoInterior) {
    Random random(3);
    int valid = 0;
    for (int i = 0; i < 6000; ++i) {
        const long size = 3 + i % 3;
        const Corners a = random.tetrahedron(size);
        const Corners b = random.triangle(size);
        const Result<Scene3> scene = test::make_scene3({solid(a), sheet(b)});
        const bool expected = are_separable(a, b) || are_separable(b, a);
        ASSERT_EQ(scene.has_value(), expected)
            << text(a) << text(b) << (scene ? "" : scene.error().message);
        valid += expected ? 1 : 0;
    }
    EXPECT_GT(valid, 500);
}

/// Where the triangle's inside is cut by the plane: the two ends along the direction, as fractions.
struct Cut {
    bool cuts = false;
    std::vector<Rational> ends;
};
Cut cut(const Corners& t, const Vector& normal, long offset, const Vector& direction) {
    std::array<long, 3> side{};
    for (std::size_t i = 0; i < 3; ++i) side[i] = dot(normal, t[i]) - offset;
    const auto [low, high] = std::minmax_element(side.begin(), side.end());
    Cut result;
    result.cuts = *low < 0 && *high > 0;
    if (!result.cuts) return result;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (side[i] == 0) result.ends.push_back(Rational(dot(direction, t[i])));
        if (side[i] * side[j] >= 0) continue;
        const Rational f = Rational(side[i]) / Rational(side[i] - side[j]);
        const Rational a(dot(direction, t[i])), b(dot(direction, t[j]));
        result.ends.push_back(a + f * (b - a));
    }
    std::sort(result.ends.begin(), result.ends.end());
    return result;
}
/// Whether the insides of two triangles cross in a segment.
bool cross_inside(const Corners& a, const Corners& b) {
    const Vector n = cross(a[1] - a[0], a[2] - a[0]);
    const Vector m = cross(b[1] - b[0], b[2] - b[0]);
    const Vector direction = cross(n, m);
    const Cut of_a = cut(a, m, dot(m, b[0]), direction);
    const Cut of_b = cut(b, n, dot(n, a[0]), direction);
    if (!of_a.cuts || !of_b.cuts) return false;
    return of_a.ends.front() < of_b.ends.back() && of_b.ends.front() < of_a.ends.back();
}

TEST(Scene3Differential, TwoSheetsAreValidWhenTheirInsidesDoNotCross) {
    Random random(4);
    int valid = 0;
    for (int i = 0; i < 6000; ++i) {
        const long size = 3 + i % 3;
        const Corners a = random.triangle(size);
        const Corners b = random.triangle(size);
        const bool expected = !cross_inside(a, b);
        const Result<Scene3> scene = test::make_scene3({sheet(a), sheet(b)});
        ASSERT_EQ(scene.has_value(), expected)
            << text(a) << text(b) << (scene ? "" : scene.error().message);
        valid += expected ? 1 : 0;
    }
    EXPECT_GT(valid, 3000);
    EXPECT_LT(valid, 5800);
}

TEST(Scene3Differential, PrismsAreValidWhenTheirBasesAre) {
    Random random(5);
    int valid = 0;
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<Point2> base;
        const long n = 4 + random.below(4);
        while (std::ssize(base) < n) {
            const Point2 p{double(random.below(5)), double(random.below(5))};
            if (std::find(base.begin(), base.end(), p) == base.end()) base.push_back(p);
        }
        double twice = 0;
        for (std::size_t k = 0; k < base.size(); ++k) {
            const Point2 &p = base[k], &q = base[(k + 1) % base.size()];
            twice += p.x * q.y - q.x * p.y;
        }
        if (twice < 0) std::reverse(base.begin(), base.end());
        SceneInput2 flat;
        flat.elements.emplace_back(Polygon2{base, {}});
        const Result<Scene2> plane = Scene2::make(flat);
        const Result<Scene3> space = test::make_scene3({test::prism(base, 0, 1)});
        // In the plane a ring may not run along itself; a solid may touch itself along a face.
        bool runs_along = false;
        for (std::size_t k = 0; k < base.size(); ++k)
            for (std::size_t l = 0; l < k; ++l)
                runs_along = runs_along || crossing({base[k], base[(k + 1) % base.size()]},
                                                    {base[l], base[(l + 1) % base.size()]}) ==
                                               SegmentCrossing::overlap;
        if (runs_along) continue;
        ++compared;
        std::string shown;
        for (const Point2& p : base)
            shown += std::to_string(int(p.x)) + std::to_string(int(p.y)) + " ";
        ASSERT_EQ(space.has_value(), plane.has_value())
            << shown << (plane ? space.error().message : plane.error().message);
        valid += space ? 1 : 0;
    }
    EXPECT_GT(valid, 1000);
    EXPECT_LT(valid, compared - 1000);
}

TEST(Scene3Exhaustive, BoxesOfTheSmallGridAreValidWhenTheirIntervalsAre) {
    std::vector<std::pair<int, int>> intervals{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {2, 3}};
    struct Box {
        std::array<std::pair<int, int>, 3> sides;
    };
    std::vector<Box> boxes;
    for (const auto& x : intervals)
        for (const auto& y : intervals)
            for (const auto& z : intervals) boxes.push_back({{x, y, z}});
    const auto mesh = [](const Box& b) {
        return test::box_mesh(
            {double(b.sides[0].first), double(b.sides[1].first), double(b.sides[2].first)},
            {double(b.sides[0].second), double(b.sides[1].second), double(b.sides[2].second)});
    };
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i; j < boxes.size(); ++j) {
            bool overlap = true;
            bool touch = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto &a = boxes[i].sides[k], &b = boxes[j].sides[k];
                overlap = overlap && a.first < b.second && b.first < a.second;
                touch = touch && a.first <= b.second && b.first <= a.second;
            }
            const Result<Scene3> scene = test::make_scene3({mesh(boxes[i]), mesh(boxes[j])});
            ASSERT_EQ(scene.has_value(), !overlap) << i << ' ' << j;
            if (!scene) continue;
            ASSERT_EQ(scene->has_touching_bodies(), touch) << i << ' ' << j;
        }
}

}  // namespace
}  // namespace sightline
