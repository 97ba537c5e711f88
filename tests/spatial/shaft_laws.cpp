// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sightline/spatial/box_tests.hpp"
#include "sightline/spatial/shaft.hpp"

namespace sightline {
namespace {

using Vec = std::array<Rational, 3>;

Vec rational(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator*(const Rational& k, const Vec& v) { return {k * v[0], k * v[1], k * v[2]}; }
Rational dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool contains(const Box3& box, const Vec& x) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (x[i] < Rational(box.low[i]) || Rational(box.high[i]) < x[i]) return false;
    }
    return true;
}
Interval interval_of(const Rational& x) { return enclosure(x); }
std::array<Interval, 3> intervals_of(const Vec& v) {
    return {interval_of(v[0]), interval_of(v[1]), interval_of(v[2])};
}

/// Numbers of one of three kinds: small integers (degenerate cases), 53 random bits, or such numbers
/// far from the origin (rounding is at its worst).
class Numbers {
public:
    Numbers(std::uint64_t seed, unsigned kind) : random_(seed), kind_(kind % 3) {}
    double operator()() {
        if (kind_ == 0) return static_cast<double>(random_() % 7);
        const double x = std::ldexp(static_cast<double>(random_() >> 11), -50);
        return kind_ == 1 ? x : 1e9 + x;
    }
    Point3 point() { return {(*this)(), (*this)(), (*this)()}; }
    Box3 box() { return Box3::of(point(), point()); }
    Rational share() { return Rational(static_cast<int>(random_() % 9), 8); }
    std::size_t below(std::size_t n) { return random_() % n; }
    Convex3 convex() {
        switch (below(4)) {
            case 0:
                return Convex3(point());
            case 1:
                return Convex3(point(), point());
            case 2:
                return Convex3(point(), point(), point());
            default:
                return Convex3(box());
        }
    }
    /// A point of the set, most often on its border.
    Vec point_of(const Convex3& set) {
        Vec sum = rational(set.corners()[0]);
        for (const Point3& p : set.corners()) sum = sum + share() * (rational(p) - sum);
        return sum;
    }
    /// A box that has x on its border or inside, by a little.
    Box3 box_at(const Vec& x) {
        Box3 box;
        for (std::size_t i = 0; i < 3; ++i) {
            const Interval hull = enclosure(x[i]);
            box.low[i] = below(2) == 0 ? hull.lower : hull.lower - std::abs((*this)());
            box.high[i] = below(2) == 0 ? hull.upper : hull.upper + std::abs((*this)());
        }
        return box;
    }

private:
    std::mt19937_64 random_;
    unsigned kind_;
};

Numbers arbitrary_numbers() {
    return {*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(0U, 3U)};
}

RC_GTEST_PROP(ShaftLaw, NeverMissesWhatASegmentBetweenTheSetsMeets, ()) {
    Numbers numbers = arbitrary_numbers();
    const Convex3 from = numbers.convex();
    const Convex3 to = numbers.convex();
    const Shaft shaft(from, to);
    for (int i = 0; i < 10; ++i) {
        const Vec p = numbers.point_of(from);
        const Vec x = p + numbers.share() * (numbers.point_of(to) - p);
        const Box3 box = numbers.box_at(x);
        RC_ASSERT(contains(box, x));
        RC_ASSERT(shaft.may_meet(box));
        std::vector<Point3> corners;
        for (unsigned c = 0; c < 8; ++c) corners.push_back(box.corner(c));
        RC_ASSERT(shaft.may_meet(corners));
    }
}

/// By a linear program small enough to be solved by trying all bases: whether some plane with a normal
/// among `normals` has all of P on one side and the box strictly on the other.
bool is_separated(const std::vector<Vec>& normals, const std::vector<Vec>& p, const Box3& box) {
    for (const Vec& n : normals) {
        Rational p_high = dot(n, p[0]);
        Rational p_low = p_high;
        for (const Vec& x : p) {
            p_high = std::max(p_high, dot(n, x));
            p_low = std::min(p_low, dot(n, x));
        }
        Rational box_high = dot(n, rational(box.corner(0)));
        Rational box_low = box_high;
        for (unsigned c = 1; c < 8; ++c) {
            box_high = std::max(box_high, dot(n, rational(box.corner(c))));
            box_low = std::min(box_low, dot(n, rational(box.corner(c))));
        }
        if (p_high < box_low || box_high < p_low) return true;
    }
    return false;
}

// The separating directions of two convex polytopes: normals of facets, and products of edges.
bool hull_meets(const std::vector<Vec>& p, const Box3& box) {
    std::vector<Vec> normals;
    const Vec axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vec& e : axes) normals.push_back(e);
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = i + 1; j < p.size(); ++j) {
            for (const Vec& e : axes) normals.push_back(cross(p[j] - p[i], e));
            for (std::size_t k = j + 1; k < p.size(); ++k) {
                normals.push_back(cross(p[j] - p[i], p[k] - p[i]));
            }
        }
    }
    return !is_separated(normals, p, box);
}

