// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting lines against the definition: supports and ends of all maximal free segments, on rational lines and on
// lines with coordinates in Q(√c).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "sightline/reference/free_segment3.hpp"
#include "spatial/line_cut.hpp"
#include "support/arbitrary3.hpp"
#include "support/corpus3.hpp"

namespace sightline {
namespace {

using detail::Integer;

/// A line of Q(√c) as the core wants it: integers, in the scene's scaled coordinates.
class Source final : public detail::LineSource {
public:
    Source(const SurdLine3& line, int scale_exponent) {
        const Surd scale(Rational(std::ldexp(1.0, scale_exponent)));
        const SurdLine3 scaled{scale * line.d, scale * scale * line.m};
        const auto coordinates = scaled.coordinates();
        Rational c;
        for (const Surd& x : coordinates) {
            if (!x.is_rational()) c = x.radicand();
        }
        std::array<Rational, 6> a;
        std::array<Rational, 6> b;
        Rational multiple(denominator_of(c));
        c = c * multiple * multiple;  // a whole number; b's are divided by the same
        for (std::size_t i = 0; i < 6; ++i) {
            a[i] = coordinates[i].rational_part();
            if (!coordinates[i].is_rational()) {
                b[i] = *rational_square_root(coordinates[i].radicand() / c);
                if (coordinates[i].root_sign() == Sign::negative) b[i] = -b[i];
            }
            multiple = multiple * denominator_of(a[i]) * denominator_of(b[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            exact_.a.d[i] = whole(multiple * a[i]);
            exact_.a.m[i] = whole(multiple * a[i + 3]);
            exact_.b.d[i] = whole(multiple * b[i]);
            exact_.b.m[i] = whole(multiple * b[i + 3]);
        }
        exact_.c = whole(c);
    }

    [[nodiscard]] detail::ExactLine exact_line() const override { return exact_; }

private:
    static Integer whole(const Rational& x) { return Integer(numerator_of(x).to_string()); }
    detail::ExactLine exact_;
};

detail::Real real_of(const Surd& x) {
    const Interval hull = enclosure(x);
    return hull.is_point() ? detail::Real(hull.lower)
                           : detail::Real(hull.lower, 2 * (hull.upper - hull.lower));
}
detail::Vec3<detail::Real> real_of(const SurdVector3& v) {
    return {real_of(v.x), real_of(v.y), real_of(v.z)};
}

std::vector<SegmentLabel> by_cutting(const detail::SceneForms& forms, const SurdLine3& line,
                                     Arithmetic arithmetic) {
    const Source source(line, forms.scale_exponent());
    const detail::Policy policy{arithmetic, nullptr};
    const detail::Line cut_line({real_of(line.d), real_of(line.m)}, source, policy);
    detail::LineCut cut(forms);
    cut.cut(cut_line);
    std::vector<SegmentLabel> result;
    for (const auto& run : cut.runs()) result.push_back(cut.label(run));
    std::ranges::sort(result);
    return result;
}

std::vector<SegmentLabel> by_definition(const Scene3& scene, const SurdLine3& line) {
    auto result = reference::maximal_segments(scene, line);
    for (SegmentLabel& label : result) std::ranges::sort(label.ends);
    std::ranges::sort(result);
    return result;
}

RationalPoint3 lattice_point() {
    const auto half = [] { return Rational(*rc::gen::inRange(-2, 14), 2); };
    const Rational x = half();
    const Rational y = half();
    return {x, y, half()};
}

RC_GTEST_PROP(LineCutLaw, LabelsOfRationalLinesAreThoseOfTheDefinition,
              (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const detail::SceneForms forms(scene);
    for (int i = 0; i < 8; ++i) {
        const RationalPoint3 p = lattice_point();
        const RationalPoint3 q = lattice_point();
        if (p == q) continue;
        const SurdLine3 line = to_surd(line_through(p, q));
        const auto expected = by_definition(scene, line);
        RC_ASSERT(by_cutting(forms, line, Arithmetic::filtered) == expected);
        RC_ASSERT(by_cutting(forms, line, Arithmetic::exact) == expected);
    }
}

RC_GTEST_PROP(LineCutLaw, LabelsOfIrrationalLinesAreThoseOfTheDefinition,
              (const SceneInput3& input)) {
    const Scene3 scene = testing::scene3(input);
    const detail::SceneForms forms(scene);
    const Surd root = Surd::square_root(*rc::gen::element(2, 3, 5));
    for (int i = 0; i < 5; ++i) {
        // From a lattice point, in the plane of two lattice directions: through features' points at times.
        const auto vector = [] { return to_surd(vector_to(lattice_point())); };
        const SurdVector3 p = vector();
        const SurdVector3 d = vector() - p + root * (vector() - p);
        if (d.is_zero()) continue;
        const SurdLine3 line{d, cross(p, d)};
        const auto expected = by_definition(scene, line);
        RC_ASSERT(by_cutting(forms, line, Arithmetic::filtered) == expected);
        RC_ASSERT(by_cutting(forms, line, Arithmetic::exact) == expected);
    }
}

class EveryCorpusSceneCut3 : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryCorpusSceneCut3, LinesBetweenItsVerticesAreCutByDefinition) {
    const Scene3 scene = testing::degenerate_scene3(GetParam());
    const detail::SceneForms forms(scene);
    const auto vertices = scene.vertices();
    // Some pairs: the definition takes its time.
    const std::size_t step = 1 + vertices.size() * vertices.size() / 25;
    for (std::size_t k = 0; k < vertices.size() * vertices.size(); k += step) {
        const Point3& p = vertices[k / vertices.size()];
        const Point3& q = vertices[k % vertices.size()];
        if (p == q) continue;
        const SurdLine3 line = to_surd(line_through(to_rational(p), to_rational(q)));
        EXPECT_EQ(by_cutting(forms, line, Arithmetic::filtered), by_definition(scene, line))
            << p << ' ' << q;
    }
}

INSTANTIATE_TEST_SUITE_P(LineCut, EveryCorpusSceneCut3, ::testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, text] : testing::degenerate_scenes3()) {
                                 names.push_back(name);
                             }
                             return names;
                         }()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace sightline
