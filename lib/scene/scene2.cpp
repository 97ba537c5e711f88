// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/scene2.hpp"

#include <fmt/format.h>

#include "scene/layout.hpp"

namespace sightline {
namespace {

using detail::ChainRecord;
using detail::SceneLayout;

/// The first point that is inside of B, as an error of `make`.
Result<void> check_points(const SceneLayout& layout,
                          const std::vector<detail::SweepInside>& inside) {
    for (const detail::SweepInside& found : inside) {
        const ChainRecord& chain = layout.chain_of_vertex(found.vertex);
        if (chain.kind != ChainRecord::Kind::point) continue;
        const std::string name = layout.origin(chain.element) + layout.name_of_vertex(found.vertex);
        if (found.owner == detail::world_solid) {
            return fail(Errc::outside_world,
                        name + ": the point lies outside of the world; move or remove it");
        }
        return fail(
            Errc::point_in_body,
            fmt::format("{}: the point lies inside body {}; move or remove it", name, found.owner));
    }
    return {};
}

}  // namespace

Result<Scene2> Scene2::make(const SceneInput2& input) {
    Result<SceneLayout> laid_out = detail::lay_out(input);
    if (!laid_out) return tl::unexpected(std::move(laid_out.error()));
    SceneLayout& layout = *laid_out;
    const detail::SweepResult sweep =
        detail::sweep_boundaries(layout.vertices, layout.edges, input.world, false);
    if (sweep.fault) return tl::unexpected(detail::describe_fault(layout, *sweep.fault));
    if (const auto ok = check_points(layout, sweep.inside); !ok) return tl::unexpected(ok.error());
    if (const auto ok = detail::check_walls(layout, sweep.inside); !ok)
        return tl::unexpected(ok.error());

    Scene2 scene;
    scene.body_count_ = layout.body_count;
    scene.has_world_ = input.world;
    for (const ChainRecord& chain : layout.chains) {
        if (chain.kind == ChainRecord::Kind::point)
            scene.points_.push_back(VertexId{chain.first_vertex});
        if (chain.kind != ChainRecord::Kind::outer && chain.kind != ChainRecord::Kind::hole)
            continue;
        const BodyId body =
            chain.owner == detail::world_solid ? BodyId::none() : BodyId{chain.owner};
        scene.rings_.push_back(
            {EdgeId{chain.first_edge}, chain.edge_count, body, chain.is_body_hole});
    }
    scene.vertices_ = std::move(layout.vertices);
    scene.edges_ = std::move(layout.edges);
    return scene;
}

Result<Scene2> Scene2::with_points(std::span<const Point2> added) const {
    Scene2 scene = *this;
    for (const Point2& p : added) {
        SceneInput2 alone;
        alone.elements.emplace_back(p);
        if (const auto checked = detail::lay_out(alone); !checked)
            return tl::unexpected(checked.error());
        scene.points_.push_back(VertexId{static_cast<std::uint32_t>(scene.vertices_.size())});
        scene.vertices_.push_back({p.x + 0.0, p.y + 0.0});
    }
    const detail::SweepResult sweep =
        detail::sweep_boundaries(scene.vertices_, scene.edges_, has_world_, false);
    for (const detail::SweepInside& found : sweep.inside) {
        if (found.vertex.index() < vertices_.size()) continue;
        const Point2& p = scene[found.vertex];
        if (found.owner == detail::world_solid) {
            return fail(Errc::outside_of_world,
                        fmt::format("point ({}, {}) lies outside of the world; choose one inside",
                                    p.x, p.y));
        }
        return fail(Errc::inside_body,
                    fmt::format("point ({}, {}) lies inside body {}; choose one outside", p.x, p.y,
                                found.owner));
    }
    return scene;
}

}  // namespace sightline
