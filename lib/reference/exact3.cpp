// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact3.hpp"

#include <algorithm>

namespace sightline::reference::detail {
namespace {

RationalTriple exact(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

Plane scaled(const RationalTriple& normal, const Rational& offset) {
    for (const Rational& first : normal) {
        if (is_zero(first)) continue;
        return {times(1 / first, normal), offset / first};
    }
    return {};
}

// Where the relative interiors of two edges of different lines cross, appended if they do.
void add_crossing(const ExactEdge& a, const ExactEdge& b, std::vector<RationalTriple>& points) {
    if (!coplanar(a, b) || parallel(a, b)) return;
    const RationalTriple n = cross(cross(a.direction, b.direction), b.direction);
    const Rational at = dot(n, minus(b.source, a.source)) / dot(n, a.direction);
    const RationalTriple p = plus(a.source, times(at, a.direction));
    const Rational along_b = dot(b.direction, minus(p, b.source)) / dot(b.direction, b.direction);
    if (at > 0 && at < 1 && along_b > 0 && along_b < 1) points.push_back(p);
}

}  // namespace

Plane plane_of(const RationalTriple& p, const RationalTriple& u, const RationalTriple& v) {
    const RationalTriple normal = cross(u, v);
    return scaled(normal, dot(normal, p));
}

ExactEdge edge_between(const RationalTriple& source, const RationalTriple& target) {
    return {source, target, minus(target, source), cross(source, target)};
}

bool parallel(const ExactEdge& a, const ExactEdge& b) {
    return is_zero(cross(a.direction, b.direction));
}

bool coplanar(const ExactEdge& a, const ExactEdge& b) {
    return is_zero(dot(a.direction, b.moment) + dot(a.moment, b.direction));
}

bool collinear(const ExactEdge& a, const ExactEdge& b) {
    return parallel(a, b) && is_zero(cross(minus(b.source, a.source), a.direction));
}

Plane plane_of(const ExactEdge& a, const ExactEdge& b) {
    return plane_of(a.source, a.direction,
                    parallel(a, b) ? minus(b.source, a.source) : b.direction);
}

Plane plane_of(const RationalTriple& p, const ExactEdge& e) {
    return plane_of(p, minus(e.source, p), e.direction);
}

RationalTriple piercing_point(const Plane& plane, const ExactEdge& e) {
    const Rational at = -height(plane, e.source) / dot(plane.normal, e.direction);
    return plus(e.source, times(at, e.direction));
}

ExactScene::ExactScene(const Scene3& s) : scene(s) {
    for (const Point3& p : s.vertices()) vertices.push_back(exact(p));
    for (const Edge3& e : s.edges()) {
        edges.push_back(edge_between(vertices[e.source.index()], vertices[e.target.index()]));
    }
    for (const Face3& f : s.faces()) {
        const RationalTriple& a = vertices[f.plane[0].index()];
        normals.push_back(
            cross(minus(vertices[f.plane[1].index()], a), minus(vertices[f.plane[2].index()], a)));
        planes.push_back(scaled(normals.back(), dot(normals.back(), a)));
    }
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        if (s.is_feature(VertexId{v})) points.push_back(vertices[v]);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) add_crossing(edges[i], edges[j], points);
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace sightline::reference::detail
