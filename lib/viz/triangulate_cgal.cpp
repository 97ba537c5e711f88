// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "viz/triangulate.hpp"

namespace sightline::viz::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// Rings of views have rounded corners and may cross by an ulp: crossings are allowed, and
// approximate.
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;

constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();

/// Exponent of the largest coordinate: divided by it, no product of coordinates overflows.
int exponent_of(const Polygon& polygon) {
    double largest = 0;
    const auto look = [&](const std::vector<Position>& ring) {
        for (const Position& p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    };
    look(polygon.outer);
    std::ranges::for_each(polygon.holes, look);
    int exponent = 0;
    std::frexp(largest, &exponent);
    return exponent;
}

void insert(Triangulation& triangulation, const std::vector<Position>& ring, int exponent) {
    std::vector<Triangulation::Vertex_handle> corners;
    Triangulation::Face_handle near;
    for (const Position& p : ring) {
        corners.push_back(triangulation.insert(
            Kernel::Point_2(std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent)), near));
        near = corners.back()->face();
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto next = corners[(i + 1) % corners.size()];
        if (corners[i] != next) triangulation.insert_constraint(corners[i], next);
    }
}

/// Marks each face as inside or outside, from infinity inwards: an edge that an odd number of ring
/// edges cover separates.
void mark_faces(Triangulation& triangulation) {
    for (const auto face : triangulation.all_face_handles()) face->info().reset();
    std::vector<Triangulation::Face_handle> waiting{triangulation.infinite_face()};
    waiting.back()->info() = false;
    while (!waiting.empty()) {
        const auto face = waiting.back();
        waiting.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto other = face->neighbor(i);
            if (other->info().has_value()) continue;
            bool crossed = false;
            if (face->is_constrained(i)) {
                const auto a = face->vertex(Triangulation::cw(i));
                const auto b = face->vertex(Triangulation::ccw(i));
                crossed = triangulation.number_of_enclosing_constraints(a, b) % 2 == 1;
            }
            other->info() = *face->info() != crossed;
            waiting.push_back(other);
        }
    }
}

}  // namespace

Triangles triangulate(const Polygon& polygon) {
    Triangles result;
    Triangulation triangulation;
    const int exponent = exponent_of(polygon);
    insert(triangulation, polygon.outer, exponent);
    for (const auto& hole : polygon.holes) insert(triangulation, hole, exponent);
    if (triangulation.dimension() < 2) return result;

    mark_faces(triangulation);
    for (const auto vertex : triangulation.finite_vertex_handles()) vertex->info() = unnumbered;
    for (const auto face : triangulation.finite_face_handles()) {
        if (!*face->info()) continue;
        std::array<std::uint32_t, 3> corners{};
        for (int i = 0; i < 3; ++i) {
            const auto vertex = face->vertex(i);
            if (vertex->info() == unnumbered) {
                vertex->info() = static_cast<std::uint32_t>(result.points.size());
                result.points.push_back({std::ldexp(vertex->point().x(), exponent),
                                         std::ldexp(vertex->point().y(), exponent), 0});
            }
            corners[static_cast<std::size_t>(i)] = vertex->info();
        }
        result.triangles.push_back(corners);
    }
    return result;
}

}  // namespace sightline::viz::detail
