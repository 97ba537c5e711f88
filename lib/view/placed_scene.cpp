// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/placed_scene.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "sightline/geom/predicates3.hpp"
#include "sightline/spatial/scene_boxes.hpp"

namespace sightline::detail {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

struct SideKey {
    std::uint32_t face;
    std::uint64_t ends;
    friend bool operator==(const SideKey&, const SideKey&) = default;
};
struct SideHash {
    std::size_t operator()(const SideKey& k) const noexcept {
        return (k.ends * 0x9E3779B97F4A7C15U) ^ (k.face * 0xC2B2AE3D27D4EB4FU);
    }
};

void place_edges(PlacedScene& view) {
    const auto edges = view.scene->edges();
    std::vector<std::uint32_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto ends = [&](std::uint32_t i) { return std::pair{edges[i].source, edges[i].target}; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return ends(a) < ends(b); });
    for (const std::uint32_t i : order) {
        const Edge3& e = edges[i];
        const auto at = static_cast<std::uint32_t>(view.edge_ids.size());
        view.edge_ids.push_back(EdgeId{i});
        if (!view.edges.empty() && view.edges.back().source == e.source.value &&
            view.edges.back().target == e.target.value) {
            ++view.edges.back().last;
            continue;
        }
        const bool sheet = (*view.scene)[e.body].kind == SurfaceKind::sheet;
        view.edges.push_back({e.source.value, e.target.value, at, at + 1, sheet});
    }
}

void place_triangles(PlacedScene& view) {
    std::unordered_map<std::uint64_t, std::uint32_t> by_ends;
    for (std::uint32_t i = 0; i < view.edges.size(); ++i) {
        by_ends.emplace(key_of(view.edges[i].source, view.edges[i].target), i);
    }
    // A diagonal of one face may run where another face's edge is; what counts is this face's border.
    const auto borders = [&](std::uint32_t edge, FaceId face) {
        const auto ids = view.ids(view.edges[edge]);
        return std::any_of(ids.begin(), ids.end(), [&](EdgeId id) {
            const auto& faces = (*view.scene)[id].faces;
            return faces[0] == face || faces[1] == face;
        });
    };
    for (const Triangle3& t : view.scene->triangles()) {
        PlacedTriangle placed;
        placed.face = t.face.value;
        for (std::size_t k = 0; k < 3; ++k) {
            placed.corners[k] = t.corners[k].value;
            const auto found =
                by_ends.find(key_of(t.corners[k].value, t.corners[(k + 1) % 3].value));
            const bool is_border = found != by_ends.end() && borders(found->second, t.face);
            placed.edges[k] = is_border ? found->second : no_edge;
        }
        view.triangles.push_back(placed);
    }
}

void find_reflex_edges(PlacedScene& view) {
    std::unordered_map<SideKey, std::uint32_t, SideHash> third;
    for (const PlacedTriangle& t : view.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            third.emplace(SideKey{t.face, key_of(t.corners[k], t.corners[(k + 1) % 3])},
                          t.corners[(k + 2) % 3]);
        }
    }
    const Scene3& scene = *view.scene;
    view.is_reflex.assign(scene.edges().size(), 0);
    for (std::size_t i = 0; i < scene.edges().size(); ++i) {
        const Edge3& e = scene.edges()[i];
        if (scene[e.body].kind == SurfaceKind::sheet) continue;
        const auto& plane = scene[e.faces[0]].plane;
        const auto found =
            third.find(SideKey{e.faces[1].value, key_of(e.source.value, e.target.value)});
        SIGHTLINE_EXPECT(found != third.end());
        view.is_reflex[i] =
            static_cast<char>(orientation(scene[plane[0]], scene[plane[1]], scene[plane[2]],
                                          scene.vertices()[found->second]) == Sign::positive);
    }
}

void list_edges_at_vertices(PlacedScene& view) {
    const std::size_t n = view.scene->vertices().size();
    view.is_feature.assign(n, 0);
    view.first_at.assign(n + 1, 0);
    for (const PlacedEdge& e : view.edges) {
        for (const std::uint32_t v : {e.source, e.target}) {
            ++view.first_at[v + 1];
            view.is_feature[v] = 1;
        }
    }
    std::partial_sum(view.first_at.begin(), view.first_at.end(), view.first_at.begin());
    view.edges_at.resize(view.first_at.back());
    std::vector<std::uint32_t> next(view.first_at.begin(), view.first_at.end() - 1);
    for (std::uint32_t i = 0; i < view.edges.size(); ++i) {
        view.edges_at[next[view.edges[i].source]++] = i;
        view.edges_at[next[view.edges[i].target]++] = i;
    }
}

}  // namespace

PlacedScene::PlacedScene(const Scene3& s) : scene(&s), bvh(triangle_boxes(s)) {
    place_edges(*this);
    place_triangles(*this);
    find_reflex_edges(*this);
    list_edges_at_vertices(*this);
    face_is_sheet.reserve(s.faces().size());
    for (const Face3& f : s.faces()) {
        const bool sheet = s[f.body].kind == SurfaceKind::sheet;
        face_is_sheet.push_back(static_cast<char>(sheet));
        has_sheets = has_sheets || sheet;
    }
    for (const Body3& b : s.bodies()) has_world = has_world || b.is_world;
}

}  // namespace sightline::detail
