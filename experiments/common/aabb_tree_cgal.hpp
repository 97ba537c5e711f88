// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sightline/scene/scene3.hpp"

namespace sightline::experiments {

/// What a user would pick for rays otherwise: CGAL's AABB_tree over a scene's triangles.
class CgalTree {
public:
    virtual ~CgalTree() = default;
    /// The first triangle that the ray from p through q meets; empty when it meets none.
    [[nodiscard]] virtual std::optional<std::uint32_t> first(const Point3& p,
                                                             const Point3& q) const = 0;
    /// Whether the segment pq meets some triangle.
    [[nodiscard]] virtual bool meets(const Point3& p, const Point3& q) const = 0;
};

/// With exact predicates and rounded constructions (EPICK).
[[nodiscard]] std::unique_ptr<CgalTree> cgal_tree_epick(const Scene3& scene);
/// With exact predicates and constructions (EPECK, lazy numbers).
[[nodiscard]] std::unique_ptr<CgalTree> cgal_tree_epeck(const Scene3& scene);

}  // namespace sightline::experiments
