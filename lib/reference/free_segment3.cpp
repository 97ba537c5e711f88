// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/free_segment3.hpp"

#include "reference/line_cut3.hpp"
#include "sightline/scene/result.hpp"

namespace sightline::reference {
namespace {

template <typename Number>
std::vector<SegmentLabel> labels(const ExactTriangles& exact, const BasicLine3<Number>& line) {
    SIGHTLINE_EXPECT(line.is_line());
    const Number size = dot(line.d, line.d);
    const BasicVector3<Number> foot = (Number(1) / size) * cross(line.d, line.m);
    const LineCut3<Number> cut(exact, foot, line.d, {});
    std::vector<SegmentLabel> result;
    for (const auto& segment : cut.maximal_segments()) {
        result.push_back({cut.support(segment), {segment.from.faces, segment.to.faces}});
    }
    return result;
}

}  // namespace

bool is_interior(const Scene3& scene, const RationalPoint3& x) {
    const ExactTriangles exact(scene);
    return picture_at(exact, vector_to(x), false).is_interior();
}

bool is_free(const Scene3& scene, const RationalPoint3& p, const RationalPoint3& q) {
    if (p == q) return !is_interior(scene, p);
    const ExactTriangles exact(scene);
    const LineCut3<Rational> cut(exact, vector_to(p), q - p, {Rational(0), Rational(1)});
    return cut.is_free(cut.index_of(Rational(0)), cut.index_of(Rational(1)));
}

FreeEnd3 first_hit(const Scene3& scene, const RationalPoint3& p, const Vector3& direction) {
    SIGHTLINE_EXPECT(!direction.is_zero());
    const ExactTriangles exact(scene);
    const LineCut3<Rational> cut(exact, vector_to(p), direction, {Rational(0)});
    const auto stop = cut.stop_after(cut.index_of(Rational(0)));
    if (!stop.at) return {};
    return {p + cut.parameters()[*stop.at] * direction, stop.faces};
}

std::vector<SegmentLabel> maximal_segments(const Scene3& scene, const RationalLine3& line) {
    return labels(ExactTriangles(scene), line);
}

std::vector<SegmentLabel> maximal_segments(const Scene3& scene, const SurdLine3& line) {
    return labels(ExactTriangles(scene), line);
}

}  // namespace sightline::reference
