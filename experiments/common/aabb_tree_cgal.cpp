// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/aabb_tree_cgal.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace sightline::experiments {
namespace {

template <typename Kernel>
class Tree final : public CgalTree {
public:
    explicit Tree(const Scene3& scene) {
        for (const Triangle3& t : scene.triangles()) {
            triangles_.emplace_back(point(scene[t.corners[0]]), point(scene[t.corners[1]]),
                                    point(scene[t.corners[2]]));
        }
        tree_.rebuild(triangles_.begin(), triangles_.end());
        tree_.build();
    }

    std::optional<std::uint32_t> first(const Point3& p, const Point3& q) const override {
        const auto hit =
            tree_.first_intersected_primitive(typename Kernel::Ray_3(point(p), point(q)));
        if (!hit) return std::nullopt;
        return static_cast<std::uint32_t>(*hit - triangles_.begin());
    }
    bool meets(const Point3& p, const Point3& q) const override {
        return tree_.do_intersect(typename Kernel::Segment_3(point(p), point(q)));
    }

private:
    using Triangles = std::vector<typename Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, typename Triangles::const_iterator>;

    static typename Kernel::Point_3 point(const Point3& p) { return {p.x, p.y, p.z}; }

    Triangles triangles_;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

}  // namespace

std::unique_ptr<CgalTree> cgal_tree_epick(const Scene3& scene) {
    return std::make_unique<Tree<CGAL::Exact_predicates_inexact_constructions_kernel>>(scene);
}

std::unique_ptr<CgalTree> cgal_tree_epeck(const Scene3& scene) {
    return std::make_unique<Tree<CGAL::Exact_predicates_exact_constructions_kernel>>(scene);
}

}  // namespace sightline::experiments
