// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>

#include "scene/features3.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// Constraints may touch in vertices only; where they cross CGAL throws, and nothing is constructed.
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using Cell = Triangulation::Face_handle;

/// One face as a planar triangulation. Seen from the front or mirrored, as the dropped axis has it; `facing`
/// says which.
class FaceTriangulation {
public:
    FaceTriangulation(const std::vector<Point3>& vertices, const Face3& face)
        : vertices_(vertices),
          face_(face),
          plane_(Plane3::through(at(face.plane[0]), at(face.plane[1]), at(face.plane[2]))) {}

    std::vector<std::array<VertexId, 3>> run() {
        try {
            insert_rings();
        } catch (const Triangulation::Intersection_of_constraints_exception&) {
            return {};
        }
        if (!is_region_) return {};
        for (const Cell cell : planar_.all_face_handles()) cell->info() = false;
        for (const auto& ring : face_.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                fill_along(handles_.at(ring[i]), handles_.at(ring[(i + 1) % ring.size()]));
        if (!is_region_) return {};
        for (const auto& [piece, outside] : outsides_)
            if (outside->info() && !outsides_.contains({piece.second, piece.first})) return {};
        return collect();
    }

private:
    [[nodiscard]] const Point3& at(VertexId v) const { return vertices_[v.index()]; }
    [[nodiscard]] Point2 flat(VertexId v) const { return drop(at(v), plane_.axis); }

    void insert_rings() {
        for (const auto& ring : face_.rings) {
            for (const VertexId v : ring) {
                const Point2 p = flat(v);
                if (handles_.contains(v)) continue;
                const auto before = planar_.number_of_vertices();
                const Vertex handle = planar_.insert(Kernel::Point_2(p.x, p.y));
                // Faces that are not planar may have two vertices at one place of the picture.
                if (planar_.number_of_vertices() == before) is_region_ = false;
                handle->info() = v.value;
                handles_.emplace(v, handle);
            }
        }
        if (!is_region_) return;
        for (const auto& ring : face_.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                planar_.insert_constraint(handles_.at(ring[i]),
                                          handles_.at(ring[(i + 1) % ring.size()]));
    }

    /// Fills what is on the inner side of the constraint a → b, which other vertices may have cut.
    void fill_along(Vertex a, const Vertex b) {
        const Point2 end = flat(VertexId{b->info()});
        while (a != b) {
            const Vertex next = next_towards(a, end);
            Cell cell;
            int index = 0;
            const bool found = planar_.is_edge(a, next, cell, index);
            SIGHTLINE_EXPECT(found);
            // The cell on the left of a → next, or on its right when the picture is mirrored.
            const bool is_left = cell->vertex(Triangulation::cw(index)) == next;
            Cell outside = cell->neighbor(index);
            if (is_left != (plane_.facing == Sign::positive)) std::swap(cell, outside);
            outsides_.emplace(std::pair{a->info(), next->info()}, outside);
            fill(cell);
            a = next;
        }
    }

    [[nodiscard]] Vertex next_towards(const Vertex a, const Point2& end) const {
        const Point2 start = flat(VertexId{a->info()});
        auto around = planar_.incident_vertices(a);
        const auto first = around;
        do {
            if (planar_.is_infinite(around)) continue;
            const Vertex candidate = around;
            const Point2 p = flat(VertexId{candidate->info()});
            if (p == end || (orientation(start, end, p) == Sign::zero &&
                             order_along(start, end, start, p) == Sign::negative))
                return candidate;
        } while (++around != first);
        SIGHTLINE_EXPECT(!"an inserted constraint starts with an edge");
        return a;
    }

    void fill(Cell seed) {
        std::vector<Cell> stack{seed};
        while (!stack.empty()) {
            const Cell cell = stack.back();
            stack.pop_back();
            if (planar_.is_infinite(cell)) is_region_ = false;
            if (planar_.is_infinite(cell) || cell->info()) continue;
            cell->info() = true;
            for (int i = 0; i < 3; ++i)
                if (!cell->is_constrained(i)) stack.push_back(cell->neighbor(i));
        }
    }

    [[nodiscard]] std::vector<std::array<VertexId, 3>> collect() const {
        std::vector<std::array<VertexId, 3>> triangles;
        for (const Cell cell : planar_.finite_face_handles()) {
            if (!cell->info()) continue;
            std::array<VertexId, 3> corners{VertexId{cell->vertex(0)->info()},
                                            VertexId{cell->vertex(1)->info()},
                                            VertexId{cell->vertex(2)->info()}};
            if (plane_.facing == Sign::negative) std::swap(corners[1], corners[2]);
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                        corners.end());
            triangles.push_back(corners);
        }
        std::sort(triangles.begin(), triangles.end());
        return triangles;
    }

    const std::vector<Point3>& vertices_;
    const Face3& face_;
    Plane3 plane_;
    Triangulation planar_;
    std::map<VertexId, Vertex> handles_;
    bool is_region_ = true;  ///< places are distinct, and nothing reached infinity
    /// A piece of a ring: the cell on its outer side. Only slits have both directions.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Cell> outsides_;
};

}  // namespace

std::vector<std::array<VertexId, 3>> triangulate(const std::vector<Point3>& vertices,
                                                 const Face3& face) {
    if (face.rings.size() == 1 && face.rings[0].size() == 3) {
        const auto& ring = face.rings[0];
        std::array<VertexId, 3> corners{ring[0], ring[1], ring[2]};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        return {corners};
    }
    return FaceTriangulation(vertices, face).run();
}

}  // namespace sightline::detail
