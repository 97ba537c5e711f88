// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/picture.hpp"

#include <algorithm>
#include <string>

namespace sightline::reference {

bool is_on(const Scene2& scene, EdgeId edge, const Place& x) {
    const Place a = scene[scene[edge].source];
    const Place b = scene[scene[edge].target];
    return is_between(a, b, x) && side(a, b, x) == Sign::zero;
}

namespace {

// Winding of one edge round x: a ray to the right of x is crossed upwards or downwards.
int winding(const Scene2& scene, const Edge2& e, const Place& x) {
    const Place a = scene[e.source];
    const Place b = scene[e.target];
    const bool a_below = compare_y(a, x) <= 0;
    const bool b_below = compare_y(b, x) <= 0;
    if (a_below && !b_below && side(a, b, x) == Sign::positive) return 1;
    if (!a_below && b_below && side(a, b, x) == Sign::negative) return -1;
    return 0;
}

}  // namespace

int winding_number(const Scene2& scene, BodyId body, const Place& x) {
    int sum = 0;
    for (const Edge2& e : scene.edges()) {
        if (e.kind != EdgeKind2::wall && e.body == body) sum += winding(scene, e, x);
    }
    return sum;
}

bool is_interior(const Scene2& scene, const Place& x) {
    std::vector<EdgeId> touching;
    int sum = scene.has_world() ? 1 : 0;  // the world's ring winds once backwards round its inside
    for (std::uint32_t i = 0; i < scene.edge_count(); ++i) {
        if (scene[EdgeId{i}].kind == EdgeKind2::wall) continue;
        if (is_on(scene, EdgeId{i}, x)) touching.push_back(EdgeId{i});
        sum += winding(scene, scene[EdgeId{i}], x);
    }
    if (touching.empty()) return sum > 0;
    const Picture picture(scene, touching, x);
    for (std::size_t i = 0; i < picture.sector_count(); ++i) {
        if (!picture.is_solid(i)) return false;
    }
    return true;
}

Picture::Picture(const Scene2& scene, std::span<const EdgeId> touching, const Place& x)
    : place_(x) {
    for (const EdgeId id : touching) {
        if (!is_on(scene, id, x)) continue;
        const Edge2& e = scene[id];
        const bool body = e.kind != EdgeKind2::wall;
        const Place source = scene[e.source];
        const Place target = scene[e.target];
        if (target != x) add_arm({target, !body, body, false});
        if (source != x) add_arm({source, !body, false, body});
    }
    std::sort(arms_.begin(), arms_.end(), [&](const Arm& a, const Arm& b) {
        return order_round(place_, {a.tip}, {b.tip}) < 0;
    });
    find_solid_sectors();
}

void Picture::add_arm(const Arm& arm) {
    for (Arm& known : arms_) {
        if (order_round(place_, {known.tip}, {arm.tip}) != 0) continue;
        known.wall |= arm.wall;
        known.solid_left |= arm.solid_left;
        known.solid_right |= arm.solid_right;
        return;
    }
    arms_.push_back(arm);
}

void Picture::find_solid_sectors() {
    const std::size_t n = arms_.size();
    solid_.assign(std::max<std::size_t>(n, 1), false);
    // A wall alone separates nothing solid from nothing free; the second round carries across the
    // start.
    for (std::size_t i = 0; i < 2 * n; ++i) {
        const Arm& arm = arms_[i % n];
        solid_[i % n] = arm.is_body() ? arm.solid_left : solid_[sector_before(i % n)];
    }
}

Picture::Spot Picture::locate(const Heading& heading) const {
    std::size_t before = 0;
    for (std::size_t i = 0; i < arms_.size(); ++i) {
        const auto order = order_round(place_, {arms_[i].tip}, heading);
        if (order == 0) return {true, i};
        if (order < 0) ++before;
    }
    return {false, arms_.empty() ? 0 : sector_before(before % arms_.size())};
}

bool Picture::has_wall() const {
    return std::any_of(arms_.begin(), arms_.end(), [](const Arm& arm) { return arm.wall; });
}

bool Picture::has_body() const {
    return std::any_of(arms_.begin(), arms_.end(), [](const Arm& arm) { return arm.is_body(); });
}

bool Picture::is_interior(const Heading& heading) const {
    const Spot spot = locate(heading);
    return solid_[spot.index] && (!spot.on_arm || solid_[sector_before(spot.index)]);
}

bool Picture::is_on_wall(const Heading& heading) const {
    const Spot spot = locate(heading);
    return spot.on_arm && arms_[spot.index].wall;
}

bool Picture::is_on_body(const Heading& heading) const {
    const Spot spot = locate(heading);
    return spot.on_arm && arms_[spot.index].is_body();
}

std::size_t Picture::free_sector(const Heading& heading) const {
    const Spot spot = locate(heading);
    if (spot.on_arm && solid_[spot.index]) return sector_before(spot.index);
    return spot.index;
}

bool Picture::may_pass(std::size_t sector, std::size_t other) const {
    if (sector == other) return true;
    // Round counter-clockwise from one to the other and back: B parts them when it is met on both ways.
    const auto meets_solid = [this](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i != last; i = (i + 1) % solid_.size()) {
            if (solid_[i]) return true;
        }
        return false;
    };
    return meets_solid(sector, other) && meets_solid(other, sector);
}

Picture picture_at(const Scene2& scene, const Place& x) {
    std::vector<EdgeId> touching;
    for (std::uint32_t i = 0; i < scene.edge_count(); ++i) {
        if (is_on(scene, EdgeId{i}, x)) touching.push_back(EdgeId{i});
    }
    return {scene, touching, x};
}

Error inside_error(const Scene2& scene, const Place& x) {
    const RationalPoint2 p = x.rational();
    const std::string name = p.x.to_string() + "," + p.y.to_string();
    for (std::uint32_t i = 0; i < scene.edge_count(); ++i) {
        const BodyId body = scene[EdgeId{i}].body;
        if (body.is_none()) continue;
        if (is_on(scene, EdgeId{i}, x) || winding_number(scene, body, x) > 0) {
            return {Errc::inside_body, "the point " + name + " is inside body " + to_string(body) +
                                           "; choose a point outside of it"};
        }
    }
    return {Errc::outside_of_world,
            "the point " + name + " is outside of the world; choose a point inside of it"};
}

}  // namespace sightline::reference
