// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/cell3.hpp"

#include <algorithm>
#include <set>

#include "reference/common_transversals3.hpp"

namespace sightline::reference::detail {
namespace {

// Where a place fixes a point of the line, if it does.
std::optional<RationalTriple> fixed_point(const ExactScene& scene, const Place& place) {
    if (!place.vertices.empty()) return scene.vertices[place.vertices.front().index()];
    const ExactEdge& first = scene.edges[place.edges.front().index()];
    for (const EdgeId e : place.edges) {
        const ExactEdge& other = scene.edges[e.index()];
        if (collinear(first, other)) continue;
        // Any plane through `other` without `first` cuts `first` where the two cross.
        const RationalTriple normal =
            cross(other.direction, cross(first.direction, other.direction));
        return piercing_point({normal, dot(normal, other.source)}, first);
    }
    return std::nullopt;
}

// The conditions of a cell: points of the line, and lines that it meets elsewhere.
struct Conditions {
    std::vector<RationalTriple> points;
    std::vector<const ExactEdge*> edges;
};

Conditions conditions(const ExactScene& scene, const Cell& cell) {
    Conditions result;
    for (const Place& place : cell.places) {
        if (auto p = fixed_point(scene, place)) {
            result.points.push_back(std::move(*p));
        } else {
            result.edges.push_back(&scene.edges[place.edges.front().index()]);
        }
    }
    return result;
}

// The planes in which the conditions keep the line.
std::set<Plane> planes(const ExactScene& scene, const Cell& cell, const Conditions& given) {
    std::set<Plane> result;
    for (const FaceId f : cell.contact) result.insert(scene.planes[f.index()]);
    for (std::size_t i = 0; i < given.edges.size(); ++i) {
        if (!given.points.empty()) {
            result.insert(plane_of(given.points.front(), *given.edges[i]));
            continue;
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (coplanar(*given.edges[i], *given.edges[j])) {
                result.insert(plane_of(*given.edges[i], *given.edges[j]));
            }
        }
    }
    return result;
}

// Lines in a plane, through the points and the edges that are not in it.
Freedom freedom_in(const Plane& plane, const Conditions& given) {
    std::set<RationalTriple> points(given.points.begin(), given.points.end());
    for (const ExactEdge* e : given.edges) {
        if (!is_zero(dot(plane.normal, e->direction))) points.insert(piercing_point(plane, *e));
    }
    if (points.empty()) return {2, {}};
    if (points.size() > 1) return {0, {}};
    return {1, Freedom::Pencil{*points.begin(), plane}};
}

bool lies_in(const ExactLine& line, const Plane& plane) {
    return is_zero(dot(to_surd(plane.normal), line.direction)) &&
           dot(to_surd(plane.normal), line.base) == plane.offset;
}

// The faces of which the segment touches a vertex or two edges.
std::vector<FaceId> touched_faces(const ExactScene& scene, const Cell& cell) {
    std::vector<FaceId> result;
    const Support& support = cell.label.support;
    for (std::uint32_t i = 0; i < scene.planes.size(); ++i) {
        const FaceId face{i};
        const bool has_vertex = std::ranges::any_of(scene.scene[face].rings, [&](const auto& ring) {
            return std::ranges::any_of(
                ring, [&](VertexId v) { return std::ranges::binary_search(support.vertices, v); });
        });
        std::ptrdiff_t edges = 0;
        for (const auto* some : {&support.edges, &support.along}) {
            edges += std::ranges::count_if(*some, [&](EdgeId e) {
                return std::ranges::count(scene.scene[e].faces, face) > 0;
            });
        }
        if (has_vertex || edges > 1) result.push_back(face);
    }
    return result;
}

}  // namespace

Freedom freedom(const ExactScene& scene, const Cell& cell) {
    if (!cell.label.support.along.empty()) return {0, {}};
    const Conditions given = conditions(scene, cell);
    if (given.points.size() > 1) return {0, {}};
    const std::set<Plane> in = planes(scene, cell, given);
    if (in.size() > 1) return {0, {}};
    if (in.size() == 1) return freedom_in(*in.begin(), given);
    if (given.points.size() == 1) return {2, {}};
    // Lines of which no two meet.
    const int skew = static_cast<int>(given.edges.size());
    if (skew <= 3) return {4 - skew, {}};
    return {rank(given.edges) == 3 ? 1 : 0, {}};
}

std::vector<FaceId> faces_in_plane(const ExactScene& scene, const Cell& cell,
                                   const ExactLine& line) {
    auto faces = touched_faces(scene, cell);
    std::erase_if(faces, [&](FaceId f) { return !lies_in(line, scene.planes[f.index()]); });
    return faces;
}

NodeType node_type(const ExactScene& scene, const Cell& cell, const ExactLine& line) {
    const Conditions given = conditions(scene, cell);
    if (given.points.size() > 1) return NodeType::vv;
    std::set<Plane> planes;  // coplanar faces fix no more than one of them
    for (const FaceId f : faces_in_plane(scene, cell, line)) {
        planes.insert(scene.planes[f.index()]);
    }
    if (given.points.size() == 1) return planes.empty() ? NodeType::vee : NodeType::fve;
    if (planes.empty()) return NodeType::eeee;
    return planes.size() > 1 ? NodeType::ff : NodeType::fee;
}

ArcType arc_type(const ExactScene& scene, const Cell& cell, const Freedom& freedom) {
    if (!freedom.pencil) return ArcType::eee;
    const auto faces = touched_faces(scene, cell);
    const bool in_face = std::ranges::any_of(
        faces, [&](FaceId f) { return scene.planes[f.index()] == freedom.pencil->plane; });
    if (conditions(scene, cell).points.empty()) return in_face ? ArcType::fe : ArcType::eee;
    return in_face ? ArcType::fv : ArcType::ev;
}

Root root_of(const ExactScene& scene, const Cell& cell, const ExactLine& line) {
    const Conditions given = conditions(scene, cell);
    if (!given.points.empty() || !planes(scene, cell, given).empty()) return Root::only;
    const auto lines = common_transversals(given.edges);
    if (lines.size() < 2) return Root::only;
    const PluckerVector here = plucker_vector(line);
    SIGHTLINE_EXPECT(lines[0] == here || lines[1] == here);
    return lines[0] == here ? Root::first : Root::second;
}

}  // namespace sightline::reference::detail
