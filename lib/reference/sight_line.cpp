// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sight_line.hpp"

#include <algorithm>
#include <numeric>

namespace sightline::reference {
namespace {

/// Union-find over the sectors of the pictures along a run.
class Components {
public:
    explicit Components(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
    [[nodiscard]] bool same(std::size_t a, std::size_t b) const { return find(a) == find(b); }

private:
    [[nodiscard]] std::size_t find(std::size_t a) const {
        while (parent_[a] != a) a = parent_[a];
        return a;
    }
    std::vector<std::size_t> parent_;
};

}  // namespace

Everything::Everything(const Scene2& scene)
    : points_(scene.points().begin(), scene.points().end()) {
    for (std::uint32_t i = 0; i < scene.edge_count(); ++i) edges_.push_back(EdgeId{i});
}

SightLine::SightLine(const Scene2& scene, const Candidates& near, const Place& p, const Place& q,
                     Reach reach)
    : p_(p), q_(q), reach_(reach) {
    SIGHTLINE_EXPECT(p != q);
    places_.push_back(p);
    if (reach == Reach::segment) places_.push_back(q);
    for (const VertexId v : near.points) {
        const Place x = scene[v];
        if (is_within(x) && side(p_, q_, x) == Sign::zero) note_vertex(x);
    }
    for (const EdgeId e : near.edges) {
        meet(scene, near, e);
        if (cut_) return;
    }
    take_pictures(scene);
}

// Whether x, if it lies on the line, lies on the closed segment or ray.
bool SightLine::is_within(const Place& x) const {
    if (reach_ == Reach::segment) return is_between(p_, q_, x);
    return p_ < q_ ? p_ <= x : x <= p_;
}

void SightLine::note_vertex(const Place& vertex) {
    if (vertex == p_ || (reach_ == Reach::segment && vertex == q_)) return;
    passes_vertex_ = true;
    places_.push_back(vertex);
}

// Whether a ring has a corner where the line crosses the body edge: there may be a pinhole in the edge.
bool SightLine::is_pierced(const Scene2& scene, const Candidates& near, EdgeId edge) const {
    return std::any_of(near.edges.begin(), near.edges.end(), [&](EdgeId other) {
        const Place x = scene[scene[other].source];
        return scene[other].kind != EdgeKind2::wall && side(p_, q_, x) == Sign::zero &&
               is_on(scene, edge, x);
    });
}

void SightLine::meet(const Scene2& scene, const Candidates& near, EdgeId edge) {
    const Edge2& e = scene[edge];
    const Place a = scene[e.source];
    const Place b = scene[e.target];
    const Sign side_a = side(p_, q_, a);
    const Sign side_b = side(p_, q_, b);
    if (side_a == side_b && side_a != Sign::zero) return;
    if (side_a != Sign::zero && side_b != Sign::zero) {
        // ab crosses the line; the crossing is ahead of a place when the place is on the far side
        // of ab.
        const Sign ahead_of_p = -(side_a * side(a, b, p_));
        const Sign ahead_of_q = -(side_a * side(a, b, q_));
        if (ahead_of_p == Sign::negative) return;
        if (reach_ == Reach::segment && ahead_of_q == Sign::positive) return;
        touching_.push_back(edge);
        if (ahead_of_p == Sign::zero || (reach_ == Reach::segment && ahead_of_q == Sign::zero))
            return;
        if (reach_ == Reach::segment && e.kind != EdgeKind2::wall &&
            !is_pierced(scene, near, edge)) {
            cut_ = true;  // the solid side of the edge is met before or after the crossing
            return;
        }
        places_.push_back(crossing(p_, q_, a, b));
        return;
    }
    const bool meets_a = side_a == Sign::zero && is_within(a);
    const bool meets_b = side_b == Sign::zero && is_within(b);
    if (meets_a) note_vertex(a);
    if (meets_b) note_vertex(b);
    const bool covers = side_a == side_b && is_between(a, b, p_);
    if (meets_a || meets_b || covers) touching_.push_back(edge);
}

void SightLine::take_pictures(const Scene2& scene) {
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    if (q_ < p_) std::reverse(places_.begin(), places_.end());
    pictures_.reserve(places_.size());
    for (const Place& x : places_) pictures_.emplace_back(scene, touching_, x);
}

Heading SightLine::forward(std::size_t event) const {
    return event == 0 ? Heading{q_, false} : Heading{p_, true};
}

Heading SightLine::backward(std::size_t event) const {
    return event == 0 ? Heading{q_, true} : Heading{p_, false};
}

bool SightLine::is_crossed(const Run& run) const {
    std::vector<std::size_t> offset;  // of the sectors of each picture
    std::size_t total = 0;
    for (std::size_t i = run.first; i <= run.last; ++i) {
        offset.push_back(total);
        total += pictures_[i].sector_count();
    }
    Components without_walls(total);
    Components all(total);
    const auto unite_strip = [&](std::size_t i, std::size_t sector, std::size_t next_sector) {
        const std::size_t k = i - run.first;
        all.unite(offset[k] + sector, offset[k + 1] + next_sector);
        without_walls.unite(offset[k] + sector, offset[k + 1] + next_sector);
    };
    for (std::size_t i = run.first; i <= run.last; ++i) {
        const Picture& picture = pictures_[i];
        for (std::size_t arm = 0; arm < picture.arms().size(); ++arm) {
            if (picture.arms()[arm].is_body()) continue;
            const std::size_t base = offset[i - run.first];
            without_walls.unite(base + arm, base + picture.sector_before(arm));
        }
        if (i == run.last) continue;
        // The strips on the two sides of the wall between this event and the next.
        const std::size_t out = picture.locate(forward(i)).index;
        const std::size_t in = pictures_[i + 1].locate(backward(i + 1)).index;
        unite_strip(i, out, pictures_[i + 1].sector_before(in));
        unite_strip(i, picture.sector_before(out), in);
    }
    const std::size_t comes = pictures_[run.first].free_sector(backward(run.first));
    const std::size_t leaves = offset.back() + pictures_[run.last].free_sector(forward(run.last));
    return !all.same(comes, leaves) && without_walls.same(comes, leaves);
}

std::optional<std::size_t> SightLine::first_block(const Extension& extension) const {
    const std::size_t last = pictures_.size() - 1;
    const bool goes_on = reach_ == Reach::ray || extension.beyond_q;
    if (extension.beyond_p && pictures_[0].is_interior(backward(0))) return 0;
    // The run of walls that the line is in, and whether it has something of the line before it.
    bool in_run = false;
    std::size_t run_start = 0;
    bool comes_from_outside = extension.beyond_p && !pictures_[0].is_on_wall(backward(0));
    for (std::size_t i = 0; i <= last; ++i) {
        if (!in_run && pictures_[i].has_wall()) {
            in_run = true;
            run_start = i;
        }
        if (i == last && !goes_on) return std::nullopt;
        if (pictures_[i].is_interior(forward(i))) return i;
        if (in_run && pictures_[i].is_on_wall(forward(i))) continue;
        if (in_run && comes_from_outside && is_crossed({run_start, i})) return i;
        in_run = false;
        comes_from_outside = true;
    }
    return std::nullopt;
}

bool SightLine::is_free(const Extension& extension) const {
    return !cut_ && !first_block(extension);
}

std::optional<Place> SightLine::stop() const {
    SIGHTLINE_EXPECT(!cut_);
    const auto event = first_block({});
    if (!event) return std::nullopt;
    return places_[*event];
}

std::vector<SightLine::Way> SightLine::ways() const {
    if (pictures_.size() != 2) return {};
    const Picture& at_p = pictures_.front();
    const Picture& at_q = pictures_.back();
    const Picture::Spot out = at_p.locate(forward(0));
    const Picture::Spot in = at_q.locate(backward(1));
    if (!out.on_arm) return {{out.index, in.index}};
    const Way left{out.index, at_q.sector_before(in.index)};
    const Way right{at_p.sector_before(out.index), in.index};
    std::vector<Way> result;
    if (!at_p.is_solid(left.from)) result.push_back(left);
    if (!at_p.is_solid(right.from)) result.push_back(right);
    return result;
}

bool SightLine::runs_along_bodies() const {
    if (cut_) return false;
    for (std::size_t i = 0; i + 1 < pictures_.size(); ++i) {
        if (!pictures_[i].is_on_body(forward(i))) return false;
    }
    return true;
}

}  // namespace sightline::reference
