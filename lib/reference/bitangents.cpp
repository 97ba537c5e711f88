// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/reference/bitangents.hpp"

#include <algorithm>

#include "reference/picture.hpp"
#include "sightline/geom/predicates2.hpp"
#include "sightline/reference/free_segment.hpp"

namespace sightline::reference {
namespace {

// Who owns a vertex: a body, the world, or the vertex itself.
struct Owner {
    BodyId body;
    bool world = false;
    VertexId self;

    friend bool operator==(const Owner&, const Owner&) = default;
};

class PairTest {
public:
    explicit PairTest(const Scene2& scene) : scene_(scene) {
        std::vector<EdgeId> edges;
        edges.reserve(scene.edge_count());
        for (std::uint32_t i = 0; i < scene.edge_count(); ++i) edges.push_back({i});
        for (std::uint32_t i = 0; i < scene.vertex_count(); ++i)
            pictures_.emplace_back(scene, edges, scene[VertexId{i}]);
    }

    [[nodiscard]] Owner owner(VertexId v) const {
        for (const Edge2& e : scene_.edges()) {
            if (e.source != v || e.kind == EdgeKind2::wall) continue;
            return {e.body, e.kind == EdgeKind2::world, {}};
        }
        return {{}, false, v};
    }

    /// Whether a short piece of the line through v and p is free round v: neither half of it runs
    /// inside B, and no wall that both leave to the sides is needed to separate them.
    [[nodiscard]] bool is_tangent(VertexId v, const Point2& p) const {
        const Picture& picture = pictures_[v.index()];
        const Heading forward{p, false};
        const Heading backward{p, true};
        if (picture.is_interior(forward) || picture.is_interior(backward)) return false;
        if (!picture.has_wall() || picture.is_on_wall(forward) || picture.is_on_wall(backward))
            return true;
        const std::size_t from = picture.free_sector(forward);
        const std::size_t to = picture.free_sector(backward);
        return from == to || !are_joined_without_walls(picture, from, to);
    }

    [[nodiscard]] bool is_bitangent(VertexId v, VertexId w) const {
        return scene_[v] != scene_[w] && is_tangent(v, scene_[w]) && is_tangent(w, scene_[v]);
    }

    /// Whether x lies strictly between v and w.
    [[nodiscard]] bool is_inside(VertexId v, VertexId w, VertexId x) const {
        return scene_[x] != scene_[v] && scene_[x] != scene_[w] &&
               is_on({scene_[v], scene_[w]}, scene_[x]);
    }

    [[nodiscard]] Side side(VertexId v, VertexId from, VertexId to) const {
        bool left = false;
        bool right = false;
        bool inside_left = false;
        bool inside_right = false;
        for (const Edge2& e : scene_.edges()) {
            if (e.source != v && e.target != v) continue;
            const VertexId other = e.source == v ? e.target : e.source;
            const Sign s = orientation(scene_[from], scene_[to], scene_[other]);
            left |= s == Sign::positive;
            right |= s == Sign::negative;
            if (s != Sign::zero || e.kind == EdgeKind2::wall) continue;
            const bool along = order_along(scene_[from], scene_[to], scene_[e.source],
                                           scene_[e.target]) == Sign::negative;
            (along ? inside_left : inside_right) = true;
        }
        if (!left && !right) left = inside_left, right = inside_right;
        if (left && right) return Side::both;
        if (!left && !right) return Side::on;
        return left ? Side::left : Side::right;
    }

private:
    // Whether one can turn from one free sector to the other across walls only.
    static bool are_joined_without_walls(const Picture& picture, std::size_t a, std::size_t b) {
        const std::size_t n = picture.sector_count();
        for (const std::size_t step : {std::size_t{1}, n - 1}) {
            std::size_t i = a;
            while (i != b && !picture.is_solid(i)) i = (i + step) % n;
            if (i == b) return true;
        }
        return false;
    }

    const Scene2& scene_;
    std::vector<Picture> pictures_;
};

}  // namespace

std::vector<Bitangent> bitangents(const Scene2& scene, const BitangentOptions& options) {
    const PairTest test(scene);
    const auto n = static_cast<std::uint32_t>(scene.vertex_count());
    std::vector<Owner> owner;
    owner.reserve(n);
    for (std::uint32_t i = 0; i < n; ++i) owner.push_back(test.owner({i}));
    // Whether a contact of the same two owners lies between.
    const auto is_nearest = [&](VertexId v, VertexId w) {
        for (std::uint32_t x = 0; x < n; ++x) {
            if (owner[x] != owner[v.index()] && owner[x] != owner[w.index()]) continue;
            if (test.is_inside(v, w, {x}) && test.is_tangent({x}, scene[v])) return false;
        }
        return true;
    };
    std::vector<Bitangent> found;
    for (VertexId v{0}; v.value < n; ++v.value) {
        for (VertexId w{0}; w.value < n; ++w.value) {
            if (!options.one_body && owner[v.index()] == owner[w.index()]) continue;
            if (!test.is_bitangent(v, w) || !is_nearest(v, w)) continue;
            found.push_back({owner[v.index()].body, owner[w.index()].body, test.side(v, v, w),
                             test.side(w, v, w), v, w});
        }
    }
    return found;
}

std::vector<FreeBitangent> free_bitangents(const Scene2& scene,
                                           const FreeBitangentOptions& options) {
    const PairTest test(scene);
    std::vector<FreeBitangent> found = reference::bitangents(scene, {.one_body = options.one_body});
    std::erase_if(found, [&](const Bitangent& b) {
        for (std::uint32_t x = 0; x < scene.vertex_count(); ++x) {
            if (test.is_inside(b.source, b.target, {x})) return true;
        }
        return !is_free(scene, b.source, b.target);
    });
    return found;
}

}  // namespace sightline::reference
