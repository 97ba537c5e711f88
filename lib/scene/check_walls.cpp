// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/box_tree.hpp"
#include "scene/layout.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {
namespace {

/// A place on a wall where the boundary of B leaves it or passes: a ray from
/// `place` to `target`.
struct Contact {
    Point2 place;
    Point2 target;
    std::uint32_t edge = 0;
    bool solid_left = false;  ///< B on the left of the ray

    friend bool operator<(const Contact& a, const Contact& b) {
        return a.place != b.place ? a.place < b.place : a.edge < b.edge;
    }
};

class WallChecker {
public:
    explicit WallChecker(const SceneLayout& layout)
        : layout_(layout), boxes_(boundary_boxes(layout, boundary_)), tree_(boxes_) {}

    /// The boundary edge behind which the wall a-b meets the interior of B, or
    /// no_edge.
    std::uint32_t blocked_by(const Point2& a, const Point2& b) {
        contacts_.clear();
        std::uint32_t crossed = no_edge;
        const auto may_meet = [&](const Box2& box) {
            return crossed == no_edge && line_meets(a, b, box);
        };
        tree_.query(Box2::of(a, b), may_meet, [&](std::uint32_t i) {
            if (crossed == no_edge && crosses(a, b, boundary_[i])) crossed = boundary_[i];
        });
        if (crossed != no_edge) return crossed;
        std::sort(contacts_.begin(), contacts_.end());
        for (std::size_t i = 0; i < contacts_.size();) {
            std::size_t j = i + 1;
            while (j < contacts_.size() && contacts_[j].place == contacts_[i].place) ++j;
            const std::span<const Contact> fan{contacts_.data() + i, j - i};
            for (const Point2* end : {&a, &b}) {
                if (*end == fan[0].place) continue;
                const std::uint32_t e = entered(fan, *end);
                if (e != no_edge) return e;
            }
            i = j;
        }
        return no_edge;
    }

private:
    static std::vector<Box2> boundary_boxes(const SceneLayout& layout,
                                            std::vector<std::uint32_t>& edges) {
        std::vector<Box2> boxes;
        for (std::uint32_t e = 0; e < layout.edges.size(); ++e) {
            if (layout.edges[e].kind == EdgeKind2::wall) continue;
            edges.push_back(e);
            boxes.push_back(Box2::of(layout.vertices[layout.edges[e].source.index()],
                                     layout.vertices[layout.edges[e].target.index()]));
        }
        return boxes;
    }

    static bool line_meets(const Point2& a, const Point2& b, const Box2& box) {
        const Sign first = orientation(a, b, box.low);
        return first == Sign::zero || orientation(a, b, box.high) != first ||
               orientation(a, b, {box.low.x, box.high.y}) != first ||
               orientation(a, b, {box.high.x, box.low.y}) != first;
    }

    static bool within(const Point2& a, const Point2& b, const Point2& p) {
        return a < b ? !(p < a) && !(b < p) : !(p < b) && !(a < p);
    }

    /// Whether the wall crosses the edge in a point inside both; otherwise notes
    /// where they touch.
    bool crosses(const Point2& a, const Point2& b, std::uint32_t e) {
        const Point2& s = layout_.vertices[layout_.edges[e].source.index()];
        const Point2& t = layout_.vertices[layout_.edges[e].target.index()];
        const Sign side_s = orientation(a, b, s);
        const Sign side_t = orientation(a, b, t);
        if (side_s == side_t && side_s != Sign::zero) return false;
        const Sign side_a = orientation(s, t, a);
        const Sign side_b = orientation(s, t, b);
        if (side_a == side_b && side_a != Sign::zero) return false;
        if (side_s * side_t == Sign::negative && side_a * side_b == Sign::negative) return true;
        if (side_s == Sign::zero && within(a, b, s)) contacts_.push_back({s, t, e, true});
        if (side_t == Sign::zero && within(a, b, t)) contacts_.push_back({t, s, e, false});
        for (const auto& [side, p] : {std::pair{side_a, a}, std::pair{side_b, b}}) {
            if (side != Sign::zero || p == s || p == t || !within(s, t, p)) continue;
            contacts_.push_back({p, t, e, true});
            contacts_.push_back({p, s, e, false});
        }
        return false;
    }

    /// Whether the direction from the fan's place to `end` leads at once into the
    /// interior of B: going round from it clockwise, the first ray met has B on
    /// its left.
    static std::uint32_t entered(std::span<const Contact> fan, const Point2& end) {
        const Point2& p = fan[0].place;
        const auto turn = [&](const Contact& c) {  // 0: along, 1: (0, pi), 2: pi, 3: (pi, 2 pi)
            const Sign s = orientation(p, end, c.target);
            if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
            return (end < p) == (c.target < p) ? 0 : 2;
        };
        const Contact* last = nullptr;
        for (const Contact& c : fan) {
            if (turn(c) == 0) return no_edge;
            if (last == nullptr || turn(c) > turn(*last)) {
                last = &c;
                continue;
            }
            if (turn(c) < turn(*last)) continue;
            const Sign s = orientation(p, last->target, c.target);
            if (s == Sign::positive || (s == Sign::zero && c.solid_left)) last = &c;
        }
        return last->solid_left ? last->edge : no_edge;
    }

    const SceneLayout& layout_;
    std::vector<std::uint32_t> boundary_;
    std::vector<Box2> boxes_;
    BoxTree tree_;
    std::vector<Contact> contacts_;
};

Error wall_error(const SceneLayout& layout, std::string name, std::uint32_t element, Owner owner) {
    if (owner == world_solid) {
        return {Errc::outside_world,
                fmt::format("{}{}: the wall leaves the world; clip it to the world",
                            layout.origin(element), name)};
    }
    return {Errc::wall_crosses_body,
            fmt::format("{}{}: the wall runs through the interior of body {}; "
                        "cut it at the body's boundary",
                        layout.origin(element), name, owner)};
}

}  // namespace

Result<void> check_walls(const SceneLayout& layout, const std::vector<SweepInside>& inside) {
    for (const SweepInside& found : inside) {
        const ChainRecord& chain = layout.chain_of_vertex(found.vertex);
        if (chain.kind != ChainRecord::Kind::wall || found.on_boundary) continue;
        return tl::unexpected(
            wall_error(layout, layout.name_of_vertex(found.vertex), chain.element, found.owner));
    }
    const bool any_wall = std::any_of(layout.edges.begin(), layout.edges.end(),
                                      [](const Edge2& e) { return e.kind == EdgeKind2::wall; });
    if (!any_wall) return {};
    WallChecker checker(layout);
    for (std::uint32_t e = 0; e < layout.edges.size(); ++e) {
        const Edge2& wall = layout.edges[e];
        if (wall.kind != EdgeKind2::wall) continue;
        const std::uint32_t blocker = checker.blocked_by(layout.vertices[wall.source.index()],
                                                         layout.vertices[wall.target.index()]);
        if (blocker == no_edge) continue;
        return tl::unexpected(wall_error(layout, layout.name_of_edge(e),
                                         layout.chain_of_edge(e).element,
                                         owner_of(layout.edges[blocker])));
    }
    return {};
}

}  // namespace sightline::detail
