// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/expansion_cgal.hpp"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>

#include <array>
#include <set>
#include <vector>

namespace sightline::experiments {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
using Expansion = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;
using HalfEdge = Arrangement::Halfedge_const_handle;
using Face = Arrangement::Face_const_handle;

Kernel::Point_2 to_cgal(const Point2& p) { return {p.x, p.y}; }

std::array<double, 4> ends(const Point2& a, const Point2& b) { return {a.x, a.y, b.x, b.y}; }

}  // namespace

struct CgalExpansion::Impl {
    Arrangement arrangement;
    std::vector<HalfEdge> views;  // that end at a vertex and have free space on their left
    std::vector<Kernel::Point_2> points;
    std::vector<Face> faces;
    Expansion expansion;

    // Faces on whose boundary a scene edge has its solid side.
    [[nodiscard]] std::set<Face> solid_faces(const Scene2& scene) const {
        std::set<std::array<double, 4>> directed;
        for (const Edge2& e : scene.edges()) {
            directed.insert(ends(scene[e.source], scene[e.target]));
        }
        std::set<Face> solid;
        for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
            const auto& a = h->source()->point();
            const auto& b = h->target()->point();
            if (directed.contains({CGAL::to_double(a.x()), CGAL::to_double(a.y()),
                                   CGAL::to_double(b.x()), CGAL::to_double(b.y())})) {
                solid.insert(h->face());
            }
        }
        return solid;
    }
};

CgalExpansion::CgalExpansion(const Scene2& scene) : impl_(std::make_unique<Impl>()) {
    SIGHTLINE_EXPECT(scene.has_world());
    std::vector<Kernel::Segment_2> segments;
    for (const Edge2& e : scene.edges()) {
        SIGHTLINE_EXPECT(e.kind != EdgeKind2::wall);
        segments.emplace_back(to_cgal(scene[e.source]), to_cgal(scene[e.target]));
    }
    CGAL::insert(impl_->arrangement, segments.begin(), segments.end());
    const std::set<Face> solid = impl_->solid_faces(scene);
    const Arrangement& arrangement = impl_->arrangement;
    for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
        if (!h->face()->is_unbounded() && !solid.contains(h->face())) impl_->views.push_back(h);
    }
}

CgalExpansion::~CgalExpansion() = default;

void CgalExpansion::attach() {
    if (impl_->expansion.is_attached()) impl_->expansion.detach();
    impl_->expansion.attach(impl_->arrangement);
}

std::size_t CgalExpansion::from_every_vertex() {
    std::size_t total = 0;
    for (const HalfEdge h : impl_->views) {
        Arrangement seen;
        impl_->expansion.compute_visibility(h->target()->point(), h, seen);
        total += seen.number_of_vertices();
    }
    return total;
}

void CgalExpansion::locate(std::span<const Point2> points) {
    const CGAL::Arr_walk_along_line_point_location<Arrangement> location(impl_->arrangement);
    impl_->points.clear();
    impl_->faces.clear();
    for (const Point2& p : points) {
        const auto found = location.locate(to_cgal(p));
        const Face* face = boost::get<Face>(&found);
        SIGHTLINE_EXPECT(face != nullptr && !(*face)->is_unbounded());
        impl_->points.push_back(to_cgal(p));
        impl_->faces.push_back(*face);
    }
}

std::size_t CgalExpansion::from_point(std::size_t index) {
    Arrangement seen;
    impl_->expansion.compute_visibility(impl_->points[index], impl_->faces[index], seen);
    return seen.number_of_vertices();
}

}  // namespace sightline::experiments