RC_GTEST_PROP(ShaftLaw, OnIntegersIsExactUpToContact, ()) {
    Numbers numbers(*rc::gen::arbitrary<std::uint64_t>(), 0);
    const Convex3 from = numbers.convex();
    const Convex3 to = numbers.convex();
    if (from.corners().size() + to.corners().size() > 9) return;  // the oracle is slow
    const Shaft shaft(from, to);
    std::vector<Vec> hull;
    for (const Convex3* set : {&from, &to}) {
        for (const Point3& p : set->corners()) hull.push_back(rational(p));
    }
    for (int i = 0; i < 10; ++i) {
        const Box3 box = numbers.box();
        RC_ASSERT(shaft.may_meet(box) == hull_meets(hull, box));
    }
}

TEST(Shaft, BetweenTwoBoxesCutsTheCornersOff) {
    const Convex3 low(Box3::of({0, 0, 0}, {1, 1, 1}));
    const Convex3 high(Box3::of({9, 9, 9}, {10, 10, 10}));
    const Shaft shaft(low, high);
    EXPECT_EQ(shaft.plane_count(), 6U) << "two planes parallel to each axis";
    EXPECT_TRUE(shaft.may_meet(Box3::of({5, 5, 5})));
    EXPECT_FALSE(shaft.may_meet(Box3::of({5, 5, 7}))) << "in the bounds, not in the shaft";
    EXPECT_FALSE(shaft.may_meet(Box3::of({7, 0, 0}, {10, 3, 3})));
    EXPECT_TRUE(shaft.may_meet(Box3::of({5, 5, 6}))) << "contact counts";
}

TEST(Shaft, OfTwoSegmentsIsATetrahedron) {
    const Shaft shaft(Convex3({0, 0, 0}, {4, 0, 0}), Convex3({0, 0, 4}, {0, 4, 4}));
    EXPECT_TRUE(shaft.may_meet(Point3{1, 1, 2}));
    EXPECT_FALSE(shaft.may_meet(Point3{3, 1, 2}));
    EXPECT_FALSE(shaft.may_meet(std::vector<Point3>{{3, 1, 2}, {3, 3, 2}, {2.5, 0, 2.5}}));
}

TEST(ShaftDegenerate, OfTwoPointsIsTheirSegment) {
    const Shaft shaft(Convex3(Point3{0, 0, 0}), Convex3(Point3{4, 4, 4}));
    EXPECT_TRUE(shaft.may_meet(Box3::of({1, 1, 1})));
    EXPECT_FALSE(shaft.may_meet(Box3::of({1, 1, 2}, {2, 1.5, 3})));
}

// ---- boxes against loci --------------------------------------------------------------------------

RC_GTEST_PROP(BoxTestLaw, ABoxAtAPointOfALineMayMeetIt, ()) {
    Numbers numbers = arbitrary_numbers();
    const Vec p = rational(numbers.point());
    const Vec q = rational(numbers.point());
    const Vec d = q - p;
    const LineBounds3 line{intervals_of(d), intervals_of(cross(p, d))};
    const Rational t = Rational(16) * (numbers.share() - Rational(1, 2));
    RC_ASSERT(may_meet(numbers.box_at(p + t * d), line));
}

RC_GTEST_PROP(BoxTestLaw, OnIntegersALineIsMetExactly, ()) {
    Numbers numbers(*rc::gen::arbitrary<std::uint64_t>(), 0);
    const Vec p = rational(numbers.point());
    const Vec d = rational(numbers.point()) - p;
    const Box3 box = numbers.box();
    const LineBounds3 line{intervals_of(d), intervals_of(cross(p, d))};
    // A piece of the line that is longer than what boxes of these numbers contain.
    const std::vector<Vec> piece{p - Rational(10) * d, p + Rational(10) * d};
    RC_PRE(d != Vec{});
    RC_ASSERT(may_meet(box, line) == hull_meets(piece, box));
}

RC_GTEST_PROP(BoxTestLaw, ABoxAtAPointOfATriangleMayMeetIt, ()) {
    Numbers numbers = arbitrary_numbers();
    const Point3 a = numbers.point();
    const Point3 b = numbers.point();
    const Point3 c = numbers.point();
    const Vec x = numbers.point_of(Convex3(a, b, c));
    RC_ASSERT(may_meet(numbers.box_at(x), a, b, c));
}

RC_GTEST_PROP(BoxTestLaw, OnIntegersATriangleIsMetExactly, ()) {
    Numbers numbers(*rc::gen::arbitrary<std::uint64_t>(), 0);
    const Point3 a = numbers.point();
    const Point3 b = numbers.point();
    const Point3 c = numbers.point();
    const Box3 box = numbers.box();
    RC_ASSERT(may_meet(box, a, b, c) == hull_meets({rational(a), rational(b), rational(c)}, box));
}

