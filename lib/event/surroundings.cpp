// SPDX-License-Identifier: GPL-3.0-or-later
#include "event/surroundings.hpp"

#include <algorithm>

#include "scene/box_tree.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline::detail {

Surroundings::Surroundings(const Scene2& scene) : scene_(&scene), at_(scene.vertex_count()) {
    std::vector<Box2> boxes;
    boxes.reserve(scene.edge_count());
    for (const Edge2& e : scene.edges())
        boxes.push_back(Box2::of(scene[e.source], scene[e.target]));
    const BoxTree tree(boxes);
    std::vector<VertexId> order;
    order.reserve(scene.vertex_count());
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) order.push_back({i});
    std::sort(order.begin(), order.end(),
              [&](VertexId a, VertexId b) { return scene[a] < scene[b]; });
    std::vector<VertexId> here;
    for (std::size_t i = 0; i < order.size();) {
        const Point2& place = scene[order[i]];
        here.clear();
        for (; i < order.size() && scene[order[i]] == place; ++i) here.push_back(order[i]);
        std::vector<Arm> arms;
        const auto meets = [](const Box2&) { return true; };
        tree.query(Box2::of(place, place), meets, [&](std::uint32_t index) {
            const Edge2& e = scene.edges()[index];
            const Point2& source = scene[e.source];
            const Point2& target = scene[e.target];
            if (!is_on({source, target}, place)) return;
            const bool wall = e.kind == EdgeKind2::wall;
            if (target != place) add(arms, place, {target, wall, !wall, false});
            if (source != place) add(arms, place, {source, wall, false, !wall});
        });
        survey(here, std::move(arms));
    }
}

void Surroundings::add(std::vector<Arm>& arms, const Point2& place, const Arm& arm) {
    for (Arm& known : arms) {
        if (order_of_directions(place, known.tip, known.tip, arm.tip) != Sign::zero) continue;
        known.wall |= arm.wall;
        known.solid_left |= arm.solid_left;
        known.solid_right |= arm.solid_right;
        return;
    }
    arms.push_back(arm);
}

void Surroundings::find_sectors(std::vector<Arm>& arms, const Point2& place) {
    if (arms.empty()) return;
    const Point2 reference = arms.front().tip;
    std::sort(arms.begin(), arms.end(), [&](const Arm& a, const Arm& b) {
        return order_of_directions(place, reference, a.tip, b.tip) == Sign::negative;
    });
    // A wall alone has the same on both sides; the second round carries across the start.
    bool solid = false;
    for (std::size_t i = 0; i < 2 * arms.size(); ++i) {
        Arm& arm = arms[i % arms.size()];
        if (arm.solid_left || arm.solid_right) solid = arm.solid_left;
        arm.solid = solid;
    }
}

void Surroundings::survey(const std::vector<VertexId>& vertices, std::vector<Arm> arms) {
    const Point2& place = (*scene_)[vertices.front()];
    find_sectors(arms, place);
    Around around;
    const bool walls = std::any_of(arms.begin(), arms.end(), [](const Arm& a) { return a.wall; });
    std::size_t sectors = 0;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        const bool before = arms[(i + arms.size() - 1) % arms.size()].solid;
        if (arms[i].solid && !before) {
            around.first = arms[i].tip;
            ++sectors;
        }
        if (!arms[i].solid && before) around.last = arms[i].tip;
    }
    if (walls || sectors > 1) {
        around.kind = Kind::general;
        around.arms = static_cast<std::uint32_t>(arms_.size());
        arms_.push_back(std::move(arms));
    } else if (sectors == 1) {
        const bool reflex = orientation(place, around.first, around.last) == Sign::negative;
        around.kind = reflex ? Kind::reflex : Kind::sector;
    } else if (!arms.empty()) {
        around.kind = Kind::reflex;  // sealed in from all sides
    }
    for (const VertexId v : vertices) at_[v] = around;
}

bool Surroundings::is_tangent(const Point2& p, VertexId v) const {
    const Around& around = at_[v];
    const Point2& place = (*scene_)[v];
    switch (around.kind) {
        case Kind::open:
            return true;
        case Kind::reflex:
            return false;
        case Kind::sector:
            return orientation(place, p, around.first) * orientation(place, p, around.last) !=
                   Sign::negative;
        case Kind::general:
            break;
    }
    const std::vector<Arm>& arms = arms_[around.arms];
    return can_pass(arms, locate(arms, place, p, false), locate(arms, place, p, true));
}

// The ray from the place towards p, or straight away from it. The arm that the ray meets last when
// it turns counter-clockwise for one turn is the one before it.
Surroundings::Spot Surroundings::locate(const std::vector<Arm>& arms, const Point2& place,
                                        const Point2& p, bool away) {
    // 0: on the ray; 1: to its left; 2: on its extension backwards; 3: to its right.
    const auto quarter = [&](const Arm& arm) {
        const Sign side = orientation(place, p, arm.tip);
        int turn = side == Sign::positive ? 1 : 3;
        if (side == Sign::zero) turn = (place < p) == (place < arm.tip) ? 0 : 2;
        return away ? (turn + 2) % 4 : turn;
    };
    Spot last;
    int last_quarter = -1;
    for (std::size_t i = 0; i < arms.size(); ++i) {
        const int q = quarter(arms[i]);
        if (q == 0) return {i, true};
        const bool later = q > last_quarter ||
                           (q == last_quarter &&
                            orientation(place, arms[last.arm].tip, arms[i].tip) == Sign::positive);
        if (!later) continue;
        last = {i, false};
        last_quarter = q;
    }
    return last;
}

bool Surroundings::can_pass(const std::vector<Arm>& arms, const Spot& in, const Spot& out) {
    const std::size_t n = arms.size();
    // The free sector that a ray borders on; n when it runs inside B.
    const auto sector = [&](const Spot& spot) {
        if (!arms[spot.arm].solid) return spot.arm;
        const std::size_t before = (spot.arm + n - 1) % n;
        return spot.on_arm && !arms[before].solid ? before : n;
    };
    const std::size_t from = sector(in);
    const std::size_t to = sector(out);
    if (from == n || to == n) return false;
    if ((in.on_arm && arms[in.arm].wall) || (out.on_arm && arms[out.arm].wall)) return true;
    if (from == to) return true;
    // Different sectors: walls must not be needed to separate them. B alone does when both ways
    // round lead through solid sectors.
    const auto is_solid_between = [&](std::size_t a, std::size_t b) {
        for (std::size_t i = a; i != b; i = (i + 1) % n) {
            if (arms[i].solid) return true;
        }
        return false;
    };
    return is_solid_between(from, to) && is_solid_between(to, from);
}

}  // namespace sightline::detail