RC_GTEST_PROP(BoxTestLaw, ABoxAtAPointOfAPlaneMayMeetIt, ()) {
    Numbers numbers = arbitrary_numbers();
    const Vec p = rational(numbers.point());
    const Vec u = rational(numbers.point()) - p;
    const Vec v = rational(numbers.point()) - p;
    const Vec n = cross(u, v);
    const PlaneBounds3 plane{intervals_of(n), interval_of(dot(n, p))};
    const Vec x = p + Rational(4) * numbers.share() * u - Rational(3) * numbers.share() * v;
    RC_ASSERT(may_meet(numbers.box_at(x), plane));
}

RC_GTEST_PROP(BoxTestLaw, ABoxAtAPointOfAWedgeMayMeetIt, ()) {
    Numbers numbers = arbitrary_numbers();
    const Wedge3 wedge{numbers.point(), numbers.point(), numbers.point()};
    const Vec apex = rational(wedge.apex);
    const Vec on_edge = numbers.point_of(Convex3(wedge.a, wedge.b));
    const Rational t = Rational(16) * (numbers.share() - Rational(1, 2));
    RC_ASSERT(may_meet(numbers.box_at(apex + t * (on_edge - apex)), wedge));
}

RC_GTEST_PROP(BoxTestLaw, OnIntegersAWedgeIsMetExactly, ()) {
    Numbers numbers(*rc::gen::arbitrary<std::uint64_t>(), 0);
    const Wedge3 wedge{numbers.point(), numbers.point(), numbers.point()};
    const Vec apex = rational(wedge.apex);
    const Vec a = rational(wedge.a) - apex;
    const Vec b = rational(wedge.b) - apex;
    const Vec none{};
    RC_PRE(cross(a, b) != none);
    // Far enough: with integers below 7, a triangle of this size holds all of the cone within reach.
    const Rational far(10000);
    const Box3 box = numbers.box();
    const bool meets = hull_meets({apex, apex + far * a, apex + far * b}, box) ||
                       hull_meets({apex, apex - far * a, apex - far * b}, box);
    RC_ASSERT(may_meet(box, wedge) == meets);
}

RC_GTEST_PROP(BoxTestLaw, ABoxAtAPointOfAQuadricMayMeetIt, ()) {
    Numbers numbers = arbitrary_numbers();
    QuadricBounds3 q{};
    std::array<Rational, 9> k;
    for (Rational& x : k) x = Rational(numbers() - numbers());
    const Vec x = rational(numbers.point());
    Rational constant;
    for (std::size_t i = 0; i < 3; ++i) {
        q.square[i] = interval_of(k[i]);
        q.mixed[i] = interval_of(k[3 + i]);
        q.linear[i] = interval_of(k[6 + i]);
        constant -=
            k[i] * x[i] * x[i] + k[3 + i] * x[(i + 1) % 3] * x[(i + 2) % 3] + k[6 + i] * x[i];
    }
    q.constant = interval_of(constant);
    RC_ASSERT(may_meet(numbers.box_at(x), q));
}

TEST(BoxTest, ASphereLeavesOutWhatIsFarInsideAndOutside) {
    QuadricBounds3 sphere{};
    sphere.square = {Interval{1, 1}, Interval{1, 1}, Interval{1, 1}};
    sphere.constant = {-100, -100};
    EXPECT_FALSE(may_meet(Box3::of({-1, -1, -1}, {1, 1, 1}), sphere));
    EXPECT_FALSE(may_meet(Box3::of({8, 8, 8}, {9, 9, 9}), sphere));
    EXPECT_TRUE(may_meet(Box3::of({9, 0, 0}, {11, 1, 1}), sphere));
    sphere.constant = {-200, -100};
    EXPECT_TRUE(may_meet(Box3::of({8, 8, 8}, {9, 9, 9}), sphere)) << "some sphere of those meant";
}

TEST(BoxTest, AWedgeLeavesOutItsSides) {
    const Wedge3 wedge{{0, 0, 0}, {2, 1, 0}, {2, -1, 0}};
    EXPECT_TRUE(may_meet(Box3::of({20, 9, -1}, {21, 9.5, 1}), wedge));
    EXPECT_TRUE(may_meet(Box3::of({-21, 9, -1}, {-20, 9.5, 1}), wedge)) << "lines go both ways";
    EXPECT_FALSE(may_meet(Box3::of({0, 9, -1}, {1, 9.5, 1}), wedge));
    EXPECT_FALSE(may_meet(Box3::of({20, 9, 1}, {21, 9.5, 2}), wedge));
}

}  // namespace
}  // namespace sightline
